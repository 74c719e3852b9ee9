package org.jbox2d.fracture.hertelmehlhorn;

/**
 * Gives points that have lost or gained area, as vertices of rings, their area back: stretches them
 * across their longer axis, so that they move as little as may be. An affine map leaves simple
 * rings simple and convex ones convex, and what fits fits.
 */
final class Stretch {
  /**
   * Relative change of the area from which on it matters: above what the rounding to floats does to
   * most pieces, below what the pieces of a body may differ from it together.
   */
  static final double AREA_TOLERANCE = 4e-5;

  private double middleX;
  private double middleY;
  private double normalX;
  private double normalY;
  private double growth;

  /**
   * Chooses the map for the first n points.
   *
   * @param area what the area is
   * @param wanted what it is to be
   * @param farthest how far a point may move
   * @return false if nothing is to be done
   */
  boolean choose(double[] xy, int n, double area, double wanted, double farthest) {
    if (!(Math.abs(wanted - area) > AREA_TOLERANCE * Math.abs(wanted) && wanted / area > 0)) {
      return false;
    }
    middleX = 0;
    middleY = 0;
    for (int i = 0; i < n; i++) {
      middleX += xy[2 * i] / n;
      middleY += xy[2 * i + 1] / n;
    }
    // The longer axis goes through the point farthest from the middle; the normal is turned by 90
    // degrees from it.
    double nx = 0;
    double ny = 0;
    for (int i = 0; i < n; i++) {
      double dx = xy[2 * i] - middleX;
      double dy = xy[2 * i + 1] - middleY;
      if (dx * dx + dy * dy > nx * nx + ny * ny) {
        nx = -dy;
        ny = dx;
      }
    }
    double length = Math.sqrt(nx * nx + ny * ny);
    normalX = nx / length;
    normalY = ny / length;
    double width = 0;
    for (int i = 0; i < n; i++) {
      width = Math.max(width, Math.abs(across(xy[2 * i], xy[2 * i + 1])));
    }
    double most = farthest / width;
    growth = Math.max(-most, Math.min(most, wanted / area - 1));
    return true;
  }

  /** Relative change of lengths across. */
  double growth() {
    return growth;
  }

  /** Moves the first n points and rounds them to floats. */
  void apply(double[] xy, int n) {
    for (int i = 0; i < n; i++) {
      double shift = growth * across(xy[2 * i], xy[2 * i + 1]);
      xy[2 * i] = (float) (xy[2 * i] + shift * normalX);
      xy[2 * i + 1] = (float) (xy[2 * i + 1] + shift * normalY);
    }
  }

  private double across(double x, double y) {
    return (x - middleX) * normalX + (y - middleY) * normalY;
  }
}
