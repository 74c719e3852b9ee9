package org.jbox2d.collision.broadphase;

/**
 * Insertion and removal of leaves such that the tree stays cheap to search.
 *
 * <p>Cost model: the expected number of nodes that a query visits is proportional to the summed
 * sizes of the inner nodes. Each insertion looks for the place that adds least to that sum, and on
 * its way back up exchanges subtrees where this lowers it (Catto, "Dynamic bounding volume
 * hierarchies", GDC 2019; Goldsmith and Salmon 1987).
 *
 * <p>Invariant: the heights of two siblings differ by at most {@link #SLACK}. The fewest leaves of
 * a tree of height h are then N(h) = N(h-1) + N(h-1-SLACK), which grows by a factor of 1.28 a level
 * for SLACK = 5: the height is at most 2.8 log2 n or so, whatever the order of calls. What keeps
 * it:
 *
 * <ul>
 *   <li>A leaf becomes sibling of a node of height at most SLACK.
 *   <li>Each insertion or removal changes the height of a subtree by at most one. Where a node B
 *       thereby gets SLACK + 1 higher than its sibling C, the higher child D of B changes places
 *       with C. With h = height of C and D of height h + SLACK, the other child E has a height from
 *       h to h + SLACK, so the new pair (C, E) keeps the invariant; its height is from h + 1 to h +
 *       SLACK + 1, so it keeps the invariant beside D too. The height above sinks by at most one.
 *   <li>An exchange for size is made only where the invariant holds after it and the height does
 *       not grow.
 * </ul>
 */
abstract class FlatTree extends FlatNodes {
  /**
   * Greatest difference of height of two siblings. 1 would be an AVL tree; more leaves freedom to
   * keep a large box, such as the ground, high up beside many small ones. Measured with 2,000 boxes
   * moving on a ground: at 5 a query takes 0.6 of the time that it takes at 1, and without a bound
   * it takes no less.
   */
  static final int SLACK = 5;

  private int leafCount;
  private int insertions;

  final int leafCount() {
    return leafCount;
  }

  final int insertions() {
    return insertions;
  }

  /** Hangs a leaf, whose box is set, into the tree. */
  final void insertLeaf(int leaf) {
    leafCount++;
    insertions++;
    if (m_root == NULL) {
      m_root = leaf;
      m_parent[leaf] = NULL;
      return;
    }
    int sibling = findSibling(leaf);
    int inner = allocate();
    replaceChild(m_parent[sibling], sibling, inner);
    m_child1[inner] = sibling;
    m_child2[inner] = leaf;
    m_parent[sibling] = inner;
    m_parent[leaf] = inner;
    for (int node = inner; node != NULL; node = m_parent[node]) {
      refit(node);
      if (!exchangeForHeight(node)) {
        exchangeForSize(node);
      }
    }
  }

  /**
   * Adapts the tree to a leaf whose box has been set anew, near the old one: the boxes above it are
   * refitted, and subtrees exchanged where that lowers the cost, which takes the leaf along where
   * it goes (Kopta, Ize, Spjut, Brunvand, Davis, Kensler, "Fast, effective BVH updates for animated
   * scenes", I3D 2012). It costs a part of the way up instead of three ways through the tree.
   */
  final void moveLeaf(int leaf) {
    insertions++;
    boolean changed = true;
    for (int node = m_parent[leaf]; node != NULL && changed; node = m_parent[node]) {
      int height = m_height[node];
      changed = refit(node);
      if (!exchangeForHeight(node)) {
        exchangeForSize(node);
      }
      changed |= m_height[node] != height;
    }
  }

  /** Sets whether a leaf is an obstacle. */
  final void markObstacle(int leaf, boolean isObstacle) {
    mark(leaf, isObstacle ? traits[leaf] | OBSTACLE : traits[leaf] & ~OBSTACLE);
  }

  /** Sets the categories of a leaf. */
  final void markCategories(int leaf, int categories) {
    mark(leaf, traits[leaf] & ~CATEGORIES | categories & CATEGORIES);
  }

  private void mark(int leaf, long marks) {
    boolean changed = traits[leaf] != marks;
    traits[leaf] = marks;
    for (int node = m_parent[leaf]; node != NULL && changed; node = m_parent[node]) {
      changed = refit(node);
    }
  }

  /** Takes a leaf out of the tree; the node itself stays allocated and keeps its box. */
  final void removeLeaf(int leaf) {
    leafCount--;
    int inner = m_parent[leaf];
    if (inner == NULL) {
      m_root = NULL;
      return;
    }
    int sibling = m_child1[inner] == leaf ? m_child2[inner] : m_child1[inner];
    int above = m_parent[inner];
    replaceChild(above, inner, sibling);
    release(inner);
    m_parent[leaf] = NULL;
    boolean changed = true;
    for (int node = above; node != NULL && changed; node = m_parent[node]) {
      changed = refit(node);
      changed |= exchangeForHeight(node);
    }
  }

