package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.PairCallback;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;
import org.jbox2d.internal.IntArrayList;
import org.jbox2d.internal.PairSelection;

/**
 * A broad phase over any {@link BroadPhaseStrategy}: it remembers which proxies have moved and
 * looks for pairs of those alone. With the engine's own trees it works on their arrays; any other
 * strategy is asked through its interface.
 */
public class DefaultBroadPhaseBuffer implements TreeCallback, BroadPhase {
  private final BroadPhaseStrategy strategy;

  /** The flat tree behind the strategy; null for strategies not of our own. */
  private final FlatTreeSearch tree;

  private int proxyCount;

  /**
   * The proxies to look for pairs of, in the order they moved; NULL_PROXY for those destroyed
   * since.
   */
  private final IntArrayList moveBuffer = new IntArrayList();

  /** One plus the index in the move buffer for each proxy; 0 for a proxy not in it. */
  private int[] bufferSlot = new int[16];

  /** The categories that each proxy collides with. */
  private int[] mask = new int[16];

  /** Tight boxes: minX, minY, maxX, maxY of proxy i from index 4 i on. */
  private float[] tight = new float[64];

  /** What the current search of {@link #updatePairs} found. */
  private final IntArrayList found = new IntArrayList();

  /**
   * An empty broad phase.
   *
   * @param strategy an empty index, from now on used by this broad phase alone
   */
  public DefaultBroadPhaseBuffer(BroadPhaseStrategy strategy) {
    if (strategy == null) {
      throw new IllegalArgumentException("strategy must not be null");
    }
    this.strategy = strategy;
    tree = flatTreeOf(strategy);
  }

  private static FlatTreeSearch flatTreeOf(BroadPhaseStrategy strategy) {
    if (strategy instanceof DynamicTree) {
      return ((DynamicTree) strategy).nodes;
    }
    return strategy instanceof DynamicTreeFlatNodes ? (DynamicTreeFlatNodes) strategy : null;
  }

  @Override
  public final int createProxy(AABB aabb, Object userData) {
    int proxyId = strategy.createProxy(aabb, userData);
    proxyCount++;
    if (proxyId >= mask.length) {
      int capacity = Math.max(proxyId + 1, 2 * mask.length);
      tight = Arrays.copyOf(tight, 4 * capacity);
      mask = Arrays.copyOf(mask, capacity);
    }
    mask[proxyId] = -1;
    setTight(proxyId, aabb);
    bufferMove(proxyId);
    return proxyId;
  }

  @Override
  public final void destroyProxy(int proxyId) {
    strategy.destroyProxy(proxyId);
    proxyCount--;
    unbufferMove(proxyId);
  }

  @Override
  public final void moveProxy(int proxyId, AABB aabb, Vec2 displacement) {
    if (strategy.moveProxy(proxyId, aabb, displacement)) {
      bufferMove(proxyId);
    }
    setTight(proxyId, aabb);
  }

  private void setTight(int proxyId, AABB aabb) {
    int i = 4 * proxyId;
    tight[i] = aabb.lowerBound.x;
    tight[i + 1] = aabb.lowerBound.y;
    tight[i + 2] = aabb.upperBound.x;
    tight[i + 3] = aabb.upperBound.y;
  }

  @Override
  public void touchProxy(int proxyId) {
    // Asked for nothing but its refusal of an unknown id.
    strategy.getUserData(proxyId);
    bufferMove(proxyId);
  }

  @Override
  public Object getUserData(int proxyId) {
    return strategy.getUserData(proxyId);
  }

  @Override
  public AABB getFatAABB(int proxyId) {
    return strategy.getFatAABB(proxyId);
  }

  @Override
  public boolean testOverlap(int proxyIdA, int proxyIdB) {
    if (tree != null) {
      return tree.overlap(proxyIdA, proxyIdB);
    }
    return AABB.testOverlap(strategy.getFatAABB(proxyIdA), strategy.getFatAABB(proxyIdB));
  }

  @Override
  public boolean covers(int proxyId, AABB aabb) {
    return tree != null ? tree.covers(proxyId, aabb) : getFatAABB(proxyId).contains(aabb);
  }

  @Override
  public void setObstacle(int proxyId, boolean isObstacle) {
    if (tree != null) {
      // Asked for nothing but its refusal of an unknown id.
      strategy.getUserData(proxyId);
      tree.markObstacle(proxyId, isObstacle);
    }
  }

