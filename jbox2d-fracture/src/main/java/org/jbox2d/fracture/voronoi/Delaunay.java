package org.jbox2d.fracture.voronoi;

import org.jbox2d.fracture.geometry.InCircle;
import org.jbox2d.fracture.geometry.Predicates;

/**
 * Delaunay triangulation by divide and conquer with exact predicates: O(n log n) for every input,
 * also collinear, cocircular and repeated points. Of repeated points only the one with the lowest
 * index takes part.
 *
 * <p>Source: L. Guibas, J. Stolfi, "Primitives for the Manipulation of General Subdivisions and the
 * Computation of Voronoi Diagrams", ACM Transactions on Graphics 4 (1985), section 9; strips first,
 * so that few long edges are made only to be deleted again, after R. Dwyer, "A Faster
 * Divide-and-Conquer Algorithm for Constructing Delaunay Triangulations", Algorithmica 2 (1987).
 * Points are numbered by <em>rank</em>: their place in the order of strips ({@link StripOrder}), of
 * about the square root of n / log n. Edges are directed, e and {@code e ^ 1} the two directions of
 * one ({@link EdgeRings}).
 *
 * <p>An instance owns its arrays and reuses them: once it has seen as many points, it allocates
 * nothing. Not for use by two threads at once.
 */
public final class Delaunay {
  private static final int NONE = EdgeRings.NONE;

  /**
   * Relative error bounds of the determinants in {@link #rise}, with room for the rounding of the
   * bounds themselves; what they leave open is decided by the exact predicates. Source: J. R.
   * Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
   * Discrete &amp; Computational Geometry 18 (1997), the "A" bounds, 3 and 10 units.
   */
  private static final double ABOVE_BOUND = 2 * 0x1p-53;

  private static final double INSIDE_BOUND = 11 * 0x1p-53;

  private final InCircle inCircle = new InCircle();
  private final StripOrder order = new StripOrder();
  private final EdgeRings edges = new EdgeRings();
  private int[] firstEdge = new int[0];

  /** Interleaved coordinates of the points in the order of ranks; the array of {@link #order}. */
  private double[] xy;

  private int count;

  /** Leftmost and rightmost hull edges, what {@link #divide} returns. */
  private int leftEdge;

  private int rightEdge;

  /**
   * Triangulates n points.
   *
   * @param points interleaved coordinates, at least 2 n; not changed
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public void compute(double[] points, int n) {
    order.number(points, n);
    count = order.count();
    xy = order.coordinates();
    if (firstEdge.length < count) {
      firstEdge = new int[xy.length / 2];
    }
    // Euler: at most 3n - 6 edges at any time; deleted ones are used again, and a merge inserts
    // before it deletes.
    edges.clear(6 * firstEdge.length);
    leftEdge = NONE;
    rightEdge = NONE;
    if (count > 1) {
      divideStrips(0, order.stripCount());
    }
    edges.collectOrigins(firstEdge);
  }

  /** Number of points given, repeated ones included. */
  public int siteCount() {
    return order.siteCount();
  }

  /** Number of distinct points, which are the ranks 0 to this less 1. */
  public int count() {
    return count;
  }

  /** Rank of the point with index i as given; repeated points share their rank. */
  public int rankOfSite(int i) {
    return order.rankOfSite(i);
  }

  /** Index, as given, of the point of a rank: the lowest index if it was repeated. */
  public int siteOfRank(int rank) {
    return order.siteOfRank(rank);
  }

  /** x of the point of a rank. */
  public double x(int rank) {
    return xy[2 * rank];
  }

  /** y of the point of a rank. */
  public double y(int rank) {
    return xy[2 * rank + 1];
  }

  /** One past the highest directed edge; not every number below is in use. */
  public int edgeEnd() {
    return edges.end();
  }

  /** Whether a directed edge is in use. */
  public boolean isEdge(int e) {
    return edges.isEdge(e);
  }

  /** Rank of the point a directed edge starts from. */
  public int origin(int e) {
    return edges.origin(e);
  }

  /** Rank of the point a directed edge ends in. */
  public int destination(int e) {
    return edges.destination(e);
  }

