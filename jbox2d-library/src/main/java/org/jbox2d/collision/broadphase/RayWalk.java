package org.jbox2d.collision.broadphase;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.RayCastInput;

/**
 * The way of a ray through a tree of boxes, from near to far: of two children that it meets, the
 * one that it enters first is gone into, and the other put aside with the fraction of the ray at
 * which it is entered. If something nearer has been found by then, it is left out.
 */
final class RayWalk {
  /**
   * Relative slack of ray parameters: five roundings (direction, its inverse, difference, product,
   * and the slack itself) on either side of a comparison stay below 2^-21 (Ize 2013, "Robust BVH
   * ray traversal", JCGT 2(2), section 3). The test errs towards reporting.
   */
  private static final float SLACK = 1 + 0x1p-21f;

  /** Where a box is entered that is not met. */
  private static final float NEVER = Float.POSITIVE_INFINITY;

  private final RayCastInput clipped = new RayCastInput();
  private int[] nodes = new int[64];
  private float[] fractions = new float[64];
  private float pX;
  private float pY;

  /** The inverse of the direction; 0 along an axis whose slabs the ray is parallel to. */
  private float inverseX;

  private float inverseY;

  /** Whether the ray meets the lower side of a box first. */
  private boolean risesX;

  private boolean risesY;

  /** Reports each leaf whose box the ray may meet; see {@link BroadPhaseStrategy#raycast}. */
  void walk(FlatNodes tree, TreeRayCastCallback callback, RayCastInput ray) {
    if (tree.m_root == FlatNodes.NULL) {
      return;
    }
    begin(ray);
    float[] box = tree.bounds;
    int[] children1 = tree.m_child1;
    int[] children2 = tree.m_child2;
    float most = ray.maxFraction;
    int top = 0;
    int node = tree.m_root;
    float fraction = enter(box, node, most);
    while (true) {
      // What was put aside may no longer be met.
      boolean met = fraction <= most * SLACK;
      int child1 = children1[node];
      if (met && child1 == FlatNodes.NULL) {
        clipped.maxFraction = most;
        float told = callback.raycastCallback(clipped, node);
        if (told == 0) {
          return;
        }
        most = told > 0 && told < most ? told : most;
      } else if (met) {
        int child2 = children2[node];
        float fraction1 = enter(box, child1, most);
        float fraction2 = enter(box, child2, most);
        boolean first = fraction1 <= fraction2;
        float later = first ? fraction2 : fraction1;
        if (later != NEVER) {
          reserve(top + 1);
          nodes[top] = first ? child2 : child1;
          fractions[top++] = later;
        }
        node = first ? child1 : child2;
        fraction = first ? fraction1 : fraction2;
        if (fraction != NEVER) {
          continue;
        }
      }
      if (top == 0) {
        return;
      }
      node = nodes[--top];
      fraction = fractions[top];
    }
  }

  private void begin(RayCastInput ray) {
    clipped.set(ray);
    pX = ray.p1.x;
    pY = ray.p1.y;
    inverseX = inverse(ray.p2.x - pX);
    inverseY = inverse(ray.p2.y - pY);
    risesX = inverseX >= 0;
    risesY = inverseY >= 0;
  }

  private static float inverse(float d) {
    return Math.abs(d) < Float.MIN_NORMAL ? 0 : 1 / d;
  }

  private void reserve(int count) {
    if (count > nodes.length) {
      nodes = Arrays.copyOf(nodes, 2 * count);
      fractions = Arrays.copyOf(fractions, 2 * count);
    }
  }

  /**
   * The fraction, 0 or more, at which the ray enters a node's box, if it does up to {@code most}:
   * slab test (Kay and Kajiya 1986).
   */
  private float enter(float[] box, int node, float most) {
    int i = 4 * node;
    float enter = 0;
    float leave = most;
    if (inverseX != 0) {
      enter = Math.max(enter, (box[risesX ? i : i + 2] - pX) * inverseX);
      leave = Math.min(leave, (box[risesX ? i + 2 : i] - pX) * inverseX);
    } else if (pX < box[i] || pX > box[i + 2]) {
      return NEVER;
    }
    if (inverseY != 0) {
      enter = Math.max(enter, (box[risesY ? i + 1 : i + 3] - pY) * inverseY);
      leave = Math.min(leave, (box[risesY ? i + 3 : i + 1] - pY) * inverseY);
    } else if (pY < box[i + 1] || pY > box[i + 3]) {
      return NEVER;
    }
    return enter <= leave * SLACK ? enter : NEVER;
  }
}
