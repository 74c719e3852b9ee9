package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.Distance.SimplexCache;
import org.jbox2d.common.Vec2;

/**
 * Distance of two convex point sets A and B (Gilbert, Johnson, Keerthi, "A fast procedure for
 * computing the distance between complex objects in three-dimensional space", IEEE J. Robotics and
 * Automation 4, 1988; Ericson, Real-Time Collision Detection, 2005, chapter 9).
 *
 * <p>The distance is that of the origin from the difference set W = { b - a }. A simplex of at most
 * three points of W is kept. In each step v is its point closest to the origin, the simplex is
 * reduced to the corners that v depends on, and the point w of W furthest in the direction -v is
 * added. Since v . w / |v| bounds the distance from below, the gap |v|^2 - v . w measures what is
 * still to gain.
 *
 * <p>It ends, for every input, by one of: the origin is inside the triangle; v is zero; the gap is
 * rounding; w is already a corner; v did not get shorter; the iterations are used up. In the last
 * three cases v is still a point of W, so the distance is never too short.
 *
 * <p>The arithmetic is double on float input, in A's frame: then products of coordinates lose
 * nothing, and degenerate simplices (equal or collinear corners) need no tolerances.
 */
public final class Gjk {

  /** Bound of the support steps; polygons of 8 vertices need fewer than 10. */
  public static final int MAX_ITERATIONS = 20;

  /**
   * The part of |v|^2 that a further support point must promise to gain. Four decades above the
   * rounding of double products, nine below what a float result can show.
   */
  private static final double LEAST_GAIN = 1e-12;

  /** |v| below this part of the largest |w| of the simplex is rounding of touching sets. */
  private static final double TOUCHING = 1e-14;

  /** Distance in metres; zero if the sets touch or overlap. */
  public double distance;

  /** Closest points in A's frame; equal up to rounding if the sets overlap. */
  public double pointAX;

  public double pointAY;
  public double pointBX;
  public double pointBY;

  /** From A to B in A's frame, of length {@link #distance}. */
  public double gapX;

  public double gapY;

  /** Support steps of the last call. */
  public int iterations;

  private final double[] wx = new double[3];
  private final double[] wy = new double[3];
  private final int[] indexA = new int[3];
  private final int[] indexB = new int[3];
  private final double[] weight = new double[3];
  private int count;

  private DistanceProxy proxyA;
  private DistanceProxy proxyB;
  private double c;
  private double s;
  private double tx;
  private double ty;

  /**
   * Computes distance and closest points, without the proxies' radii. A point b of proxy B is at R
   * b + t in A's frame, R = (c, -s; s, c).
   *
   * @param cache start simplex, replaced by the last one; a count of zero starts afresh. Any start
   *     leads to the same distance, a near one sooner
   */
  public void solve(
      DistanceProxy a,
      DistanceProxy b,
      double c,
      double s,
      double tx,
      double ty,
      SimplexCache cache) {
    this.proxyA = a;
    this.proxyB = b;
    this.c = c;
    this.s = s;
    this.tx = tx;
    this.ty = ty;
    loadSimplex(cache);
    iterations = 0;
    double shortest = Double.POSITIVE_INFINITY;
    boolean overlap = false;
    while (true) {
      reduce();
      if (count == 3) {
        overlap = true;
        break;
      }
      double squared = gapX * gapX + gapY * gapY;
      double touching = TOUCHING * size();
      if (squared <= touching * touching) {
        overlap = true;
        break;
      }
      if (!(squared < shortest) || iterations == MAX_ITERATIONS || !addSupport(squared)) {
        break;
      }
      shortest = squared;
      iterations++;
    }
    writeResult(overlap);
    storeSimplex(cache);
  }

  private void loadSimplex(SimplexCache cache) {
    count = 0;
    for (int i = 0; i < cache.count && i < 3; i++) {
      // A cache of other proxies may point past the end.
      if (cache.indexA[i] < proxyA.m_count && cache.indexB[i] < proxyB.m_count) {
        push(cache.indexA[i], cache.indexB[i]);
      }
    }
    if (count == 0) {
      push(0, 0);
    }
  }

  private void push(int ia, int ib) {
    Vec2 a = proxyA.m_vertices[ia];
    Vec2 b = proxyB.m_vertices[ib];
    indexA[count] = ia;
    indexB[count] = ib;
    wx[count] = (c * b.x - s * b.y + tx) - a.x;
    wy[count] = (s * b.x + c * b.y + ty) - a.y;
    weight[count] = 1.0;
    count++;
  }

  /** Largest coordinate of the simplex. */
  private double size() {
    double size = 0.0;
    for (int i = 0; i < count; i++) {
      size = Math.max(size, Math.max(Math.abs(wx[i]), Math.abs(wy[i])));
    }
    return size;
  }

