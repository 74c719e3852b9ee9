package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * The engine's index of proxies: a binary tree of boxes over flat arrays, built and kept by the
 * surface area heuristic.
 *
 * <p>A proxy's enlarged box is its tight box grown on all sides by an eighth of its size (width
 * plus height), but by no more than {@link Settings#aabbExtension} (metres), and stretched along
 * its motion by {@link Settings#aabbMultiplier} displacements, but by no more than half its size.
 * Only a proxy that leaves its enlarged box, or whose enlarged box has become much too large, is
 * given a new one; if that lies apart from the old one, it is inserted anew. Ids of proxies are
 * indices of nodes.
 *
 * <p>Not safe for use by several threads at once. Callbacks may search the tree, but not change it.
 */
public class DynamicTreeFlatNodes extends FlatTreeSearch implements BroadPhaseStrategy {
  /** The id that no node has. */
  public static final int NULL_NODE = NULL;

  /** Kept for source compatibility: the tree's stack grows as needed. */
  public static final int MAX_STACK_SIZE = 64;

  /** Kept for source compatibility. */
  public static final int INITIAL_BUFFER_LENGTH = 16;

  /**
   * How many times the size that an enlarged box would get now it may have before it is shrunk
   * though it still contains the proxy: above 1, or a body slowing down would be inserted anew in
   * each step; not much above, or a body that came to rest after a fast flight would collect pairs
   * all along its way.
   */
  private static final float OVERSIZE = 2;

  /**
   * Greatest margin of a box, as a share of its width plus height. A margin of the same length for
   * all would give each body of a pile of splinters, smaller than the margin, contacts with dozens
   * of others that it does not touch. An eighth is a quarter of a square's side (Box2D 3.2 bounds
   * its margin in this way too).
   */
  private static final float MARGIN_SHARE = 0.125f;

  /**
   * Greatest stretch of a box along a motion, as a share of its width plus height. What is thrown
   * about in a crowd would otherwise get pairs with dozens of others that it never meets: in a
   * crowd of 6,000 bodies stirred by a beam a step takes a quarter less time than without a bound.
   */
  private static final float STRETCH_SHARE = 0.5f;

  /**
   * The boxes last handed out by {@link #getFatAABB}, indexed by proxy; empty until that is first
   * asked. The tree itself works on a float array and neither reads nor updates these.
   */
  public AABB[] m_aabb = {};

  /** An empty tree. */
  public DynamicTreeFlatNodes() {}

  @Override
  public final int createProxy(AABB aabb, Object userData) {
    checkBox(aabb);
    int proxyId = allocate();
    m_userData[proxyId] = userData;
    setEnlarged(proxyId, aabb, 0, 0);
    insertLeaf(proxyId);
    return proxyId;
  }

  @Override
  public final void destroyProxy(int proxyId) {
    checkProxy(proxyId);
    removeLeaf(proxyId);
    release(proxyId);
  }

  @Override
  public final boolean moveProxy(int proxyId, AABB aabb, Vec2 displacement) {
    checkProxy(proxyId);
    if (fits(proxyId, aabb, displacement)) {
      return false;
    }
    checkBox(aabb);
    if (!isFinite(Settings.aabbMultiplier * displacement.x)
        || !isFinite(Settings.aabbMultiplier * displacement.y)) {
      throw new IllegalArgumentException("displacement must be finite: " + displacement);
    }
    if (overlaps(proxyId, aabb)) {
      setEnlarged(proxyId, aabb, displacement.x, displacement.y);
      moveLeaf(proxyId);
    } else {
      removeLeaf(proxyId);
      setEnlarged(proxyId, aabb, displacement.x, displacement.y);
      insertLeaf(proxyId);
    }
    return true;
  }

  /**
   * Whether the enlarged box still holds the tight one and is not much larger than a new one would
   * be; false for NaN.
   */
  private boolean fits(int proxyId, AABB aabb, Vec2 displacement) {
    Vec2 lower = aabb.lowerBound;
    Vec2 upper = aabb.upperBound;
    float[] box = bounds;
    int i = 4 * proxyId;
    boolean inside =
        box[i] <= lower.x
            && box[i + 1] <= lower.y
            && upper.x <= box[i + 2]
            && upper.y <= box[i + 3]
            && lower.x <= upper.x
            && lower.y <= upper.y;
    if (!inside) {
      return false;
    }
    float tightSize = (upper.x - lower.x) + (upper.y - lower.y);
    float stretch =
        Math.abs(stretch(displacement.x, tightSize)) + Math.abs(stretch(displacement.y, tightSize));
    float newSize = tightSize + 4 * margin(tightSize) + stretch;
    return size(proxyId) <= OVERSIZE * newSize;
  }

  private static float margin(float size) {
    return Math.min(Settings.aabbExtension, MARGIN_SHARE * size);
  }

  /** How far a box of a size is stretched along a component of its displacement. */
  private static float stretch(float displacement, float size) {
    float most = STRETCH_SHARE * size;
    return Math.max(-most, Math.min(Settings.aabbMultiplier * displacement, most));
  }

  private void setEnlarged(int proxyId, AABB aabb, float displacementX, float displacementY) {
    Vec2 lower = aabb.lowerBound;
    Vec2 upper = aabb.upperBound;
    float size = (upper.x - lower.x) + (upper.y - lower.y);
    float margin = margin(size);
    float predictedX = stretch(displacementX, size);
    float predictedY = stretch(displacementY, size);
    float minX = lower.x - margin + Math.min(predictedX, 0);
    float minY = lower.y - margin + Math.min(predictedY, 0);
    float maxX = upper.x + margin + Math.max(predictedX, 0);
    float maxY = upper.y + margin + Math.max(predictedY, 0);
    setBounds(
        proxyId,
        Math.max(minX, -Float.MAX_VALUE),
        Math.max(minY, -Float.MAX_VALUE),
        Math.min(maxX, Float.MAX_VALUE),
        Math.min(maxY, Float.MAX_VALUE));
  }

  private void checkProxy(int proxyId) {
    // Leaves alone have this height, and it is all that needs to be read.
    if (proxyId < 0 || proxyId >= capacity() || m_height[proxyId] != 0) {
      throw new IllegalArgumentException("no proxy has the id " + proxyId);
    }
  }

  private static void checkBox(AABB aabb) {
    Vec2 lower = aabb.lowerBound;
    Vec2 upper = aabb.upperBound;
    boolean ordered = lower.x <= upper.x && lower.y <= upper.y;
    if (!ordered
        || !isFinite(lower.x)
        || !isFinite(lower.y)
        || !isFinite(upper.x)
        || !isFinite(upper.y)) {
      throw new IllegalArgumentException(
          "box must be finite, its lower bound not above its upper: " + lower + ", " + upper);
    }
  }

  private static boolean isFinite(float value) {
    return Math.abs(value) <= Float.MAX_VALUE;
  }

  @Override
  public final Object getUserData(int proxyId) {
    checkProxy(proxyId);
    return m_userData[proxyId];
  }

  @Override
  public final AABB getFatAABB(int proxyId) {
    checkProxy(proxyId);
    return box(proxyId);
  }

  /** The box of any node, written into that node's entry of {@link #m_aabb}. */
  private AABB box(int node) {
    int held = m_aabb.length;
    if (held < capacity()) {
      m_aabb = Arrays.copyOf(m_aabb, capacity());
      for (int i = held; i < m_aabb.length; i++) {
        m_aabb[i] = new AABB();
      }
    }
    AABB aabb = m_aabb[node];
    int i = 4 * node;
    aabb.lowerBound.set(bounds[i], bounds[i + 1]);
    aabb.upperBound.set(bounds[i + 2], bounds[i + 3]);
    return aabb;
  }

  /**
   * {@inheritDoc}
   *
   * @param aabb may be infinite; NaN is refused
   */
  @Override
  public final void query(TreeCallback callback, AABB aabb) {
    search(callback, aabb, ANY);
  }

  /**
   * {@inheritDoc}
   *
   * @param input finite; copied, so that the callback may reuse it. A ray of length 0 is a point
   */
  @Override
  public void raycast(TreeRayCastCallback callback, RayCastInput input) {
    boolean finite =
        isFinite(input.p1.x)
            && isFinite(input.p1.y)
            && isFinite(input.p2.x)
            && isFinite(input.p2.y)
            && isFinite(input.maxFraction);
    if (!finite) {
      throw new IllegalArgumentException(
          "ray must be finite: " + input.p1 + ", " + input.p2 + ", " + input.maxFraction);
    }
    searchRay(callback, input);
  }

  @Override
  public final int computeHeight() {
    return TreeStatistics.computeHeight(this);
  }

  @Override
  public int getHeight() {
    return m_root == NULL ? 0 : m_height[m_root];
  }

  @Override
  public int getMaxBalance() {
    return TreeStatistics.maxBalance(this);
  }

  @Override
  public float getAreaRatio() {
    return TreeStatistics.areaRatio(this);
  }

  @Override
  public int getInsertionCount() {
    return insertions();
  }

  /**
   * Checks the tree's structure, heights and boxes.
   *
   * @throws IllegalStateException if something does not hold, naming the node
   */
  public void validate() {
    TreeStatistics.validate(this);
  }

  /** As {@link DynamicTree#rebuildBottomUp}. */
  final void rebuild() {
    TreeRebuild.rebuild(this);
  }

  @Override
  public void drawTree(DebugDraw draw) {
    if (m_root != NULL) {
      drawTree(draw, m_root, 0, getHeight());
    }
  }

  /**
   * Draws a part of the tree.
   *
   * @param node topmost node to draw
   * @param spot its depth
   * @param height number of levels over which the colour changes
   */
  public void drawTree(DebugDraw draw, int node, int spot, int height) {
    if (node < 0 || node >= capacity() || isFree(node)) {
      throw new IllegalArgumentException("no node has the id " + node);
    }
    new TreeDrawing(draw, height).draw(this, node, spot);
  }
}
