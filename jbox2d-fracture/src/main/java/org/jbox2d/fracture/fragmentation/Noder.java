package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.geometry.Segments;
import org.jbox2d.fracture.geometry.SortedIndices;

/**
 * Splits segments at each other until no two of them share a point but a common end node.
 *
 * <p>Rounds: every <em>dirty</em> segment is compared with all near it; ends that lie within the
 * snapping distance of a segment split it, ends that near to another end are welded to it, proper
 * crossings get a node of their own. What was split or moved is dirty in the next round. The end is
 * reached when a round finds nothing: then every pair that ever changed has been found apart by
 * exact predicates, on the rounded coordinates that are the result. So the rounding of a crossing
 * cannot leave an undetected overlap. The idea of iterating with a tolerance far above rounding is
 * that of D. Halperin and E. Packer, "Iterated Snap Rounding", Computational Geometry 23 (2002).
 *
 * <p>Coordinates are of order one. Segments added clean are known not to meet each other.
 */
final class Noder {
  /** Rounds after which the noder gives up. Two or three are usual. */
  private static final int MAXIMUM_ROUNDS = 32;

  private final SegmentGrid grid = new SegmentGrid();

  private double snap;
  private int nodeCount;
  private double[] xy = new double[64];
  private int[] alias = new int[32];

  private int count;
  private int[] from = new int[64];
  private int[] to = new int[64];
  private int[] left = new int[64];
  private int[] right = new int[64];
  private boolean[] outline = new boolean[64];
  private boolean[] dirty = new boolean[64];

  private int splitCount;
  private int[] splitSegment = new int[64];
  private int[] splitNode = new int[64];
  private double[] splitParameter = new double[64];
  private int[] splitOrder = new int[64];
  private int[] splitScratch = new int[64];

  /** For each segment the place of its first split in the order. */
  private int[] splitStart = new int[64];

  /** Whether something was moved, not only cut, in this round. */
  private boolean bent;

  /** Starts anew. Points nearer than {@code snapDistance}, which is far above rounding, are one. */
  void clear(double snapDistance) {
    snap = snapDistance;
    nodeCount = 0;
    count = 0;
  }

  int addNode(double x, double y) {
    if (2 * nodeCount == xy.length) {
      xy = Arrays.copyOf(xy, 2 * xy.length);
      alias = Arrays.copyOf(alias, 2 * alias.length);
    }
    xy[2 * nodeCount] = x;
    xy[2 * nodeCount + 1] = y;
    alias[nodeCount] = nodeCount;
    return nodeCount++;
  }

  /**
   * Adds a segment.
   *
   * @param leftLabel label of what is left of it
   * @param isOutline whether it belongs to the outline, whose interior is on its left
   * @param isDirty whether it may meet segments that are not dirty
   */
  void addSegment(int a, int b, int leftLabel, int rightLabel, boolean isOutline, boolean isDirty) {
    if (count == from.length) {
      int size = 2 * count;
      from = Arrays.copyOf(from, size);
      to = Arrays.copyOf(to, size);
      left = Arrays.copyOf(left, size);
      right = Arrays.copyOf(right, size);
      outline = Arrays.copyOf(outline, size);
      dirty = Arrays.copyOf(dirty, size);
    }
    from[count] = a;
    to[count] = b;
    left[count] = leftLabel;
    right[count] = rightLabel;
    outline[count] = isOutline;
    dirty[count] = isDirty;
    count++;
  }

  int nodeCount() {
    return nodeCount;
  }

  /** Interleaved coordinates of the nodes; not a copy. */
  double[] coordinates() {
    return xy;
  }

  int segmentCount() {
    return count;
  }

  int from(int s) {
    return from[s];
  }

  int to(int s) {
    return to[s];
  }

  int left(int s) {
    return left[s];
  }

  int right(int s) {
    return right[s];
  }

  boolean isOutline(int s) {
    return outline[s];
  }

  /** Splits all segments; false if that did not come to an end. */
  boolean node() {
    for (int round = 0; round < MAXIMUM_ROUNDS; round++) {
      splitCount = 0;
      bent = false;
      grid.build(xy, from, to, count, snap);
      for (int s = 0; s < count; s++) {
        if (dirty[s]) {
          compareWithNear(s);
        }
      }
      if (splitCount == 0 && !bent) {
        return true;
      }
      boolean settled = !bent && crossingsAreApart();
      applyChanges();
      if (settled) {
        return true;
      }
    }
    return false;
  }

