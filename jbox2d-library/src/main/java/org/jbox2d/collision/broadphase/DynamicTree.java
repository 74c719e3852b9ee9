package org.jbox2d.collision.broadphase;

import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.common.Vec2;

/**
 * The engine's index of proxies under its older name; the work is done by {@link
 * DynamicTreeFlatNodes}.
 */
public class DynamicTree implements BroadPhaseStrategy {
  /** The id that no node has. */
  public static final int NULL_NODE = DynamicTreeFlatNodes.NULL_NODE;

  /** Kept for source compatibility: the tree's stack grows as needed. */
  public static final int MAX_STACK_SIZE = DynamicTreeFlatNodes.MAX_STACK_SIZE;

  final DynamicTreeFlatNodes nodes = new DynamicTreeFlatNodes();

  /** An empty tree. */
  public DynamicTree() {}

  @Override
  public final int createProxy(AABB aabb, Object userData) {
    return nodes.createProxy(aabb, userData);
  }

  @Override
  public final void destroyProxy(int proxyId) {
    nodes.destroyProxy(proxyId);
  }

  @Override
  public final boolean moveProxy(int proxyId, AABB aabb, Vec2 displacement) {
    return nodes.moveProxy(proxyId, aabb, displacement);
  }

  @Override
  public final Object getUserData(int proxyId) {
    return nodes.getUserData(proxyId);
  }

  @Override
  public final AABB getFatAABB(int proxyId) {
    return nodes.getFatAABB(proxyId);
  }

  @Override
  public final void query(TreeCallback callback, AABB aabb) {
    nodes.query(callback, aabb);
  }

  @Override
  public void raycast(TreeRayCastCallback callback, RayCastInput input) {
    nodes.raycast(callback, input);
  }

  @Override
  public final int computeHeight() {
    return nodes.computeHeight();
  }

  @Override
  public int getHeight() {
    return nodes.getHeight();
  }

  @Override
  public int getMaxBalance() {
    return nodes.getMaxBalance();
  }

  @Override
  public float getAreaRatio() {
    return nodes.getAreaRatio();
  }

  @Override
  public int getInsertionCount() {
    return nodes.getInsertionCount();
  }

  /** As {@link DynamicTreeFlatNodes#validate}. */
  public void validate() {
    nodes.validate();
  }
}