  /** Next edge, counter-clockwise, with the same origin. */
  public int next(int e) {
    return edges.next(e);
  }

  /** Next edge, clockwise, with the same origin. */
  public int previous(int e) {
    return edges.previous(e);
  }

  /** Next edge along the face left of e, which starts where e ends. */
  public int nextLeft(int e) {
    return edges.nextLeft(e);
  }

  /** An edge from the point of a rank, or -1 if there is no edge at all. */
  public int firstEdge(int rank) {
    return count > 1 ? firstEdge[rank] : NONE;
  }

  /** A directed hull edge whose left face is the unbounded one, or -1 if there is no edge. */
  public int hullEdge() {
    return count > 1 ? leftEdge ^ 1 : NONE;
  }

  /**
   * The edges themselves, for those who go on from here in loops over all; they may leave a note at
   * each, which {@link #compute} resets.
   */
  int[] records() {
    return edges.records();
  }

  /** Interleaved coordinates of the points in the order of ranks; not a copy. */
  double[] coordinates() {
    return xy;
  }

  /** Whether a triangle lies left of e. */
  public boolean hasTriangleLeft(int e) {
    int f = nextLeft(e);
    int g = nextLeft(f);
    return nextLeft(g) == e && g != f && f != e && leftOf(origin(g), origin(e), origin(f));
  }

  /**
   * Side of the point opposite on the right of e relative to the circumcircle of the triangle left
   * of e: +1 inside (not Delaunay), 0 on the circle, -1 outside. Both sides of e must have
   * triangles.
   */
  public int inCircleSign(int e) {
    return inCircle(origin(e), destination(e), destination(next(e)), destination(previous(e)));
  }

  /**
   * Replaces the diagonal e of the quadrilateral of its two triangles by the other diagonal; e
   * keeps its number and turns counter-clockwise. The result need not be Delaunay; for the
   * insertion of constraints.
   */
  public void flip(int e) {
    firstEdge[origin(e)] = previous(e);
    firstEdge[destination(e)] = previous(e ^ 1);
    edges.flip(e);
  }

  private boolean leftOf(int p, int a, int b) {
    return Predicates.orientation(xy, a, b, p) > 0;
  }

  private int inCircle(int a, int b, int c, int d) {
    return inCircle.sign(xy, a, b, c, d);
  }

  /**
   * Triangulates the strips {@code low} to {@code high} - 1. Leaves in {@link #leftEdge} the
   * counter-clockwise hull edge out of the first point in order of x, then y; in {@link #rightEdge}
   * the clockwise hull edge out of the last one.
   */
  private void divideStrips(int low, int high) {
    if (high - low == 1) {
      divide(order.stripStart(low), order.stripStart(high));
      if (order.stripCount() > 1) {
        turnHandles();
      }
      return;
    }
    int middle = (low + high) >>> 1;
    divideStrips(low, middle);
    int outerLeft = leftEdge;
    int innerLeft = rightEdge;
    divideStrips(middle, high);
    merge(outerLeft, innerLeft, leftEdge, rightEdge);
  }

  /**
   * From the hull edges at the first and last point in a strip's order to those in the order of x,
   * then y.
   */
  private void turnHandles() {
    int lowest = leftEdge;
    int highest = leftEdge;
    for (int e = next(leftEdge ^ 1); e != leftEdge; e = next(e ^ 1)) {
      if (isBefore(origin(e), origin(lowest))) {
        lowest = e;
      }
      if (isBefore(origin(highest), origin(e))) {
        highest = e;
      }
    }
    leftEdge = lowest;
    rightEdge = previous(highest);
  }

  private boolean isBefore(int p, int q) {
    return x(p) < x(q) || (x(p) == x(q) && y(p) < y(q));
  }

  /**
   * Triangulates the ranks start to end - 1 of one strip, at least two. Leaves in {@link #leftEdge}
   * the counter-clockwise hull edge out of the first point, in {@link #rightEdge} the clockwise
   * hull edge out of the last one. Points ordered by y, then descending x, are ordered by x, then
   * y, for an observer turned by 90 degrees; nothing else in the algorithm depends on the frame.
   */
  private void divide(int start, int end) {
    if (end - start == 2) {
      leftEdge = edges.make(start, start + 1);
      rightEdge = leftEdge ^ 1;
      return;
    }
    if (end - start == 3) {
      triangle(start);
      return;
    }
    int middle = (start + end) >>> 1;
    divide(start, middle);
    int outerLeft = leftEdge;
    int innerLeft = rightEdge;
    divide(middle, end);
    merge(outerLeft, innerLeft, leftEdge, rightEdge);
  }