  private void compareWithNear(int s) {
    int near = grid.query(s);
    for (int k = 0; k < near; k++) {
      int t = grid.found(k);
      if (!dirty[t] || t > s) {
        compare(s, t);
      }
    }
  }

  /**
   * Whether every new crossing is farther from all segments but its own two than the snapping
   * distance. If nothing was snapped in this round, that settles the matter. For the parts of a
   * segment s leave s by no more than rounding, so ends of other segments are as far from them as
   * they were found to be from s; the crossings are apart from other segments by this test, from
   * each other too, since each lies on two segments; and two parts of crossing segments have the
   * crossing as common end.
   */
  private boolean crossingsAreApart() {
    for (int k = 0; k < splitCount; k += 2) {
      int node = splitNode[k];
      double x = xy[2 * node];
      double y = xy[2 * node + 1];
      int near = grid.query(x, y);
      for (int i = 0; i < near; i++) {
        int t = grid.found(i);
        if (t != splitSegment[k]
            && t != splitSegment[k + 1]
            && Segments.distanceSquared(xy, from[t], to[t], x, y) <= 4 * snap * snap) {
          return false;
        }
      }
    }
    return true;
  }

  // ---- one pair ----

  private void compare(int s, int t) {
    int a = from[s];
    int b = to[s];
    int c = from[t];
    int d = to[t];
    boolean aShared = a == c || a == d;
    boolean bShared = b == c || b == d;
    if (aShared && bShared) {
      return;
    }
    if (aShared || bShared) {
      int shared = aShared ? a : b;
      if (!snap(c == shared ? d : c, s)) {
        snap(aShared ? b : a, t);
      }
      return;
    }
    if (isBeside(a, b, c, d) || isBeside(c, d, a, b)) {
      return;
    }
    boolean snapped = snap(a, t);
    snapped |= snap(b, t);
    snapped |= snap(c, s);
    snapped |= snap(d, s);
    if (!snapped && crosses(a, b, c, d)) {
      addCrossing(s, t);
    }
  }

  /**
   * Whether c and d are on the same side of the line a-b and so far from it that neither rounding
   * nor snapping matters.
   */
  private boolean isBeside(int a, int b, int c, int d) {
    double ux = xy[2 * b] - xy[2 * a];
    double uy = xy[2 * b + 1] - xy[2 * a + 1];
    double crossC = ux * (xy[2 * c + 1] - xy[2 * a + 1]) - uy * (xy[2 * c] - xy[2 * a]);
    double crossD = ux * (xy[2 * d + 1] - xy[2 * a + 1]) - uy * (xy[2 * d] - xy[2 * a]);
    double margin = 2 * snap * (Math.abs(ux) + Math.abs(uy));
    return (crossC > margin && crossD > margin) || (crossC < -margin && crossD < -margin);
  }

  private boolean crosses(int a, int b, int c, int d) {
    return Predicates.orientation(xy, a, b, c) * Predicates.orientation(xy, a, b, d) < 0
        && Predicates.orientation(xy, c, d, a) * Predicates.orientation(xy, c, d, b) < 0;
  }

  /**
   * Splits segment s at a node that lies on it, or welds the node to an end of s; false if the node
   * is away from s.
   */
  private boolean snap(int node, int s) {
    double x = xy[2 * node];
    double y = xy[2 * node + 1];
    if (Segments.distanceSquared(xy, from[s], to[s], x, y) > snap * snap) {
      return false;
    }
    if (near(node, from[s])) {
      weld(node, from[s]);
    } else if (near(node, to[s])) {
      weld(node, to[s]);
    } else {
      addSplit(s, node);
      bent = true;
    }
    return true;
  }

  private boolean near(int p, int q) {
    double dx = xy[2 * p] - xy[2 * q];
    double dy = xy[2 * p + 1] - xy[2 * q + 1];
    return dx * dx + dy * dy <= snap * snap;
  }

  /**
   * The node of lower index stays: vertices of the outline come first and do not move for a
   * crossing.
   */
  private void weld(int p, int q) {
    int rootP = root(p);
    int rootQ = root(q);
    alias[Math.max(rootP, rootQ)] = Math.min(rootP, rootQ);
    bent = true;
  }