  @Override
  public void setFilter(int proxyId, int categories, int mask) {
    // Asked for nothing but its refusal of an unknown id.
    strategy.getUserData(proxyId);
    if (tree != null) {
      tree.markCategories(proxyId, categories);
      this.mask[proxyId] = mask;
    }
  }

  @Override
  public void queryObstacles(TreeCallback callback, AABB aabb) {
    if (tree != null) {
      tree.search(callback, aabb, FlatNodes.OBSTACLE);
    } else {
      strategy.query(callback, aabb);
    }
  }

  @Override
  public boolean testTightOverlap(int proxyIdA, int proxyIdB, float slack) {
    float[] box = tight;
    int i = 4 * proxyIdA;
    int j = 4 * proxyIdB;
    return box[i] <= box[j + 2] + slack
        && box[j] <= box[i + 2] + slack
        && box[i + 1] <= box[j + 3] + slack
        && box[j + 1] <= box[i + 3] + slack;
  }

  @Override
  public final int getProxyCount() {
    return proxyCount;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Where both proxies of a pair have moved, both searches find it; it is reported by that of
   * the lower id. The data of the lower id comes first.
   */
  @Override
  public final void updatePairs(PairCallback callback) {
    PairSelection selection = callback instanceof PairSelection ? (PairSelection) callback : null;
    boolean filtered = selection != null && selection.goesByCategories();
    for (int i = 0; i < moveBuffer.size(); i++) {
      int proxyId = moveBuffer.get(i);
      if (proxyId != NULL_PROXY) {
        findOverlaps(proxyId, filtered);
        reportPairs(proxyId, callback, selection);
      }
    }
    for (int i = 0; i < moveBuffer.size(); i++) {
      int proxyId = moveBuffer.get(i);
      if (proxyId != NULL_PROXY) {
        bufferSlot[proxyId] = 0;
      }
    }
    moveBuffer.clear();
  }

  private void findOverlaps(int proxyId, boolean filtered) {
    found.clear();
    if (tree != null) {
      long wanted = filtered ? mask[proxyId] & FlatNodes.CATEGORIES : FlatNodes.ANY;
      tree.collectOverlaps(proxyId, wanted, found);
    } else {
      strategy.query(this, strategy.getFatAABB(proxyId));
    }
  }

  private void reportPairs(int proxyId, PairCallback callback, PairSelection selection) {
    for (int i = 0; i < found.size(); i++) {
      int other = found.get(i);
      if (other == proxyId || (other < proxyId && isBuffered(other))) {
        continue;
      }
      int low = Math.min(proxyId, other);
      int high = Math.max(proxyId, other);
      if (selection == null || !selection.knows(low, high)) {
        callback.addPair(strategy.getUserData(low), strategy.getUserData(high));
      }
    }
  }

  /**
   * Part of the search for pairs with a strategy that is not of our own; not to be called by users.
   */
  @Override
  public final boolean treeCallback(int proxyId) {
    found.add(proxyId);
    return true;
  }

  private boolean isBuffered(int proxyId) {
    return proxyId < bufferSlot.length && bufferSlot[proxyId] != 0;
  }

  /** Has the next {@link #updatePairs} look for pairs of the proxy. */
  protected final void bufferMove(int proxyId) {
    if (proxyId < 0) {
      throw new IllegalArgumentException("no proxy has the id " + proxyId);
    }
    if (isBuffered(proxyId)) {
      return;
    }
    if (proxyId >= bufferSlot.length) {
      bufferSlot = Arrays.copyOf(bufferSlot, Math.max(proxyId + 1, 2 * bufferSlot.length));
    }
    moveBuffer.add(proxyId);
    bufferSlot[proxyId] = moveBuffer.size();
  }

  /** Undoes {@link #bufferMove}; the order of the others stays. */
  protected final void unbufferMove(int proxyId) {
    if (isBuffered(proxyId)) {
      moveBuffer.set(bufferSlot[proxyId] - 1, NULL_PROXY);
      bufferSlot[proxyId] = 0;
    }
  }

  @Override
  public final void query(TreeCallback callback, AABB aabb) {
    strategy.query(callback, aabb);
  }

  @Override
  public final void raycast(TreeRayCastCallback callback, RayCastInput input) {
    strategy.raycast(callback, input);
  }

  @Override
  public final int getTreeHeight() {
    return strategy.getHeight();
  }

  @Override
  public int getTreeBalance() {
    return strategy.getMaxBalance();
  }

  @Override
  public float getTreeQuality() {
    return strategy.getAreaRatio();
  }

  @Override
  public void drawTree(DebugDraw draw) {
    strategy.drawTree(draw);
  }
}
