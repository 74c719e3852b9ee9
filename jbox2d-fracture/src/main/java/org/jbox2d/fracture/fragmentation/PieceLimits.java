package org.jbox2d.fracture.fragmentation;

/**
 * What is too small to be a piece of its own: it is merged into the neighbour it shares most of its
 * edges with.
 */
public final class PieceLimits {
  /** No limit but what rounding demands. */
  public static final PieceLimits NONE = new PieceLimits(0, 0);

  private final double areaShare;
  private final double width;

  /**
   * Creates limits.
   *
   * @param areaShare least area, as a share of the area of the outline; 0 to 1
   * @param width least width, in the unit of the outline; the width of a piece is twice its area
   *     over its perimeter, which for a sliver is its breadth
   * @throws IllegalArgumentException if the share is not between 0 and 1 or the width not finite
   *     and non-negative
   */
  public PieceLimits(double areaShare, double width) {
    if (!(areaShare >= 0 && areaShare <= 1)) {
      throw new IllegalArgumentException("share of area: " + areaShare);
    }
    if (!(width >= 0 && width * 0 == 0)) {
      throw new IllegalArgumentException("width: " + width);
    }
    this.areaShare = areaShare;
    this.width = width;
  }

  /** Least area, as a share of the area of the outline. */
  public double areaShare() {
    return areaShare;
  }

  /** Least width, in the unit of the outline. */
  public double width() {
    return width;
  }
}
