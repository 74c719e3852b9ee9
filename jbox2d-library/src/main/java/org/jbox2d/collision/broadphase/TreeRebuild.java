package org.jbox2d.collision.broadphase;

/**
 * Builds the inner nodes of a tree anew, top down: the leaves are halved at the median of their
 * centres along the longer side of the centres' box, again and again. O(n log n) expected; the
 * result is as balanced as can be.
 */
final class TreeRebuild {
  private final FlatTree tree;
  private final int[] leaves;

  private TreeRebuild(FlatTree tree) {
    this.tree = tree;
    leaves = new int[tree.leafCount()];
  }

  static void rebuild(FlatTree tree) {
    if (tree.m_root != FlatNodes.NULL) {
      TreeRebuild rebuild = new TreeRebuild(tree);
      rebuild.takeApart();
      tree.m_root = rebuild.build(0, rebuild.leaves.length);
      tree.m_parent[tree.m_root] = FlatNodes.NULL;
    }
  }

  /** Collects the leaves in ascending order and frees all other nodes. */
  private void takeApart() {
    int count = 0;
    for (int node = 0; node < tree.capacity(); node++) {
      if (tree.isFree(node)) {
        continue;
      }
      if (tree.isLeaf(node)) {
        leaves[count++] = node;
      } else {
        tree.release(node);
      }
    }
  }

  /**
   * Builds a subtree of the leaves from index {@code from} to before {@code to}; returns its
   * topmost node.
   */
  private int build(int from, int to) {
    if (to - from == 1) {
      return leaves[from];
    }
    int middle = (from + to) >>> 1;
    select(from, to, middle, longerAxis(from, to));
    int child1 = build(from, middle);
    int child2 = build(middle, to);
    int inner = tree.allocate();
    tree.m_child1[inner] = child1;
    tree.m_child2[inner] = child2;
    tree.m_parent[child1] = inner;
    tree.m_parent[child2] = inner;
    tree.refit(inner);
    return inner;
  }

  private int longerAxis(int from, int to) {
    return spread(from, to, 0) >= spread(from, to, 1) ? 0 : 1;
  }

  private float spread(int from, int to, int axis) {
    float min = centre(leaves[from], axis);
    float max = min;
    for (int i = from + 1; i < to; i++) {
      float centre = centre(leaves[i], axis);
      min = Math.min(min, centre);
      max = Math.max(max, centre);
    }
    return max - min;
  }

  /** A coordinate of a box's centre; halved before the sum, which cannot overflow then. */
  private float centre(int leaf, int axis) {
    return 0.5f * tree.bounds[4 * leaf + axis] + 0.5f * tree.bounds[4 * leaf + 2 + axis];
  }

  /**
   * Permutes a range such that no leaf before index k comes after one from k on (Hoare 1961,
   * "Find").
   */
  private void select(int from, int to, int k, int axis) {
    int low = from;
    int high = to - 1;
    while (low < high) {
      int pivot = leaves[(low + high) >>> 1];
      int i = low;
      int j = high;
      while (i <= j) {
        while (precedes(leaves[i], pivot, axis)) {
          i++;
        }
        while (precedes(pivot, leaves[j], axis)) {
          j--;
        }
        if (i <= j) {
          int leaf = leaves[i];
          leaves[i++] = leaves[j];
          leaves[j--] = leaf;
        }
      }
      if (k <= j) {
        high = j;
      } else if (k >= i) {
        low = i;
      } else {
        return;
      }
    }
  }

  /** A total order: by centre, then by id. */
  private boolean precedes(int a, int b, int axis) {
    float centreA = centre(a, axis);
    float centreB = centre(b, axis);
    return centreA < centreB || (centreA == centreB && a < b);
  }
}
