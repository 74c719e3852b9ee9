package org.jbox2d.fracture.voronoi;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.InCircle;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.geometry.SortedIndices;

/**
 * Delaunay triangulation by divide and conquer with exact predicates: O(n log n) for every input,
 * also collinear, cocircular and repeated points. Of repeated points only the one with the lowest
 * index takes part.
 *
 * <p>Source: L. Guibas, J. Stolfi, "Primitives for the Manipulation of General Subdivisions and the
 * Computation of Voronoi Diagrams", ACM Transactions on Graphics 4 (1985), section 9; strips first,
 * so that few long edges are made only to be deleted again, after R. Dwyer, "A Faster
 * Divide-and-Conquer Algorithm for Constructing Delaunay Triangulations", Algorithmica 2 (1987).
 * Points are numbered by <em>rank</em>: their place in the order of strips, of about the square
 * root of n / log n. An undirected edge is a pair of directed ones, e and {@code e ^ 1}; each knows
 * its origin and its neighbours among the edges of the same origin, counter-clockwise ({@link
 * #next}) and clockwise ({@link #previous}):
 *
 * <pre>
 *        next(e)
 *           \      left face of e
 *            \
 *   origin(e) o-----------&gt; e
 *            /
 *           /      right face of e
 *     previous(e)
 * </pre>
 *
 * <p>An instance owns its arrays and reuses them: once it has seen as many points, it allocates
 * nothing. Not for use by two threads at once.
 */
public final class Delaunay {
  private static final int NONE = -1;

  /** From this number of points on strips are used. */
  private static final int SMALLEST_IN_STRIPS = 16;

  /** Least number of distinct points in a strip; two would do. */
  private static final int SMALLEST_STRIP = 4;

  private final InCircle inCircle = new InCircle();

  private int siteCount;
  private int count;
  private int stripCount;
  private int[] stripStart = new int[2];
  private int[] bucketEnd = new int[1];
  private int[] bucketed = new int[0];
  private int[] first = new int[0];
  private int[] order = new int[0];
  private int[] scratch = new int[0];
  private double[] keyX = new double[0];
  private double[] keyY = new double[0];
  private int[] rankOfSite = new int[0];
  private int[] siteOfRank = new int[0];
  private double[] x = new double[0];
  private double[] y = new double[0];

  private int edgeEnd;
  private int freeEdge;
  private int[] origin = new int[0];
  private int[] next = new int[0];
  private int[] previous = new int[0];
  private int[] firstEdge = new int[0];

  /** Leftmost and rightmost hull edges, what {@link #divide} returns. */
  private int leftEdge;

  private int rightEdge;

  /**
   * Triangulates n points.
   *
   * @param xy interleaved coordinates, at least 2 n; not changed
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public void compute(double[] xy, int n) {
    sortAndNumber(xy, n);
    edgeEnd = 0;
    freeEdge = NONE;
    leftEdge = NONE;
    rightEdge = NONE;
    if (count > 1) {
      divideStrips(0, stripCount);
    }
    for (int e = 0; e < edgeEnd; e++) {
      if (origin[e] >= 0) {
        firstEdge[origin[e]] = e;
      }
    }
  }

  /** Number of distinct points, which are the ranks 0 to this less 1. */
  public int count() {
    return count;
  }

  /** Rank of the point with index i as given; repeated points share their rank. */
  public int rankOfSite(int i) {
    return rankOfSite[i];
  }

  /** Index, as given, of the point of a rank: the lowest index if it was repeated. */
  public int siteOfRank(int rank) {
    return siteOfRank[rank];
  }

  /** x of the point of a rank. */
  public double x(int rank) {
    return x[rank];
  }

  /** y of the point of a rank. */
  public double y(int rank) {
    return y[rank];
  }

  /** One past the highest directed edge; not every number below is in use. */
  public int edgeEnd() {
    return edgeEnd;
  }

  /** Whether a directed edge is in use. */
  public boolean isEdge(int e) {
    return origin[e] >= 0;
  }

  /** Rank of the point a directed edge starts from. */
  public int origin(int e) {
    return origin[e];
  }

  /** Rank of the point a directed edge ends in. */
  public int destination(int e) {
    return origin[e ^ 1];
  }

