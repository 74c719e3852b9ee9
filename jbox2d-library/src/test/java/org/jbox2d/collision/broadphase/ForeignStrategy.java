package org.jbox2d.collision.broadphase;

import java.util.Map;
import java.util.TreeMap;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;

/**
 * A strategy as a user may write one: a list of tight boxes, searched by brute force, with ids of
 * its own choice.
 */
final class ForeignStrategy implements BroadPhaseStrategy {
  private final Map<Integer, AABB> boxes = new TreeMap<>();
  private final Map<Integer, Object> userData = new TreeMap<>();
  private int nextId = 100;
  private int insertions;

  @Override
  public int createProxy(AABB aabb, Object data) {
    int id = nextId;
    nextId += 7;
    boxes.put(id, new AABB(aabb));
    userData.put(id, data);
    insertions++;
    return id;
  }

  @Override
  public void destroyProxy(int proxyId) {
    boxes.remove(proxyId);
    userData.remove(proxyId);
  }

  @Override
  public boolean moveProxy(int proxyId, AABB aabb, Vec2 displacement) {
    boxes.put(proxyId, new AABB(aabb));
    insertions++;
    return true;
  }

  @Override
  public Object getUserData(int proxyId) {
    return userData.get(proxyId);
  }

  @Override
  public AABB getFatAABB(int proxyId) {
    return boxes.get(proxyId);
  }

  @Override
  public void query(TreeCallback callback, AABB aabb) {
    for (Map.Entry<Integer, AABB> entry : boxes.entrySet()) {
      if (AABB.testOverlap(entry.getValue(), aabb) && !callback.treeCallback(entry.getKey())) {
        return;
      }
    }
  }

  @Override
  public void raycast(TreeRayCastCallback callback, RayCastInput input) {
    throw new UnsupportedOperationException();
  }

  @Override
  public int computeHeight() {
    return 0;
  }

  @Override
  public int getHeight() {
    return 0;
  }

  @Override
  public int getMaxBalance() {
    return 0;
  }

  @Override
  public float getAreaRatio() {
    return 0;
  }

  @Override
  public int getInsertionCount() {
    return insertions;
  }

  @Override
  public void drawTree(DebugDraw draw) {
    throw new UnsupportedOperationException();
  }
}