  private void triangle(int p) {
    int a = edges.make(p, p + 1);
    int b = edges.make(p + 1, p + 2);
    edges.splice(a ^ 1, b);
    int turn = Predicates.orientation(xy, p, p + 1, p + 2);
    leftEdge = a;
    rightEdge = b ^ 1;
    if (turn != 0) {
      int c = edges.connect(b, a);
      leftEdge = turn > 0 ? a : c ^ 1;
      rightEdge = turn > 0 ? b ^ 1 : c;
    }
  }

  /** Joins two triangulations from their lower common tangent upwards ("rising bubble"). */
  private void merge(int outerLeft, int innerLeft, int innerRight, int outerRight) {
    int l = innerLeft;
    int r = innerRight;
    while (true) {
      if (leftOf(origin(r), origin(l), destination(l))) {
        l = nextLeft(l);
      } else if (leftOf(origin(l), destination(r), origin(r))) {
        r = next(r ^ 1);
      } else {
        break;
      }
    }
    int base = edges.connect(r ^ 1, l);
    leftEdge = origin(l) == origin(outerLeft) ? base ^ 1 : outerLeft;
    rightEdge = origin(r) == origin(outerRight) ? base : outerRight;
    rise(base);
  }

  /**
   * Connects two triangulations upwards from their lower common tangent: the rising bubble. The
   * base runs from the right point r to the left point l. Its next neighbour is the end c of the
   * first edge of l that survives, or the end e of the first one of r:
   *
   * <pre>
   *      c        e
   *       \      /        c: candidate of l, hidden if the circle l, r, c holds d,
   *     d  \    /  f         the end of the next edge of l; then l-c is deleted
   *      \  \  /  /
   *       \  l---r  /      e: candidate of r, hidden likewise by f
   *          base
   * </pre>
   *
   * All differences are taken from l: b = r - l is the base. With the cross products b x c and b x
   * d, which also tell what is above the base, d is inside the circle if
   *
   * <pre>
   * |b|^2 (c x d) - |c|^2 (b x d) + |d|^2 (b x c) &lt; 0
   * </pre>
   *
   * <p>What is above and which candidate comes next is as good as random, so a processor would
   * guess wrong at every branch. Truths are masks here, made of the signs of determinants: zero for
   * yes. Only deletions branch off, and what the filters leave open. A candidate on the side that
   * stays is kept: the new base lies between it and the old one.
   */
  private void rise(int lowest) {
    int base = lowest;
    int l = destination(base);
    int r = origin(base);
    int left = next(base ^ 1);
    int right = previous(base);
    while (true) {
      double lx = xy[2 * l];
      double ly = xy[2 * l + 1];
      double bx = xy[2 * r] - lx;
      double by = xy[2 * r + 1] - ly;
      double bb = bx * bx + by * by;

      // The left candidate.
      int c = destination(left);
      double cx = xy[2 * c] - lx;
      double cy = xy[2 * c + 1] - ly;
      double cc = cx * cx + cy * cy;
      double bc = bx * cy - by * cx;
      int leftBelow = notAbove(bc, bb + cc, l, r, c);
      int after = next(left);
      int d = destination(after);
      double dx = xy[2 * d] - lx;
      double dy = xy[2 * d + 1] - ly;
      double dd = dx * dx + dy * dy;
      double bd = bx * dy - by * dx;
      double hidden = cc * bd - bb * (cx * dy - cy * dx) - dd * bc;
      if (notInside(leftBelow | same(d, r), hidden, bb, cc, dd, l, r, c, d) == 0) {
        do {
          edges.delete(left);
          left = after;
          after = next(left);
          c = d;
          cx = dx;
          cy = dy;
          cc = dd;
          bc = bd;
          d = destination(after);
          dx = xy[2 * d] - lx;
          dy = xy[2 * d + 1] - ly;
          dd = dx * dx + dy * dy;
          bd = bx * dy - by * dx;
          hidden = cc * bd - bb * (cx * dy - cy * dx) - dd * bc;
        } while (notInside(same(d, r), hidden, bb, cc, dd, l, r, c, d) == 0);
        leftBelow = notAbove(bc, bb + cc, l, r, c);
      }

      // The right candidate.
      int e = destination(right);
      double ex = xy[2 * e] - lx;
      double ey = xy[2 * e + 1] - ly;
      double ee = ex * ex + ey * ey;
      double be = bx * ey - by * ex;
      int rightBelow = notAbove(be, bb + ee, l, r, e);
      after = previous(right);
      int f = destination(after);
      double fx = xy[2 * f] - lx;
      double fy = xy[2 * f + 1] - ly;
      double ff = fx * fx + fy * fy;
      double bf = bx * fy - by * fx;
      hidden = ee * bf - bb * (ex * fy - ey * fx) - ff * be;
      if (notInside(rightBelow | same(f, l), hidden, bb, ee, ff, l, r, e, f) == 0) {
        do {
          edges.delete(right);
          right = after;
          after = previous(right);
          e = f;
          ex = fx;
          ey = fy;
          ee = ff;
          be = bf;
          f = destination(after);
          fx = xy[2 * f] - lx;
          fy = xy[2 * f + 1] - ly;
          ff = fx * fx + fy * fy;
          bf = bx * fy - by * fx;
          hidden = ee * bf - bb * (ex * fy - ey * fx) - ff * be;
        } while (notInside(same(f, l), hidden, bb, ee, ff, l, r, e, f) == 0);
        rightBelow = notAbove(be, bb + ee, l, r, e);
      }

      // The next base: to the right if that is all there is, or if e is inside the circle l, r, c.
      if ((leftBelow & rightBelow) != 0) {
        return;
      }
      hidden = cc * be - bb * (cx * ey - cy * ex) - ee * bc;
      int toLeft = notInside(rightBelow, hidden, bb, cc, ee, l, r, c, e) & ~leftBelow;
      int from = choose(toLeft, base ^ 1, right);
      int to = choose(toLeft, left ^ 1, base ^ 1);
      int leftAfter = next(left ^ 1);
      int rightAfter = previous(right ^ 1);
      l = choose(toLeft, c, l);
      r = choose(toLeft, r, e);
      base = edges.connect(from, to, r, l);
      left = choose(toLeft, leftAfter, left);
      right = choose(toLeft, right, rightAfter);
    }
  }

