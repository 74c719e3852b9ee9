package org.jbox2d.collision.broadphase;

import org.jbox2d.collision.AABB;

/**
 * A node of a tree of boxes as an object. The engine's trees are flat arrays and hold no such
 * nodes; the type is kept for source compatibility.
 */
public class DynamicTreeNode {
  /** The enlarged box. */
  public final AABB aabb = new AABB();

  /** What a leaf was created with. */
  public Object userData;

  protected DynamicTreeNode parent;
  protected DynamicTreeNode child1;
  protected DynamicTreeNode child2;
  protected final int id;
  protected int height;

  /** Whether the node is a leaf. */
  protected boolean leaf;

  protected DynamicTreeNode(int id) {
    this.id = id;
  }

  public final boolean isLeaf() {
    return child1 == null;
  }

  public Object getUserData() {
    return userData;
  }

  public void setUserData(Object userData) {
    this.userData = userData;
  }
}
