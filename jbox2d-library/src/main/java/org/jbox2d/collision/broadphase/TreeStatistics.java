package org.jbox2d.collision.broadphase;

/**
 * Figures about a tree, and the check of its invariants. For tests and tuning: each looks at all
 * nodes.
 */
final class TreeStatistics {
  private TreeStatistics() {}

  /** The greatest number of links between a leaf and the root, counted from the links alone. */
  static int computeHeight(FlatTree tree) {
    int height = 0;
    for (int node = 0; node < tree.capacity(); node++) {
      if (tree.isFree(node) || !tree.isLeaf(node)) {
        continue;
      }
      int depth = 0;
      for (int above = tree.m_parent[node]; above != FlatNodes.NULL; above = tree.m_parent[above]) {
        depth++;
      }
      height = Math.max(height, depth);
    }
    return height;
  }

  static int maxBalance(FlatTree tree) {
    int balance = 0;
    for (int node = 0; node < tree.capacity(); node++) {
      if (!tree.isFree(node) && !tree.isLeaf(node)) {
        int difference = tree.m_height[tree.m_child1[node]] - tree.m_height[tree.m_child2[node]];
        balance = Math.max(balance, Math.abs(difference));
      }
    }
    return balance;
  }

  static float areaRatio(FlatTree tree) {
    if (tree.m_root == FlatNodes.NULL) {
      return 0;
    }
    double total = 0;
    for (int node = 0; node < tree.capacity(); node++) {
      if (!tree.isFree(node)) {
        total += tree.size(node);
      }
    }
    float outermost = tree.size(tree.m_root);
    return outermost > 0 ? (float) (total / outermost) : 0;
  }

  /**
   * Each node's links are mutual, its height and box follow from its children, and the counts
   * agree. As heights strictly rise from child to parent there is no cycle, so each node leads up
   * to the root.
   */
  static void validate(FlatTree tree) {
    int leaves = 0;
    int nodes = 0;
    for (int node = 0; node < tree.capacity(); node++) {
      if (tree.isFree(node)) {
        continue;
      }
      nodes++;
      checkParent(tree, node);
      if (tree.isLeaf(node)) {
        leaves++;
        check(tree.m_child2[node] == FlatNodes.NULL, node, "is a leaf with a second child");
        check(tree.m_height[node] == 0, node, "is a leaf of height other than 0");
        check(isOrdered(tree.bounds, 4 * node), node, "has an inverted or NaN box");
      } else {
        checkInner(tree, node);
      }
    }
    check(nodes == tree.nodeCount(), nodes, "is the number of nodes, but another was counted");
    check(leaves == tree.leafCount(), leaves, "is the number of leaves, but another was counted");
    check(nodes == Math.max(0, 2 * leaves - 1), nodes, "nodes are too many or too few");
  }

  private static void checkParent(FlatTree tree, int node) {
    int parent = tree.m_parent[node];
    if (parent == FlatNodes.NULL) {
      check(node == tree.m_root, node, "has no parent and is not the root");
    } else {
      check(!tree.isFree(parent), node, "has a free parent");
      boolean isChild = tree.m_child1[parent] == node || tree.m_child2[parent] == node;
      check(isChild, node, "is no child of its parent");
    }
  }

  private static void checkInner(FlatTree tree, int node) {
    int child1 = tree.m_child1[node];
    int child2 = tree.m_child2[node];
    check(child1 != child2 && child2 != FlatNodes.NULL, node, "has not two children");
    check(tree.m_parent[child1] == node, node, "is not the parent of its first child");
    check(tree.m_parent[child2] == node, node, "is not the parent of its second child");
    check(tree.m_userData[node] == null, node, "is an inner node with user data");
    int height = 1 + Math.max(tree.m_height[child1], tree.m_height[child2]);
    check(tree.m_height[node] == height, node, "has a wrong height");
    int difference = Math.abs(tree.m_height[child1] - tree.m_height[child2]);
    check(difference <= FlatTree.SLACK, node, "has children of too different heights");
    long traits = tree.traits[child1] | tree.traits[child2];
    check(tree.traits[node] == traits, node, "does not have the traits of its children");
    float[] box = tree.bounds;
    for (int k = 0; k < 4; k++) {
      float a = box[4 * child1 + k];
      float b = box[4 * child2 + k];
      float expected = k < 2 ? Math.min(a, b) : Math.max(a, b);
      check(box[4 * node + k] == expected, node, "has not the box of its children");
    }
  }

  private static boolean isOrdered(float[] box, int i) {
    return box[i] <= box[i + 2] && box[i + 1] <= box[i + 3];
  }

  private static void check(boolean holds, int node, String otherwise) {
    if (!holds) {
      throw new IllegalStateException("node " + node + " " + otherwise);
    }
  }
}