  /**
   * Adds the point of W furthest against v.
   *
   * @return false if it gains nothing
   */
  private boolean addSupport(double squared) {
    int ia = 0;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < proxyA.m_count; i++) {
      Vec2 a = proxyA.m_vertices[i];
      double d = gapX * a.x + gapY * a.y;
      if (d > most) {
        most = d;
        ia = i;
      }
    }
    double bx = c * gapX + s * gapY;
    double by = c * gapY - s * gapX;
    int ib = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < proxyB.m_count; i++) {
      Vec2 b = proxyB.m_vertices[i];
      double d = bx * b.x + by * b.y;
      if (d < least) {
        least = d;
        ib = i;
      }
    }
    for (int i = 0; i < count; i++) {
      if (indexA[i] == ia && indexB[i] == ib) {
        return false;
      }
    }
    push(ia, ib);
    double gain = squared - (gapX * wx[count - 1] + gapY * wy[count - 1]);
    if (gain > LEAST_GAIN * squared) {
      return true;
    }
    count--;
    return false;
  }

  /** Sets v and the weights, and drops the corners that v does not depend on. */
  private void reduce() {
    if (count == 1) {
      weight[0] = 1.0;
      gapX = wx[0];
      gapY = wy[0];
    } else if (count == 2) {
      reduceTo(0, 1);
    } else if (!originInside()) {
      int first = 0;
      int second = 1;
      double least = squaredFromSegment(0, 1);
      double d = squaredFromSegment(1, 2);
      if (d < least) {
        least = d;
        first = 1;
        second = 2;
      }
      if (squaredFromSegment(0, 2) < least) {
        first = 0;
        second = 2;
      }
      reduceTo(first, second);
    }
  }

  /** Tests the triangle by its three partial areas, which are the weights of the corners. */
  private boolean originInside() {
    double a = wx[1] * wy[2] - wy[1] * wx[2];
    double b = wx[2] * wy[0] - wy[2] * wx[0];
    double d = wx[0] * wy[1] - wy[0] * wx[1];
    boolean inside = (a > 0.0 && b > 0.0 && d > 0.0) || (a < 0.0 && b < 0.0 && d < 0.0);
    if (inside) {
      double sum = a + b + d;
      weight[0] = a / sum;
      weight[1] = b / sum;
      weight[2] = d / sum;
      gapX = 0.0;
      gapY = 0.0;
    }
    return inside;
  }

  /** Position of the point of segment i j closest to the origin, 0 at i and 1 at j. */
  private double closestFraction(int i, int j) {
    double ex = wx[j] - wx[i];
    double ey = wy[j] - wy[i];
    double along = -(wx[i] * ex + wy[i] * ey);
    double squared = ex * ex + ey * ey;
    if (!(along > 0.0)) {
      return 0.0;
    }
    return along < squared ? along / squared : 1.0;
  }

  private double squaredFromSegment(int i, int j) {
    double f = closestFraction(i, j);
    double x = wx[i] + f * (wx[j] - wx[i]);
    double y = wy[i] + f * (wy[j] - wy[i]);
    return x * x + y * y;
  }

  private void reduceTo(int i, int j) {
    double f = closestFraction(i, j);
    if (f == 0.0) {
      keep(0, i);
      count = 1;
    } else if (f == 1.0) {
      keep(0, j);
      count = 1;
    } else {
      // In this order: i < j, so that no corner is overwritten before it is read.
      keep(0, i);
      keep(1, j);
      count = 2;
    }
    if (count == 1) {
      weight[0] = 1.0;
      gapX = wx[0];
      gapY = wy[0];
      return;
    }
    weight[0] = 1.0 - f;
    weight[1] = f;
    // The foot of the perpendicular; more exact than the weighted sum when it is short.
    double ex = wx[1] - wx[0];
    double ey = wy[1] - wy[0];
    double height = (ex * wy[0] - ey * wx[0]) / (ex * ex + ey * ey);
    gapX = -ey * height;
    gapY = ex * height;
  }

  private void keep(int to, int from) {
    wx[to] = wx[from];
    wy[to] = wy[from];
    indexA[to] = indexA[from];
    indexB[to] = indexB[from];
  }

  private void writeResult(boolean overlap) {
    double ax = 0.0;
    double ay = 0.0;
    double bx = 0.0;
    double by = 0.0;
    for (int i = 0; i < count; i++) {
      Vec2 a = proxyA.m_vertices[indexA[i]];
      Vec2 b = proxyB.m_vertices[indexB[i]];
      ax += weight[i] * a.x;
      ay += weight[i] * a.y;
      bx += weight[i] * b.x;
      by += weight[i] * b.y;
    }
    pointAX = ax;
    pointAY = ay;
    pointBX = c * bx - s * by + tx;
    pointBY = s * bx + c * by + ty;
    distance = overlap ? 0.0 : Math.sqrt(gapX * gapX + gapY * gapY);
  }

  private void storeSimplex(SimplexCache cache) {
    cache.count = count;
    for (int i = 0; i < count; i++) {
      cache.indexA[i] = indexA[i];
      cache.indexB[i] = indexB[i];
    }
    double metric = 0.0;
    if (count > 1) {
      double ex = wx[1] - wx[0];
      double ey = wy[1] - wy[0];
      metric =
          count == 2 ? Math.sqrt(ex * ex + ey * ey) : ex * (wy[2] - wy[0]) - ey * (wx[2] - wx[0]);
    }
    cache.metric = (float) metric;
  }
}