  private int root(int p) {
    int r = p;
    while (alias[r] != r) {
      r = alias[r];
    }
    return r;
  }

  /**
   * The crossing is computed on an edge of the outline if one takes part, to keep that straight.
   */
  private void addCrossing(int s, int t) {
    int u = outline[t] && !outline[s] ? t : s;
    int v = u == s ? t : s;
    double px = xy[2 * from[u]];
    double py = xy[2 * from[u] + 1];
    double ux = xy[2 * to[u]] - px;
    double uy = xy[2 * to[u] + 1] - py;
    double qx = xy[2 * from[v]];
    double qy = xy[2 * from[v] + 1];
    double vx = xy[2 * to[v]] - qx;
    double vy = xy[2 * to[v] + 1] - qy;
    double denominator = Predicates.crossValue(ux, vy, uy, vx);
    double parameter = Predicates.crossValue(qx - px, vy, qy - py, vx) / denominator;
    double bounded = Math.max(0, Math.min(1, parameter));
    int node = addNode(px + bounded * ux, py + bounded * uy);
    addSplit(s, node);
    addSplit(t, node);
  }

  private void addSplit(int s, int node) {
    if (splitCount == splitSegment.length) {
      int size = 2 * splitCount;
      splitSegment = Arrays.copyOf(splitSegment, size);
      splitNode = Arrays.copyOf(splitNode, size);
      splitParameter = new double[size];
      splitOrder = new int[size];
      splitScratch = new int[size];
    }
    splitSegment[splitCount] = s;
    splitNode[splitCount] = node;
    splitCount++;
  }

  // ---- end of a round ----

  private void applyChanges() {
    for (int p = 0; p < nodeCount; p++) {
      alias[p] = root(p);
    }
    sortSplits();
    int old = count;
    for (int s = 0; s < old; s++) {
      dirty[s] = alias[from[s]] != from[s] || alias[to[s]] != to[s];
    }
    int k = 0;
    while (k < splitCount) {
      k = split(splitSegment[splitOrder[k]], k);
    }
    dropEmptySegments();
  }

  /** Brings the splits in the order of their segments, by counting them, and along each segment. */
  private void sortSplits() {
    if (splitStart.length < count + 1) {
      splitStart = new int[count + count / 2 + 1];
    }
    Arrays.fill(splitStart, 0, count + 1, 0);
    for (int k = 0; k < splitCount; k++) {
      int s = splitSegment[k];
      int a = from[s];
      int p = splitNode[k];
      double ux = xy[2 * to[s]] - xy[2 * a];
      double uy = xy[2 * to[s] + 1] - xy[2 * a + 1];
      splitParameter[k] = (xy[2 * p] - xy[2 * a]) * ux + (xy[2 * p + 1] - xy[2 * a + 1]) * uy;
      splitStart[s]++;
    }
    for (int s = 0; s < count; s++) {
      splitStart[s + 1] += splitStart[s];
    }
    for (int k = splitCount - 1; k >= 0; k--) {
      splitOrder[--splitStart[splitSegment[k]]] = k;
    }
    for (int s = 0; s < count; s++) {
      if (splitStart[s + 1] - splitStart[s] > 1) {
        SortedIndices.sort(
            splitOrder,
            splitStart[s],
            splitStart[s + 1],
            splitParameter,
            splitParameter,
            splitScratch);
      }
    }
  }

  /** Cuts segment s at its splits, which begin at place k of the order; returns where they end. */
  private int split(int s, int k) {
    int end = to[s];
    int last = splitNode[splitOrder[k]];
    to[s] = last;
    dirty[s] = true;
    int next = k + 1;
    for (; next < splitCount && splitSegment[splitOrder[next]] == s; next++) {
      int node = splitNode[splitOrder[next]];
      addSegment(last, node, left[s], right[s], outline[s], true);
      last = node;
    }
    addSegment(last, end, left[s], right[s], outline[s], true);
    return next;
  }

  private void dropEmptySegments() {
    int kept = 0;
    for (int s = 0; s < count; s++) {
      int a = alias[from[s]];
      int b = alias[to[s]];
      if (a != b) {
        from[kept] = a;
        to[kept] = b;
        left[kept] = left[s];
        right[kept] = right[s];
        outline[kept] = outline[s];
        dirty[kept] = dirty[s];
        kept++;
      }
    }
    count = kept;
  }
}