  /** The first of two numbers if the mask is all ones, the second if it is zero. */
  private static int choose(int mask, int first, int second) {
    return second ^ ((first ^ second) & mask);
  }

  /** Zero for different ranks, all ones for the same. */
  private static int same(int p, int q) {
    return ((p ^ q) - 1) >> 31;
  }

  /**
   * Zero if p is left of the directed line from l to r, else all ones. The cross product is that of
   * r - l and p - l; the sum of their squared lengths is at least twice that of its terms.
   */
  private int notAbove(double cross, double squares, int l, int r, int p) {
    if (Math.abs(cross) > ABOVE_BOUND * squares) {
      return signMask(cross);
    }
    return Predicates.orientation(xy, l, r, p) > 0 ? 0 : -1;
  }

  /**
   * Zero if d is strictly inside the circle through l, r, c and the given mask is zero, else all
   * ones. Three squared lengths, of the differences to l, bound the terms of the determinant: |c x
   * d| is at most (|c|^2 + |d|^2) / 2.
   */
  private int notInside(
      int mask, double determinant, double bb, double cc, double dd, int l, int r, int c, int d) {
    double bound = INSIDE_BOUND * (bb * (cc + dd) + cc * dd);
    int certain = signMask(bound - Math.abs(determinant));
    if ((mask | certain) == 0) {
      return inCircle(l, r, c, d) > 0 ? 0 : -1;
    }
    return mask | signMask(determinant);
  }

  /** All ones for a negative number, zero for others. */
  private static int signMask(double value) {
    return (int) (Double.doubleToRawLongBits(value) >> 63);
  }
}
