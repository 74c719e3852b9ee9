package org.jbox2d.collision;

import org.jbox2d.common.Vec2;
import org.jbox2d.pooling.IWorldPool;

/** A rectangle with sides along the axes, in metres. */
public class AABB {

  /** The corner of the smallest coordinates. */
  public final Vec2 lowerBound;

  /** The corner of the largest coordinates. */
  public final Vec2 upperBound;

  /** The rectangle that is the origin alone. */
  public AABB() {
    lowerBound = new Vec2();
    upperBound = new Vec2();
  }

  public AABB(AABB copy) {
    this(copy.lowerBound, copy.upperBound);
  }

  /** Copies the corners. */
  public AABB(Vec2 lowerVertex, Vec2 upperVertex) {
    lowerBound = lowerVertex.clone();
    upperBound = upperVertex.clone();
  }

  public final void set(AABB aabb) {
    lowerBound.set(aabb.lowerBound);
    upperBound.set(aabb.upperBound);
  }

  /** Whether the corners are finite and in order. */
  public final boolean isValid() {
    return lowerBound.isValid()
        && upperBound.isValid()
        && lowerBound.x <= upperBound.x
        && lowerBound.y <= upperBound.y;
  }

  public final Vec2 getCenter() {
    Vec2 center = new Vec2();
    getCenterToOut(center);
    return center;
  }

  public final void getCenterToOut(Vec2 out) {
    out.x = 0.5f * (lowerBound.x + upperBound.x);
    out.y = 0.5f * (lowerBound.y + upperBound.y);
  }

  /** Half of width and height. */
  public final Vec2 getExtents() {
    Vec2 extents = new Vec2();
    getExtentsToOut(extents);
    return extents;
  }

  /** Half of width and height. */
  public final void getExtentsToOut(Vec2 out) {
    out.x = 0.5f * (upperBound.x - lowerBound.x);
    out.y = 0.5f * (upperBound.y - lowerBound.y);
  }

  /**
   * Writes the corners counter-clockwise from {@link #lowerBound} into the first four elements,
   * which must not be null.
   */
  public final void getVertices(Vec2[] argRay) {
    argRay[0].set(lowerBound.x, lowerBound.y);
    argRay[1].set(upperBound.x, lowerBound.y);
    argRay[2].set(upperBound.x, upperBound.y);
    argRay[3].set(lowerBound.x, upperBound.y);
  }

  /** Sets this to the smallest rectangle around both; either may be this one. */
  public final void combine(AABB aabb1, AABB aabb2) {
    Vec2.minToOut(aabb1.lowerBound, aabb2.lowerBound, lowerBound);
    Vec2.maxToOut(aabb1.upperBound, aabb2.upperBound, upperBound);
  }

  /** Grows this to hold {@code aabb} too. */
  public final void combine(AABB aabb) {
    combine(this, aabb);
  }

  public final float getPerimeter() {
    return 2.0f * (upperBound.x - lowerBound.x + upperBound.y - lowerBound.y);
  }

  /** Whether {@code aabb} lies in this one; a shared border counts. */
  public final boolean contains(AABB aabb) {
    return lowerBound.x <= aabb.lowerBound.x
        && lowerBound.y <= aabb.lowerBound.y
        && aabb.upperBound.x <= upperBound.x
        && aabb.upperBound.y <= upperBound.y;
  }

  /** Whether the two have a point in common; touching counts. */
  public static final boolean testOverlap(AABB a, AABB b) {
    return a.lowerBound.x <= b.upperBound.x
        && b.lowerBound.x <= a.upperBound.x
        && a.lowerBound.y <= b.upperBound.y
        && b.lowerBound.y <= a.upperBound.y;
  }

  /**
   * Where a ray from outside enters this rectangle. A ray that starts inside has no answer, nor one
   * that ends before it; then {@code output} stays.
   *
   * <p>The ray's parameter is cut to the slab between each pair of sides (T. Kay and J. Kajiya, Ray
   * Tracing Complex Scenes, SIGGRAPH 1986). A ray parallel to a slab is either in it all along or
   * never, so nothing is divided by zero.
   */
  public final boolean raycast(RayCastOutput output, RayCastInput input) {
    double px = input.p1.x;
    double py = input.p1.y;
    double dx = input.p2.x - px;
    double dy = input.p2.y - py;
    double enter = Double.NEGATIVE_INFINITY;
    double leave = Double.POSITIVE_INFINITY;
    boolean throughX = false;

    if (dx == 0) {
      if (px < lowerBound.x || px > upperBound.x) {
        return false;
      }
    } else {
      enter = ((dx > 0 ? lowerBound.x : upperBound.x) - px) / dx;
      leave = ((dx > 0 ? upperBound.x : lowerBound.x) - px) / dx;
      throughX = true;
    }

    if (dy == 0) {
      if (py < lowerBound.y || py > upperBound.y) {
        return false;
      }
    } else {
      double enterY = ((dy > 0 ? lowerBound.y : upperBound.y) - py) / dy;
      double leaveY = ((dy > 0 ? upperBound.y : lowerBound.y) - py) / dy;
      if (enterY > enter) {
        enter = enterY;
        throughX = false;
      }
      leave = Math.min(leave, leaveY);
    }

    if (!(enter >= 0 && enter <= leave && enter <= input.maxFraction)) {
      return false;
    }
    output.fraction = (float) enter;
    if (throughX) {
      output.normal.set(dx > 0 ? -1f : 1f, 0f);
    } else {
      output.normal.set(0f, dy > 0 ? -1f : 1f);
    }
    return true;
  }

  /** As {@link #raycast(RayCastOutput, RayCastInput)}; the pool is not used and may be null. */
  public final boolean raycast(RayCastOutput output, RayCastInput input, IWorldPool argPool) {
    return raycast(output, input);
  }

  @Override
  public final String toString() {
    return "AABB[" + lowerBound + " . " + upperBound + "]";
  }
}