  /** Next edge, counter-clockwise, with the same origin. */
  public int next(int e) {
    return next[e];
  }

  /** Next edge, clockwise, with the same origin. */
  public int previous(int e) {
    return previous[e];
  }

  /** Next edge along the face left of e, which starts where e ends. */
  public int nextLeft(int e) {
    return previous[e ^ 1];
  }

  /** An edge from the point of a rank, or -1 if there is no edge at all. */
  public int firstEdge(int rank) {
    return count > 1 ? firstEdge[rank] : NONE;
  }

  /** A directed hull edge whose left face is the unbounded one, or -1 if there is no edge. */
  public int hullEdge() {
    return count > 1 ? leftEdge ^ 1 : NONE;
  }

  /** Whether a triangle lies left of e. */
  public boolean hasTriangleLeft(int e) {
    int f = nextLeft(e);
    int g = nextLeft(f);
    return nextLeft(g) == e && g != f && f != e && leftOf(origin[g], origin[e], origin[f]);
  }

  /**
   * Side of the point opposite on the right of e relative to the circumcircle of the triangle left
   * of e: +1 inside (not Delaunay), 0 on the circle, -1 outside. Both sides of e must have
   * triangles.
   */
  public int inCircleSign(int e) {
    return inCircle(origin[e], origin[e ^ 1], destination(next[e]), destination(previous[e]));
  }

  /**
   * Replaces the diagonal e of the quadrilateral of its two triangles by the other diagonal; e
   * keeps its number and turns counter-clockwise. The result need not be Delaunay; for the
   * insertion of constraints.
   */
  public void flip(int e) {
    int a = previous[e];
    int b = previous[e ^ 1];
    firstEdge[origin[e]] = a;
    firstEdge[origin[e ^ 1]] = b;
    splice(e, a);
    splice(e ^ 1, b);
    splice(e, nextLeft(a));
    splice(e ^ 1, nextLeft(b));
    origin[e] = origin[a ^ 1];
    origin[e ^ 1] = origin[b ^ 1];
  }

