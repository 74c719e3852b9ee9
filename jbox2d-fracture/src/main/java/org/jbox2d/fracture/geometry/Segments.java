package org.jbox2d.fracture.geometry;

/** Closed line segments between points of interleaved coordinates; all answers are exact. */
public final class Segments {
  private Segments() {}

  /** Whether the closed segments a-b and c-d share a point. */
  public static boolean touch(double[] xy, int a, int b, int c, int d) {
    int abc = Predicates.orientation(xy, a, b, c);
    int abd = Predicates.orientation(xy, a, b, d);
    if (abc * abd > 0) {
      return false;
    }
    int cda = Predicates.orientation(xy, c, d, a);
    int cdb = Predicates.orientation(xy, c, d, b);
    if (cda * cdb > 0) {
      return false;
    }
    if (abc == 0 && abd == 0) {
      return boxesOverlap(xy, a, b, c, d);
    }
    return true;
  }

  private static boolean boxesOverlap(double[] xy, int a, int b, int c, int d) {
    for (int axis = 0; axis < 2; axis++) {
      double a1 = xy[2 * a + axis];
      double b1 = xy[2 * b + axis];
      double c1 = xy[2 * c + axis];
      double d1 = xy[2 * d + axis];
      if (Math.max(a1, b1) < Math.min(c1, d1) || Math.max(c1, d1) < Math.min(a1, b1)) {
        return false;
      }
    }
    return true;
  }

  /** Square of the distance of point (x, y) from the segment a-b, rounded. */
  public static double distanceSquared(double[] xy, int a, int b, double x, double y) {
    double ux = xy[2 * b] - xy[2 * a];
    double uy = xy[2 * b + 1] - xy[2 * a + 1];
    double px = x - xy[2 * a];
    double py = y - xy[2 * a + 1];
    double length = ux * ux + uy * uy;
    double t = length > 0 ? Math.max(0, Math.min(1, (px * ux + py * uy) / length)) : 0;
    double dx = px - t * ux;
    double dy = py - t * uy;
    return dx * dx + dy * dy;
  }
}
