package org.jbox2d.fracture.fragmentation;

/**
 * Where an impact breaks a body: a convex region around or beside a contact point, in the
 * coordinates of the outline.
 */
public interface RegionOfEffect {
  /** x of the contact point. */
  double contactX();

  /** y of the contact point. */
  double contactY();

  /** Left end of the region. */
  double minX();

  /** Right end of the region. */
  double maxX();

  /** Lower end of the region. */
  double minY();

  /** Upper end of the region. */
  double maxY();

  /**
   * Area of what the region and the triangle of the contact, a and b have in common: positive if
   * they turn counter-clockwise, else negative. The sum over the edges of a piece, which has its
   * interior on their left, is the area of what region and piece have in common; two pieces that
   * share an edge have the same term, but for its sign.
   */
  double overlap(double ax, double ay, double bx, double by);

  /**
   * Bits for the sides of a convex polygon around the region that a point is beyond: if points have
   * one in common, their hull misses the region (D. Cohen and I. Sutherland's outcodes). The
   * polygon is the box of the region, unless there is a better one.
   */
  default int sidesBeyond(double x, double y) {
    return (x < minX() ? 1 : 0)
        | (x > maxX() ? 2 : 0)
        | (y < minY() ? 4 : 0)
        | (y > maxY() ? 8 : 0);
  }
}
