package org.jbox2d.collision.broadphase;

import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Color3f;
import org.jbox2d.common.Vec2;

/** Outlines of a tree's boxes, the paler the deeper the node. */
final class TreeDrawing {
  private final DebugDraw draw;
  private final int levels;
  private final Vec2[] corners = {new Vec2(), new Vec2(), new Vec2(), new Vec2()};
  private final AABB box = new AABB();
  private final Color3f color = new Color3f();

  /**
   * @param levels number of levels over which the colour changes, 0 or more
   */
  TreeDrawing(DebugDraw draw, int levels) {
    this.draw = draw;
    this.levels = Math.max(1, levels);
  }

  /** Draws a node, which lies {@code depth} links below the topmost one drawn, and all below it. */
  void draw(FlatTree tree, int node, int depth) {
    float[] bounds = tree.bounds;
    int i = 4 * node;
    box.lowerBound.set(bounds[i], bounds[i + 1]);
    box.upperBound.set(bounds[i + 2], bounds[i + 3]);
    draw(box, depth);
    if (!tree.isLeaf(node)) {
      draw(tree, tree.m_child1[node], depth + 1);
      draw(tree, tree.m_child2[node], depth + 1);
    }
  }

  /** As {@link #draw(FlatTree, int, int)}, for nodes that are objects. */
  void draw(DynamicTreeNode node, int depth) {
    draw(node.aabb, depth);
    if (node.child1 != null) {
      draw(node.child1, depth + 1);
    }
    if (node.child2 != null) {
      draw(node.child2, depth + 1);
    }
  }

  private void draw(AABB aabb, int depth) {
    float pale = Math.min(1, (float) depth / levels);
    color.set(1, 0.25f + 0.5f * pale, 0.75f * pale);
    aabb.getVertices(corners);
    draw.drawPolygon(corners, 4, color);
  }
}
