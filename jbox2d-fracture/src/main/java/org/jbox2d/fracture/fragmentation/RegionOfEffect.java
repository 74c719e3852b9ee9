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
   * Area of what the region and the inside of a ring have in common: positive for counter-clockwise
   * rings, negative for clockwise ones, so that outer ring and holes of a piece add up.
   *
   * @param xy interleaved coordinates
   * @param start first vertex of the ring
   * @param end one past the last vertex of the ring
   */
  double overlap(double[] xy, int start, int end);
}
