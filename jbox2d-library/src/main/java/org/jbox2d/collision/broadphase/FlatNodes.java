package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.collision.AABB;

/**
 * The nodes of a binary tree of boxes, as parallel arrays indexed by node: storage, free list and
 * box arithmetic.
 *
 * <p>All boxes lie in one float array, four to a node (minX, minY, maxX, maxY), so that testing a
 * node against a box costs one cache line and no pointer. The size of a box is half its perimeter,
 * the two-dimensional counterpart of the surface area: the chance that a random line that meets an
 * outer box meets an inner one is the ratio of their perimeters (Goldsmith and Salmon 1987,
 * "Automatic creation of object hierarchies for ray tracing").
 */
abstract class FlatNodes {
  static final int NULL = -1;

  /** Height of a node that is on the free list; a leaf has height 0. */
  private static final int FREE_HEIGHT = -1;

  private static final int INITIAL_CAPACITY = 16;

  /** The root, or -1 if the tree is empty. To be read only. */
  public int m_root = NULL;

  /**
   * What each leaf was created with; null for inner nodes. To be read only, and anew after each
   * creation of a proxy.
   */
  public Object[] m_userData = new Object[INITIAL_CAPACITY];

  /** Parent of each node, -1 for the root; for a free node the next free one. */
  protected int[] m_parent = new int[INITIAL_CAPACITY];

  /** First child of each node, -1 for a leaf. */
  protected int[] m_child1 = new int[INITIAL_CAPACITY];

  /** Second child of each node, -1 for a leaf. */
  protected int[] m_child2 = new int[INITIAL_CAPACITY];

  /** Height of each node above its deepest leaf: 0 for a leaf. */
  protected int[] m_height = new int[INITIAL_CAPACITY];

  /** Trait of all nodes: a search that wants it leaves none out. */
  static final long ANY = 1L << 32;

  /** Trait of an obstacle. */
  static final long OBSTACLE = 1L << 33;

  /** Traits of a collision category each. */
  static final long CATEGORIES = ANY - 1;

  /**
   * What a leaf is, as bits, and what an inner node has below it. A search for what has one of
   * certain traits leaves out whole subtrees of what has none of them: of what only moves, say, or
   * of categories that do not matter.
   */
  long[] traits = new long[INITIAL_CAPACITY];

  /** Boxes: minX, minY, maxX, maxY of node i from index 4 i on. */
  float[] bounds = new float[4 * INITIAL_CAPACITY];

  private int freeHead;
  private int nodeCount;

  FlatNodes() {
    linkFree(0);
  }

  final int capacity() {
    return m_parent.length;
  }

  final int nodeCount() {
    return nodeCount;
  }

  final boolean isFree(int node) {
    return m_height[node] == FREE_HEIGHT;
  }

  final boolean isLeaf(int node) {
    return m_child1[node] == NULL;
  }

  /** Takes a node from the free list: no parent, no children, height 0, a stale box. */
  final int allocate() {
    if (freeHead == NULL) {
      grow();
    }
    int node = freeHead;
    freeHead = m_parent[node];
    m_parent[node] = NULL;
    m_child1[node] = NULL;
    m_child2[node] = NULL;
    m_height[node] = 0;
    traits[node] = ANY | CATEGORIES;
    nodeCount++;
    return node;
  }

  final void release(int node) {
    m_userData[node] = null;
    m_child1[node] = NULL;
    m_child2[node] = NULL;
    m_height[node] = FREE_HEIGHT;
    m_parent[node] = freeHead;
    freeHead = node;
    nodeCount--;
  }

  private void grow() {
    int old = capacity();
    if (old > Integer.MAX_VALUE / 8) {
      throw new IllegalStateException("too many proxies: " + old + " nodes are in use");
    }
    int capacity = 2 * old;
    m_userData = Arrays.copyOf(m_userData, capacity);
    m_parent = Arrays.copyOf(m_parent, capacity);
    m_child1 = Arrays.copyOf(m_child1, capacity);
    m_child2 = Arrays.copyOf(m_child2, capacity);
    m_height = Arrays.copyOf(m_height, capacity);
    traits = Arrays.copyOf(traits, capacity);
    bounds = Arrays.copyOf(bounds, 4 * capacity);
    linkFree(old);
  }

