package org.jbox2d.collision.shapes;

import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * The convex hull that a {@link PolygonShape} is made of: counter-clockwise, from the lowest of the
 * rightmost points, without points that repeat another or lie on an edge.
 *
 * <p>The hull is the monotone chain of A. M. Andrew, Another efficient algorithm for convex hulls
 * in two dimensions, Information Processing Letters 9 (1979). All vertices are input points, so
 * nothing is rounded. Coordinates are floats and cross products are taken in double: their signs
 * are right unless exponents differ by more than 2^29.
 */
final class ConvexHull {

  /**
   * A vertex is dropped if its height over the chord of its neighbours is below this part of the
   * shape's reach (the extent plus the distance from the origin): collinear points, rounded to
   * float, deviate by up to half an ulp each.
   */
  private static final double COLLINEAR_TOLERANCE = 4.0 * Settings.EPSILON;

  private final double[] x;
  private final double[] y;
  private int count;

  /** The vertex that comes first. */
  private int start;

  private ConvexHull(int capacity) {
    x = new double[capacity];
    y = new double[capacity];
  }

  /**
   * Computes the hull of the first {@code n} points.
   *
   * @throws IllegalArgumentException if a coordinate is not finite, or what remains has no area
   */
  static ConvexHull of(Vec2[] points, int n) {
    ConvexHull hull = new ConvexHull(n);
    double reach = hull.weld(points, n);
    if (hull.count < 3) {
      throw new IllegalArgumentException(
          "a polygon needs 3 points at least "
              + weldDistance()
              + " m apart, but only "
              + hull.count
              + " of "
              + n
              + " are, from "
              + points[0]);
    }
    double tolerance = COLLINEAR_TOLERANCE * reach;
    if (!hull.isWrapped(tolerance)) {
      hull.sortByX();
      hull.wrap();
      hull.dropCollinear(tolerance);
    }
    if (hull.count < 3) {
      throw new IllegalArgumentException(
          "a polygon needs an area, but its " + n + " points are collinear, from " + points[0]);
    }
    hull.findLowestOfRightmost();
    return hull;
  }

  int size() {
    return count;
  }

  void copyTo(Vec2[] vertices) {
    int from = start;
    for (int i = 0; i < count; i++) {
      vertices[i].set((float) x[from], (float) y[from]);
      from = from + 1 < count ? from + 1 : 0;
    }
  }

  private static double weldDistance() {
    return 0.5 * Settings.linearSlop;
  }

  /** Takes over the points that are not too close to an earlier one; returns the reach. */
  private double weld(Vec2[] points, int n) {
    double weldSquared = weldDistance() * weldDistance();
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      Vec2 p = points[i];
      if (!p.isValid()) {
        throw new IllegalArgumentException("polygon vertex " + i + " must be finite: " + p);
      }
      if (!isNearTaken(p, weldSquared)) {
        x[count] = p.x;
        y[count] = p.y;
        count++;
        minX = Math.min(minX, p.x);
        maxX = Math.max(maxX, p.x);
        minY = Math.min(minY, p.y);
        maxY = Math.max(maxY, p.y);
      }
    }
    double extent = Math.max(maxX - minX, maxY - minY);
    double offset = Math.max(Math.max(-minX, maxX), Math.max(-minY, maxY));
    return extent + offset;
  }

  private boolean isNearTaken(Vec2 p, double weldSquared) {
    for (int i = 0; i < count; i++) {
      double dx = p.x - x[i];
      double dy = p.y - y[i];
      if (dx * dx + dy * dy < weldSquared) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether the points are the hull already, with nothing to drop: each sticks out to the right of
   * the way from its neighbour before it to that after it, and the way around turns from leftwards
   * to rightwards only once.
   */
  private boolean isWrapped(double tolerance) {
    int turns = 0;
    boolean wasLeftwards = x[0] < x[count - 1];
    for (int i = 0; i < count; i++) {
      int after = i == count - 1 ? 0 : i + 1;
      boolean leftwards = x[after] < x[i];
      turns += wasLeftwards && !leftwards ? 1 : 0;
      wasLeftwards = leftwards;
      if (!(heightOverNeighbours(i) > tolerance)) {
        return false;
      }
    }
    return turns == 1;
  }

  /** Insertion sort by x, then y: there are a handful of points. */
  private void sortByX() {
    for (int i = 1; i < count; i++) {
      double px = x[i];
      double py = y[i];
      int j = i;
      while (j > 0 && (x[j - 1] > px || x[j - 1] == px && y[j - 1] > py)) {
        x[j] = x[j - 1];
        y[j] = y[j - 1];
        j--;
      }
      x[j] = px;
      y[j] = py;
    }
  }

  /** From left to right below, then back above, keeping left turns only. */
  private void wrap() {
    int[] chain = new int[2 * count];
    int size = 0;
    for (int i = 0; i < count; i++) {
      size = push(chain, size, 0, i);
    }
    int lower = size - 1;
    for (int i = count - 2; i >= 0; i--) {
      size = push(chain, size, lower, i);
    }
    size--;
    double[] hullX = new double[size];
    double[] hullY = new double[size];
    for (int i = 0; i < size; i++) {
      hullX[i] = x[chain[i]];
      hullY[i] = y[chain[i]];
    }
    System.arraycopy(hullX, 0, x, 0, size);
    System.arraycopy(hullY, 0, y, 0, size);
    count = size;
  }

  private int push(int[] chain, int size, int fixed, int next) {
    int top = size;
    while (top - fixed >= 2 && turn(chain[top - 2], chain[top - 1], next) <= 0) {
      top--;
    }
    chain[top] = next;
    return top + 1;
  }

  /** Twice the area of the triangle a, b, c; positive if it turns left. */
  private double turn(int a, int b, int c) {
    return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
  }

  /**
   * Removes the flattest vertex as long as it is flatter than {@code tolerance}; its neighbours
   * then stick out more.
   */
  private void dropCollinear(double tolerance) {
    while (count >= 3) {
      int flattest = 0;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < count; i++) {
        double height = heightOverNeighbours(i);
        if (height < least) {
          least = height;
          flattest = i;
        }
      }
      if (least > tolerance) {
        return;
      }
      System.arraycopy(x, flattest + 1, x, flattest, count - flattest - 1);
      System.arraycopy(y, flattest + 1, y, flattest, count - flattest - 1);
      count--;
    }
  }

  private double heightOverNeighbours(int i) {
    int before = i == 0 ? count - 1 : i - 1;
    int after = i == count - 1 ? 0 : i + 1;
    double dx = x[after] - x[before];
    double dy = y[after] - y[before];
    return turn(before, i, after) / Math.sqrt(dx * dx + dy * dy);
  }

  private void findLowestOfRightmost() {
    start = 0;
    for (int i = 1; i < count; i++) {
      if (x[i] > x[start] || x[i] == x[start] && y[i] < y[start]) {
        start = i;
      }
    }
  }
}