  /**
   * The node that becomes the new leaf's sibling.
   *
   * <p>Pairing the leaf L with a node N adds a new inner node of size |N u L| and makes each
   * ancestor A of N grow by |A u L| - |A|. Anywhere below N the new inner node is at least as large
   * as |L|, and N itself has grown too: if even that bound is no better than the best place seen,
   * the descent ends. It follows the child of the lower bound alone (greedy), which takes
   * O(height); a child that already contains the leaf adds nothing, so among two of them the nearer
   * centre decides. Nodes higher than {@link #SLACK} are no candidates.
   */
  private int findSibling(int leaf) {
    float leafSize = size(leaf);
    int node = m_root;
    float union = unionSize(node, leaf);
    int best = node;
    float bestCost = m_height[node] <= SLACK ? union : Float.POSITIVE_INFINITY;
    float inherited = 0;
    while (!isLeaf(node)) {
      inherited += union - size(node);
      int child1 = m_child1[node];
      int child2 = m_child2[node];
      float union1 = unionSize(child1, leaf);
      float union2 = unionSize(child2, leaf);
      if (inherited + union1 < bestCost && m_height[child1] <= SLACK) {
        bestCost = inherited + union1;
        best = child1;
      }
      if (inherited + union2 < bestCost && m_height[child2] <= SLACK) {
        bestCost = inherited + union2;
        best = child2;
      }
      float growth1 = isLeaf(child1) ? Float.POSITIVE_INFINITY : union1 - size(child1);
      float growth2 = isLeaf(child2) ? Float.POSITIVE_INFINITY : union2 - size(child2);
      boolean first = growth1 < growth2 || (growth1 == growth2 && isNearer(leaf, child1, child2));
      float bound = inherited + leafSize + (first ? growth1 : growth2);
      if (bound >= bestCost && m_height[best] <= SLACK) {
        break;
      }
      node = first ? child1 : child2;
      union = first ? union1 : union2;
    }
    // Where sizes overflow no cost is finite, and the descent has led to some leaf.
    return m_height[best] <= SLACK ? best : node;
  }

  /**
   * Whether the centre of node a is at most as far (in the 1-norm) from the leaf's centre as that
   * of node b.
   */
  private boolean isNearer(int leaf, int a, int b) {
    return centreDistance(leaf, a) <= centreDistance(leaf, b);
  }

  /** Twice the 1-norm distance of two boxes' centres. */
  private float centreDistance(int a, int b) {
    float[] box = bounds;
    int i = 4 * a;
    int j = 4 * b;
    float dx = (box[i] + box[i + 2]) - (box[j] + box[j + 2]);
    float dy = (box[i + 1] + box[i + 3]) - (box[j + 1] + box[j + 3]);
    return Math.abs(dx) + Math.abs(dy);
  }

  /**
   * Exchanges a child of {@code node} with a grandchild on the other side, if that makes the tree
   * cheaper. The box of the node itself stays; only that of the child which changes a member
   * differs:
   *
   * <pre>
   *        A                 A
   *       / \               / \
   *      B   C     -->     D   B      gain = |B| - |C u E|
   *     / \                   / \
   *    D   E                 C   E
   * </pre>
   *
   * <p>B is the larger child: C u E is no smaller than C.
   */
  private void exchangeForSize(int node) {
    float size1 = size(m_child1[node]);
    float size2 = size(m_child2[node]);
    int b = size1 > size2 ? m_child1[node] : m_child2[node];
    int c = size1 > size2 ? m_child2[node] : m_child1[node];
    if (isLeaf(b)) {
      return;
    }
    int d = m_child1[b];
    int e = m_child2[b];
    float size = Math.max(size1, size2);
    float gainOfD = size - unionSize(c, e);
    float gainOfE = size - unionSize(c, d);
    if (gainOfD <= 0 & gainOfE <= 0) {
      return;
    }
    int height = m_height[node];
    float best = 0;
    int rising = NULL;
    if (gainOfD > best && keepsBalance(d, c, e, height)) {
      best = gainOfD;
      rising = d;
    }
    if (gainOfE > best && keepsBalance(e, c, d, height)) {
      rising = e;
    }
    if (rising != NULL) {
      exchange(node, b, rising);
    }
  }

  /**
   * Exchanges {@code rising}, a child of {@code inner}, with the sibling of {@code inner} below
   * {@code node}.
   */
  private void exchange(int node, int inner, int rising) {
    int sinking = m_child1[node] == inner ? m_child2[node] : m_child1[node];
    replaceChild(node, sinking, rising);
    replaceChild(inner, rising, sinking);
    refit(inner);
    refit(node);
  }

  /**
   * Whether node ((rising), (sinking, staying)) keeps the invariant and is no higher than before.
   */
  private boolean keepsBalance(int rising, int sinking, int staying, int height) {
    int inner = 1 + Math.max(m_height[sinking], m_height[staying]);
    return Math.abs(m_height[sinking] - m_height[staying]) <= SLACK
        && Math.abs(m_height[rising] - inner) <= SLACK
        && Math.max(m_height[rising], inner) < height;
  }

  /**
   * Restores the invariant at a node whose children both keep it; returns whether that took an
   * exchange.
   */
  private boolean exchangeForHeight(int node) {
    int difference = m_height[m_child1[node]] - m_height[m_child2[node]];
    if (Math.abs(difference) <= SLACK) {
      return false;
    }
    int inner = difference > 0 ? m_child1[node] : m_child2[node];
    int child1 = m_child1[inner];
    int child2 = m_child2[inner];
    exchange(node, inner, m_height[child1] >= m_height[child2] ? child1 : child2);
    return true;
  }
}