  private void sortAndNumber(double[] xy, int n) {
    ensurePoints(n);
    siteCount = n;
    double minX = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      double px = xy[2 * i];
      double py = xy[2 * i + 1];
      if (px * 0 + py * 0 != 0) {
        throw new IllegalArgumentException(
            "site " + i + " is not finite: (" + px + ", " + py + ")");
      }
      keyX[i] = -px;
      keyY[i] = py;
      minX = Math.min(minX, px);
      maxX = Math.max(maxX, px);
    }
    int buckets = fillBuckets(n, minX, maxX);
    makeStrips(buckets);
    for (int rank = 0; rank < count; rank++) {
      int i = order[rank];
      siteOfRank[rank] = i;
      x[rank] = -keyX[i];
      y[rank] = keyY[i];
      rankOfSite[i] = rank;
    }
    for (int i = 0; i < n; i++) {
      if (first[i] != i) {
        rankOfSite[i] = rankOfSite[first[i]];
      }
    }
  }

  /**
   * Distributes the points to buckets of equal width in x, in {@link #bucketed}; returns the number
   * of buckets.
   */
  private int fillBuckets(int n, double minX, double maxX) {
    int buckets = 1;
    while (n >= SMALLEST_IN_STRIPS && buckets * buckets * Math.getExponent((float) n) < n) {
      buckets++;
    }
    if (bucketEnd.length < buckets) {
      bucketEnd = new int[2 * buckets];
      stripStart = new int[2 * buckets + 1];
    }
    Arrays.fill(bucketEnd, 0, buckets, 0);
    double scale = maxX > minX ? buckets / (maxX - minX) : 0;
    for (int i = 0; i < n; i++) {
      int bucket = Math.min(buckets - 1, (int) ((-keyX[i] - minX) * scale));
      scratch[i] = bucket;
      bucketEnd[bucket]++;
    }
    for (int k = 1; k < buckets; k++) {
      bucketEnd[k] += bucketEnd[k - 1];
    }
    for (int i = n - 1; i >= 0; i--) {
      bucketed[--bucketEnd[scratch[i]]] = i;
    }
    // The ends have become starts: shift them back.
    for (int k = 0; k + 1 < buckets; k++) {
      bucketEnd[k] = bucketEnd[k + 1];
    }
    bucketEnd[buckets - 1] = n;
    return buckets;
  }

  /**
   * Makes strips of one bucket or, if that has too few distinct points, several. A strip is sorted
   * by y, then descending x, then index; of equal points only the first stays.
   */
  private void makeStrips(int buckets) {
    count = 0;
    stripCount = 0;
    int taken = 0;
    for (int k = 0; k < buckets; k++) {
      int start = stripCount == 0 ? 0 : stripStart[stripCount];
      stripStart[0] = 0;
      for (; taken < bucketEnd[k]; taken++) {
        order[count++] = bucketed[taken];
      }
      sortStrip(start);
      if (count - start >= SMALLEST_STRIP) {
        stripStart[++stripCount] = count;
      }
    }
    int start = stripCount == 0 ? 0 : stripStart[stripCount];
    if (stripCount == 0) {
      stripCount = 1;
    } else if (count > start) {
      sortStrip(stripStart[stripCount - 1]);
    }
    stripStart[stripCount] = count;
  }

  private void sortStrip(int start) {
    SortedIndices.sort(order, start, count, keyY, keyX, scratch);
    int end = count;
    count = start;
    for (int k = start; k < end; k++) {
      int i = order[k];
      int kept = count == start ? NONE : order[count - 1];
      if (kept != NONE && keyX[i] == keyX[kept] && keyY[i] == keyY[kept]) {
        first[i] = kept;
      } else {
        first[i] = i;
        order[count++] = i;
      }
    }
  }

  /** Number of points given, repeated ones included. */
  public int siteCount() {
    return siteCount;
  }

  private void ensurePoints(int n) {
    if (order.length >= n) {
      return;
    }
    int size = Math.max(n, order.length + order.length / 2);
    order = new int[size];
    scratch = new int[size];
    keyX = new double[size];
    keyY = new double[size];
    rankOfSite = new int[size];
    first = new int[size];
    bucketed = new int[size];
    siteOfRank = new int[size];
    x = new double[size];
    y = new double[size];
    firstEdge = new int[size];
    // Euler: at most 3n - 6 edges at any time; deleted ones are used again, and a merge inserts
    // before it deletes.
    origin = new int[6 * size];
    next = new int[6 * size];
    previous = new int[6 * size];
  }

  private boolean leftOf(int p, int a, int b) {
    return Predicates.orientation(x[a], y[a], x[b], y[b], x[p], y[p]) > 0;
  }

  private int inCircle(int a, int b, int c, int d) {
    return inCircle.sign(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d]);
  }

  private int makeEdge(int from, int to) {
    int e = freeEdge;
    if (e == NONE) {
      e = edgeEnd;
      edgeEnd += 2;
    } else {
      freeEdge = next[e];
    }
    origin[e] = from;
    origin[e ^ 1] = to;
    next[e] = e;
    previous[e] = e;
    next[e ^ 1] = e ^ 1;
    previous[e ^ 1] = e ^ 1;
    return e;
  }

  /**
   * Joins the edge rings of a and b if they are apart, or cuts them apart if they are one (Guibas
   * and Stolfi, section 4).
   */
  private void splice(int a, int b) {
    int afterA = next[a];
    int afterB = next[b];
    next[a] = afterB;
    previous[afterB] = a;
    next[b] = afterA;
    previous[afterA] = b;
  }

  /** New edge from the end of a to the start of b, such that all three have the same left face. */
  private int connect(int a, int b) {
    int e = makeEdge(origin[a ^ 1], origin[b]);
    splice(e, nextLeft(a));
    splice(e ^ 1, b);
    return e;
  }

  private void deleteEdge(int e) {
    splice(e, previous[e]);
    splice(e ^ 1, previous[e ^ 1]);
    int even = e & ~1;
    origin[even] = NONE;
    origin[even + 1] = NONE;
    next[even] = freeEdge;
    freeEdge = even;
  }

  /**
   * Triangulates the strips {@code low} to {@code high} - 1. Leaves in {@link #leftEdge} the
   * counter-clockwise hull edge out of the first point in order of x, then y; in {@link #rightEdge}
   * the clockwise hull edge out of the last one.
   */
  private void divideStrips(int low, int high) {
    if (high - low == 1) {
      divide(stripStart[low], stripStart[high]);
      if (stripCount > 1) {
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
    for (int e = next[leftEdge ^ 1]; e != leftEdge; e = next[e ^ 1]) {
      if (isBefore(origin[e], origin[lowest])) {
        lowest = e;
      }
      if (isBefore(origin[highest], origin[e])) {
        highest = e;
      }
    }
    leftEdge = lowest;
    rightEdge = previous[highest];
  }

  private boolean isBefore(int p, int q) {
    return x[p] < x[q] || (x[p] == x[q] && y[p] < y[q]);
  }

  /**
   * Triangulates the ranks start to end - 1 of one strip, at least two. Leaves in {@link #leftEdge}
   * the counter-clockwise hull edge out of the first point, in {@link #rightEdge} the clockwise
   * hull edge out of the last one. Points ordered by y, then descending x, are ordered by x, then
   * y, for an observer turned by 90 degrees; nothing else in the algorithm depends on the frame.
   */
  private void divide(int start, int end) {
    if (end - start == 2) {
      leftEdge = makeEdge(start, start + 1);
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
    int a = makeEdge(p, p + 1);
    int b = makeEdge(p + 1, p + 2);
    splice(a ^ 1, b);
    int turn = Predicates.orientation(x[p], y[p], x[p + 1], y[p + 1], x[p + 2], y[p + 2]);
    leftEdge = a;
    rightEdge = b ^ 1;
    if (turn > 0) {
      connect(b, a);
    } else if (turn < 0) {
      int c = connect(b, a);
      leftEdge = c ^ 1;
      rightEdge = c;
    }
  }

  /** Joins two triangulations from their lower common tangent upwards ("rising bubble"). */
  private void merge(int outerLeft, int innerLeft, int innerRight, int outerRight) {
    int l = innerLeft;
    int r = innerRight;
    while (true) {
      if (leftOf(origin[r], origin[l], origin[l ^ 1])) {
        l = nextLeft(l);
      } else if (leftOf(origin[l], origin[r ^ 1], origin[r])) {
        r = next[r ^ 1];
      } else {
        break;
      }
    }
    int base = connect(r ^ 1, l);
    leftEdge = origin[l] == origin[outerLeft] ? base ^ 1 : outerLeft;
    rightEdge = origin[r] == origin[outerRight] ? base : outerRight;
    while (true) {
      int left = leftCandidate(base);
      int right = rightCandidate(base);
      boolean leftValid = above(left, base);
      boolean rightValid = above(right, base);
      if (!leftValid && !rightValid) {
        return;
      }
      boolean takeRight =
          !leftValid
              || (rightValid
                  && inCircle(origin[left ^ 1], origin[left], origin[right], origin[right ^ 1])
                      > 0);
      base = takeRight ? connect(right, base ^ 1) : connect(base ^ 1, left ^ 1);
    }
  }

  /**
   * Whether edge e ends left of the directed line of the base's twin, that is above the bubble's
   * base.
   */
  private boolean above(int e, int base) {
    return leftOf(origin[e ^ 1], origin[base ^ 1], origin[base]);
  }

  /**
   * Whether a point is inside the circle through the base and the end of candidate e, which then is
   * not Delaunay.
   */
  private boolean hides(int point, int e, int base) {
    int left = origin[base ^ 1];
    int right = origin[base];
    return point != left && point != right && inCircle(left, right, origin[e ^ 1], point) > 0;
  }

  /**
   * First edge from the base's left end that survives: edges whose circle holds the next one's end
   * are deleted.
   */
  private int leftCandidate(int base) {
    int e = next[base ^ 1];
    if (above(e, base)) {
      while (hides(origin[next[e] ^ 1], e, base)) {
        int after = next[e];
        deleteEdge(e);
        e = after;
      }
    }
    return e;
  }

  private int rightCandidate(int base) {
    int e = previous[base];
    if (above(e, base)) {
      while (hides(origin[previous[e] ^ 1], e, base)) {
        int after = previous[e];
        deleteEdge(e);
        e = after;
      }
    }
    return e;
  }
}
