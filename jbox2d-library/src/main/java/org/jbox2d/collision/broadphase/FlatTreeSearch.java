package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.internal.IntArrayList;

/**
 * Searches of the tree. Those for boxes share one stack of nodes still to be looked at: a search
 * that a callback starts works above the entries of the one that called it, so that searches nest
 * to any depth without allocating. Rays have a {@link RayWalk} for each depth. Callbacks must not
 * change the tree, and one thread at a time may search it.
 */
abstract class FlatTreeSearch extends FlatTree {
  private int[] stack = new int[64];
  private int stackTop;

  /** The ways of rays, one for each depth of nesting. */
  private RayWalk[] rays = {new RayWalk()};

  private int rayDepth;

  /**
   * Reports each leaf whose box meets the given one and that has one of the traits that are wanted.
   *
   * @throws IllegalArgumentException if the box is NaN
   */
  final void search(TreeCallback callback, AABB aabb, long wanted) {
    float minX = aabb.lowerBound.x;
    float minY = aabb.lowerBound.y;
    float maxX = aabb.upperBound.x;
    float maxY = aabb.upperBound.y;
    if (Float.isNaN(minX + minY) || Float.isNaN(maxX + maxY)) {
      throw new IllegalArgumentException("box to query is NaN: " + aabb);
    }
    int base = stackTop;
    try {
      pushRoot();
      int leaf = nextOverlap(base, wanted, minX, minY, maxX, maxY);
      while (leaf != NULL && callback.treeCallback(leaf)) {
        leaf = nextOverlap(base, wanted, minX, minY, maxX, maxY);
      }
    } finally {
      stackTop = base;
    }
  }

  /**
   * Appends each leaf whose box meets that of a given leaf and that has one of the traits that are
   * wanted, that leaf itself included.
   */
  final void collectOverlaps(int proxyId, long wanted, IntArrayList out) {
    float[] box = bounds;
    int i = 4 * proxyId;
    float minX = box[i];
    float minY = box[i + 1];
    float maxX = box[i + 2];
    float maxY = box[i + 3];
    int base = stackTop;
    // Children are looked at before they are put aside: most then are not, and a crowded step takes
    // a fifteenth less time than if both are put aside and looked at in their turn.
    int node = isMet(m_root, wanted, minX, minY, maxX, maxY) ? m_root : NULL;
    while (node != NULL) {
      int next = NULL;
      int child1 = m_child1[node];
      if (child1 == NULL) {
        out.add(node);
      } else {
        int child2 = m_child2[node];
        next = isMet(child2, wanted, minX, minY, maxX, maxY) ? child2 : NULL;
        if (isMet(child1, wanted, minX, minY, maxX, maxY)) {
          if (next != NULL) {
            reserve(1);
            stack[stackTop++] = next;
          }
          next = child1;
        }
      }
      node = next == NULL && stackTop > base ? stack[--stackTop] : next;
    }
  }

  private boolean isMet(int node, long wanted, float minX, float minY, float maxX, float maxY) {
    float[] box = bounds;
    int i = 4 * node;
    return !(box[i] > maxX || box[i + 1] > maxY || box[i + 2] < minX || box[i + 3] < minY)
        && (traits[node] & wanted) != 0;
  }

  private void pushRoot() {
    if (m_root != NULL) {
      reserve(1);
      stack[stackTop++] = m_root;
    }
  }

  private void reserve(int count) {
    if (stackTop + count > stack.length) {
      stack = Arrays.copyOf(stack, 2 * stack.length);
    }
  }

  /**
   * Works the stack down to {@code base} until it meets a leaf that is wanted, whose box meets the
   * given one; -1 if there is none left.
   */
  private int nextOverlap(int base, long wanted, float minX, float minY, float maxX, float maxY) {
    int[] todo = stack;
    int top = stackTop;
    while (top > base) {
      int node = todo[--top];
      if (!isMet(node, wanted, minX, minY, maxX, maxY)) {
        continue;
      }
      int child1 = m_child1[node];
      if (child1 == NULL) {
        stackTop = top;
        return node;
      }
      if (top + 2 > todo.length) {
        stackTop = top;
        reserve(2);
        todo = stack;
      }
      todo[top++] = m_child2[node];
      todo[top++] = child1;
    }
    stackTop = base;
    return NULL;
  }

  /** Reports each leaf whose box the ray may meet, roughly from near to far. */
  final void searchRay(TreeRayCastCallback callback, RayCastInput ray) {
    if (rayDepth == rays.length) {
      rays = Arrays.copyOf(rays, rayDepth + 1);
      rays[rayDepth] = new RayWalk();
    }
    RayWalk walk = rays[rayDepth++];
    try {
      walk.walk(this, callback, ray);
    } finally {
      rayDepth--;
    }
  }
}
