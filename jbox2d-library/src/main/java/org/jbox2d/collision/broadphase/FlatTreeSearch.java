package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.internal.IntArrayList;

/**
 * Searches of the tree. All searches share one stack of nodes still to be looked at; a search that
 * a callback starts works above the entries of the one that called it, so that searches nest to any
 * depth without allocating. Callbacks must not change the tree, and one thread at a time may search
 * it.
 */
abstract class FlatTreeSearch extends FlatTree {
  /**
   * Relative slack of ray parameters: five roundings (direction, its inverse, difference, product,
   * and the slack itself) on either side of a comparison stay below 2^-21 (Ize 2013, "Robust BVH
   * ray traversal", JCGT 2(2), section 3). The test errs towards reporting.
   */
  private static final float RAY_SLACK = 1 + 0x1p-21f;

  private int[] stack = new int[64];
  private int stackTop;

  /** The clipped rays handed to callbacks, one for each depth of nesting. */
  private RayCastInput[] clippedRays = {new RayCastInput()};

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
    int i = 4 * proxyId;
    float minX = bounds[i];
    float minY = bounds[i + 1];
    float maxX = bounds[i + 2];
    float maxY = bounds[i + 3];
    int base = stackTop;
    pushRoot();
    int leaf = nextOverlap(base, wanted, minX, minY, maxX, maxY);
    while (leaf != NULL) {
      out.add(leaf);
      leaf = nextOverlap(base, wanted, minX, minY, maxX, maxY);
    }
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
    float[] box = bounds;
    int[] todo = stack;
    int top = stackTop;
    while (top > base) {
      int node = todo[--top];
      int i = 4 * node;
      if (box[i] > maxX || box[i + 1] > maxY || box[i + 2] < minX || box[i + 3] < minY) {
        continue;
      }
      if ((traits[node] & wanted) == 0) {
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
    int base = stackTop;
    RayCastInput clipped = borrowRay();
    try {
      clipped.set(ray);
      pushRoot();
      walkRay(callback, clipped, base);
    } finally {
      stackTop = base;
      rayDepth--;
    }
  }

  private RayCastInput borrowRay() {
    if (rayDepth == clippedRays.length) {
      clippedRays = Arrays.copyOf(clippedRays, 2 * rayDepth);
      for (int i = rayDepth; i < clippedRays.length; i++) {
        clippedRays[i] = new RayCastInput();
      }
    }
    return clippedRays[rayDepth++];
  }

  private void walkRay(TreeRayCastCallback callback, RayCastInput ray, int base) {
    float pX = ray.p1.x;
    float pY = ray.p1.y;
    float dX = ray.p2.x - pX;
    float dY = ray.p2.y - pY;
    float inverseX = inverse(dX);
    float inverseY = inverse(dY);
    float maxFraction = ray.maxFraction;
    while (stackTop > base) {
      int node = stack[--stackTop];
      if (!meets(node, pX, pY, inverseX, inverseY, maxFraction)) {
        continue;
      }
      if (!isLeaf(node)) {
        pushNearLast(node, dX, dY);
        continue;
      }
      ray.maxFraction = maxFraction;
      float fraction = callback.raycastCallback(ray, node);
      if (fraction == 0) {
        return;
      }
      if (fraction > 0 && fraction < maxFraction) {
        maxFraction = fraction;
      }
    }
  }

  /**
   * The inverse of a component of a ray's direction; 0 if the ray is parallel to the slab of that
   * axis.
   */
  private static float inverse(float d) {
    return Math.abs(d) < Float.MIN_NORMAL ? 0 : 1 / d;
  }

  /**
   * Whether a ray meets a node's box at a fraction from 0 to maxFraction: slab test (Kay and Kajiya
   * 1986).
   */
  private boolean meets(
      int node, float pX, float pY, float inverseX, float inverseY, float maxFraction) {
    float[] box = bounds;
    int i = 4 * node;
    float enter = 0;
    float leave = maxFraction;
    if (inverseX != 0) {
      float x1 = (box[i] - pX) * inverseX;
      float x2 = (box[i + 2] - pX) * inverseX;
      enter = Math.max(enter, Math.min(x1, x2));
      leave = Math.min(leave, Math.max(x1, x2));
    } else if (pX < box[i] || pX > box[i + 2]) {
      return false;
    }
    if (inverseY != 0) {
      float y1 = (box[i + 1] - pY) * inverseY;
      float y2 = (box[i + 3] - pY) * inverseY;
      enter = Math.max(enter, Math.min(y1, y2));
      leave = Math.min(leave, Math.max(y1, y2));
    } else if (pY < box[i + 1] || pY > box[i + 3]) {
      return false;
    }
    return enter <= leave * RAY_SLACK;
  }

  /**
   * Pushes both children, such that the one whose centre lies nearer along the ray is looked at
   * first.
   */
  private void pushNearLast(int node, float dX, float dY) {
    float[] box = bounds;
    int child1 = m_child1[node];
    int child2 = m_child2[node];
    int i = 4 * child1;
    int j = 4 * child2;
    float alongX = ((box[i] + box[i + 2]) - (box[j] + box[j + 2])) * dX;
    float alongY = ((box[i + 1] + box[i + 3]) - (box[j + 1] + box[j + 3])) * dY;
    boolean firstIsNear = alongX + alongY <= 0;
    reserve(2);
    stack[stackTop++] = firstIsNear ? child2 : child1;
    stack[stackTop++] = firstIsNear ? child1 : child2;
  }
}
