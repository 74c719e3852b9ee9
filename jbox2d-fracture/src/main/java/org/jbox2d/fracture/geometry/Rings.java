package org.jbox2d.fracture.geometry;

/**
 * Measures of closed rings, given as vertices {@code start} (inclusive) to {@code end} (exclusive)
 * of interleaved coordinates.
 */
public final class Rings {
  private Rings() {}

  /**
   * Signed area, positive for counter-clockwise rings. Summed over triangles at the first vertex,
   * so that the offset of the ring from the origin costs no accuracy.
   */
  public static double signedArea(double[] xy, int start, int end) {
    double sum = 0;
    if (end - start < 3) {
      return 0;
    }
    double ox = xy[2 * start];
    double oy = xy[2 * start + 1];
    double px = xy[2 * start + 2] - ox;
    double py = xy[2 * start + 3] - oy;
    for (int i = start + 2; i < end; i++) {
      double qx = xy[2 * i] - ox;
      double qy = xy[2 * i + 1] - oy;
      sum += px * qy - py * qx;
      px = qx;
      py = qy;
    }
    return 0.5 * sum;
  }

  /** Reverses the order of the vertices {@code start} to {@code end} in place. */
  public static void reverse(double[] xy, int start, int end) {
    for (int i = start, j = end - 1; i < j; i++, j--) {
      double x = xy[2 * i];
      double y = xy[2 * i + 1];
      xy[2 * i] = xy[2 * j];
      xy[2 * i + 1] = xy[2 * j + 1];
      xy[2 * j] = x;
      xy[2 * j + 1] = y;
    }
  }

  /** Length of the ring. */
  public static double perimeter(double[] xy, int start, int end) {
    double sum = 0;
    for (int i = start, j = end - 1; i < end; j = i++) {
      double dx = xy[2 * i] - xy[2 * j];
      double dy = xy[2 * i + 1] - xy[2 * j + 1];
      sum += Math.sqrt(dx * dx + dy * dy);
    }
    return sum;
  }

  /**
   * Whether a point is inside the ring, on its boundary, or outside, decided exactly.
   *
   * <p>Counts the edges that a ray to the right crosses; an edge owns its lower end but not its
   * upper one.
   *
   * @return +1 inside, 0 on the boundary, -1 outside
   */
  public static int locate(double[] xy, int start, int end, double x, double y) {
    boolean inside = false;
    for (int i = start, j = end - 1; i < end; j = i++) {
      double ax = xy[2 * j];
      double ay = xy[2 * j + 1];
      double bx = xy[2 * i];
      double by = xy[2 * i + 1];
      if (ay == y && by == y) {
        if (x >= Math.min(ax, bx) && x <= Math.max(ax, bx)) {
          return 0;
        }
        continue;
      }
      if (y < Math.min(ay, by) || y > Math.max(ay, by)) {
        continue;
      }
      int side = Predicates.orientation(ax, ay, bx, by, x, y);
      if (side == 0) {
        return 0;
      }
      if ((ay > y) != (by > y) && (side > 0) == (by > ay)) {
        inside = !inside;
      }
    }
    return inside ? 1 : -1;
  }

  /**
   * Whether the ring is a strictly convex polygon, in either orientation, decided exactly: it turns
   * the same way in every vertex, and goes around once, so that only one edge goes up after one
   * that goes down.
   */
  public static boolean isStrictlyConvex(double[] xy, int start, int end) {
    if (end - start < 3) {
      return false;
    }
    int wanted = Predicates.orientation(xy, end - 2, end - 1, start);
    boolean wasUp = goesUp(xy, end - 2, end - 1);
    int rises = 0;
    int a = end - 1;
    for (int b = start; b < end; b++) {
      int c = b + 1 < end ? b + 1 : start;
      boolean up = goesUp(xy, a, b);
      rises += up && !wasUp ? 1 : 0;
      if (wanted == 0 || rises > 1 || Predicates.orientation(xy, a, b, c) != wanted) {
        return false;
      }
      wasUp = up;
      a = b;
    }
    return true;
  }

  private static boolean goesUp(double[] xy, int a, int b) {
    double dy = xy[2 * b + 1] - xy[2 * a + 1];
    return dy > 0 || (dy == 0 && xy[2 * b] > xy[2 * a]);
  }
}
