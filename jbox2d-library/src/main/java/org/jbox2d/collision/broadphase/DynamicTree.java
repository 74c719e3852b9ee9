package org.jbox2d.collision.broadphase;

import org.jbox2d.callbacks.DebugDraw;
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

  /**
   * Builds the inner nodes anew, perfectly balanced; the proxies keep their ids. Worth its O(n log
   * n) after many proxies were created in an unlucky order. Not to be called from a callback of the
   * tree.
   */
  public void rebuildBottomUp() {
    nodes.rebuild();
  }

  @Override
  public void drawTree(DebugDraw draw) {
    nodes.drawTree(draw);
  }

  /**
   * Draws nodes that are objects; the tree itself holds none.
   *
   * @param node topmost node to draw
   * @param spot its depth
   * @param height number of levels over which the colour changes
   */
  public void drawTree(DebugDraw draw, DynamicTreeNode node, int spot, int height) {
    new TreeDrawing(draw, height).draw(node, spot);
  }
}