  /**
   * Makes the nodes from {@code first} to the end of the arrays the free list, in ascending order.
   */
  private void linkFree(int first) {
    int last = capacity() - 1;
    for (int node = first; node <= last; node++) {
      m_parent[node] = node < last ? node + 1 : NULL;
      m_height[node] = FREE_HEIGHT;
    }
    freeHead = first;
  }

  final void setBounds(int node, float minX, float minY, float maxX, float maxY) {
    int i = 4 * node;
    bounds[i] = minX;
    bounds[i + 1] = minY;
    bounds[i + 2] = maxX;
    bounds[i + 3] = maxY;
  }

  final float size(int node) {
    float[] box = bounds;
    int i = 4 * node;
    return (box[i + 2] - box[i]) + (box[i + 3] - box[i + 1]);
  }

  /** Size of the smallest box around the boxes of two nodes. */
  final float unionSize(int a, int b) {
    float[] box = bounds;
    int i = 4 * a;
    int j = 4 * b;
    float width = Math.max(box[i + 2], box[j + 2]) - Math.min(box[i], box[j]);
    float height = Math.max(box[i + 3], box[j + 3]) - Math.min(box[i + 1], box[j + 1]);
    return width + height;
  }

  /** Whether the boxes of two nodes touch or overlap. */
  final boolean overlap(int a, int b) {
    float[] box = bounds;
    int i = 4 * a;
    int j = 4 * b;
    return box[i] <= box[j + 2]
        && box[j] <= box[i + 2]
        && box[i + 1] <= box[j + 3]
        && box[j + 1] <= box[i + 3];
  }

  /** Whether the box of a node and another box touch or overlap. */
  final boolean overlaps(int node, AABB aabb) {
    int i = 4 * node;
    return bounds[i] <= aabb.upperBound.x
        && bounds[i + 1] <= aabb.upperBound.y
        && aabb.lowerBound.x <= bounds[i + 2]
        && aabb.lowerBound.y <= bounds[i + 3];
  }

  /** Whether the box of a node contains another box, borders included. */
  final boolean covers(int node, AABB aabb) {
    int i = 4 * node;
    return bounds[i] <= aabb.lowerBound.x
        && bounds[i + 1] <= aabb.lowerBound.y
        && aabb.upperBound.x <= bounds[i + 2]
        && aabb.upperBound.y <= bounds[i + 3];
  }

  /**
   * Recomputes box, height and {@link #traits} of an inner node from its children; returns whether
   * any of them changed.
   */
  final boolean refit(int node) {
    float[] box = bounds;
    int i = 4 * node;
    int j = 4 * m_child1[node];
    int k = 4 * m_child2[node];
    float minX = Math.min(box[j], box[k]);
    float minY = Math.min(box[j + 1], box[k + 1]);
    float maxX = Math.max(box[j + 2], box[k + 2]);
    float maxY = Math.max(box[j + 3], box[k + 3]);
    int height = 1 + Math.max(m_height[m_child1[node]], m_height[m_child2[node]]);
    long below = traits[m_child1[node]] | traits[m_child2[node]];
    boolean same =
        minX == box[i]
            && minY == box[i + 1]
            && maxX == box[i + 2]
            && maxY == box[i + 3]
            && height == m_height[node]
            && below == traits[node];
    if (same) {
      return false;
    }
    box[i] = minX;
    box[i + 1] = minY;
    box[i + 2] = maxX;
    box[i + 3] = maxY;
    m_height[node] = height;
    traits[node] = below;
    return true;
  }

  /**
   * Puts another node where {@code oldChild} hangs below {@code parent}; a null parent stands for
   * the root.
   */
  final void replaceChild(int parent, int oldChild, int newChild) {
    m_parent[newChild] = parent;
    if (parent == NULL) {
      m_root = newChild;
    } else if (m_child1[parent] == oldChild) {
      m_child1[parent] = newChild;
    } else {
      m_child2[parent] = newChild;
    }
  }
}
