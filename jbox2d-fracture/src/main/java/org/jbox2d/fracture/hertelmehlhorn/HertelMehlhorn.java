package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.KeyOrder;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.triangulation.TriangleMesh;

/**
 * Removes the inessential diagonals of a triangulation: those whose removal leaves a convex part of
 * no more vertices than allowed. Never more than four times as many parts as need be, if vertices
 * are not limited.
 *
 * <p>Source: S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons", Foundations of
 * Computation Theory (1983). Which diagonals are essential depends on the order, {@link
 * DiagonalOrder}.
 *
 * <p>Parts are closed lists of half-edges. Removing the diagonal h with twin t joins two lists:
 *
 * <pre>
 *        \    part of h   /
 *   before \   h ----&gt;  / after h
 *           o-----------o
 *  after t /   &lt;---- t   \ before t
 *         /   part of t   \
 * </pre>
 *
 * <p>A vertex with a straight angle in a part is no vertex of that part: it does not count, and is
 * left out of the result.
 */
final class HertelMehlhorn {
  private final KeyOrder byLength = new KeyOrder();
  private TriangleMesh mesh;

  /** Interleaved coordinates of the vertices that the half-edges start from. */
  private double[] start = new double[0];

  /**
   * The diagonals that may be removed, and their lengths. One whose two triangles alone have a
   * reflex angle at an end is essential in every order: parts only grow.
   */
  private int diagonalCount;

  private int[] diagonal = new int[0];
  private double[] squaredLength = new double[0];
  private int[] shortestFirst;

  /** For each half-edge the next and the last one of its triangle, and the triangle. */
  private int[] following = new int[0];

  private int[] preceding = new int[0];
  private int[] triangle = new int[0];

  /** The lists of parts: neighbours of a half-edge, and the part it bounds. */
  private int[] after = new int[0];

  private int[] before = new int[0];
  private int[] part = new int[0];
  private int[] corners = new int[0];

  /**
   * Diagonals of the merge under way that stay, and whether one that went left a straight angle.
   */
  private int kept;

  private boolean straight;

  /** The lists of the merge that gave the fewest parts, and what stayed there. */
  private int[] bestAfter = new int[0];

  private int[] bestBefore = new int[0];
  private int bestKept;
  private boolean bestStraight;
  private double[] out = new double[0];

  /** Takes up a triangulation. */
  void begin(Outline outline, TriangleMesh triangles) {
    mesh = triangles;
    int n = mesh.halfEdgeCount();
    ensure(n);
    double[] xy = outline.coordinates();
    // What is kept of a list is as good as random: it is written down before that is known.
    int count = 0;
    for (int h = 0; h < n; h++) {
      int v = mesh.vertex(h);
      start[2 * h] = xy[2 * v];
      start[2 * h + 1] = xy[2 * v + 1];
      diagonal[count] = h;
      count += (h - mesh.twin(h)) >>> 31;
    }
    diagonalCount = 0;
    for (int k = 0; k < count; k++) {
      int h = diagonal[k];
      int t = mesh.twin(h);
      int turns = turn(preceding[h], following[t]) | turn(preceding[t], following[h]);
      diagonal[diagonalCount] = h;
      squaredLength[diagonalCount] = squaredLength(h);
      diagonalCount += 1 + (turns >> 31);
    }
    shortestFirst = null;
    bestKept = Integer.MAX_VALUE;
  }

  private void ensure(int n) {
    if (after.length < n) {
      int size = n + n / 2;
      after = new int[size];
      before = new int[size];
      bestAfter = new int[size];
      bestBefore = new int[size];
      part = new int[size];
      corners = new int[size];
      diagonal = new int[size];
      squaredLength = new double[size];
      out = new double[2 * size];
      start = new double[2 * size];
      following = new int[size];
      preceding = new int[size];
      triangle = new int[size];
      for (int h = 0; h < size; h++) {
        following[h] = TriangleMesh.following(h);
        preceding[h] = TriangleMesh.following(following[h]);
        triangle[h] = h / 3;
      }
    }
  }

  private double squaredLength(int h) {
    int next = following[h];
    double dx = start[2 * next] - start[2 * h];
    double dy = start[2 * next + 1] - start[2 * h + 1];
    return dx * dx + dy * dy;
  }

  /**
   * Merges the triangles in an order, unless it becomes certain that an earlier one gave as few
   * parts.
   *
   * @return whether another order may give fewer parts than the best one until now
   */
  boolean merge(int mostVertices, DiagonalOrder order) {
    int n = mesh.halfEdgeCount();
    System.arraycopy(following, 0, after, 0, n);
    System.arraycopy(preceding, 0, before, 0, n);
    System.arraycopy(triangle, 0, part, 0, n);
    Arrays.fill(corners, 0, mesh.triangleCount(), 3);
    kept = 0;
    straight = false;
    if (order == DiagonalOrder.LONGEST_FIRST) {
      removeLongestFirst(mostVertices);
    } else if (order == DiagonalOrder.SHORTEST_FIRST) {
      removeShortestFirst(mostVertices);
    } else {
      removeAsFound(mostVertices);
    }
    if (kept < bestKept) {
      keep();
    }
    return bestKept > 0;
  }

  private void removeAsFound(int mostVertices) {
    for (int k = 0; k < diagonalCount && kept < bestKept; k++) {
      tryRemove(diagonal[k], mostVertices);
    }
  }

  private void removeShortestFirst(int mostVertices) {
    sort();
    for (int k = 0; k < diagonalCount && kept < bestKept; k++) {
      tryRemove(diagonal[shortestFirst[k]], mostVertices);
    }
  }

  /** Backwards, but diagonals of the same length in the order in which they were found. */
  private void removeLongestFirst(int mostVertices) {
    sort();
    int end = diagonalCount;
    while (end > 0 && kept < bestKept) {
      int first = end - 1;
      double length = squaredLength[shortestFirst[first]];
      while (first > 0 && squaredLength[shortestFirst[first - 1]] == length) {
        first--;
      }
      for (int k = first; k < end; k++) {
        tryRemove(diagonal[shortestFirst[k]], mostVertices);
      }
      end = first;
    }
  }

  private void sort() {
    if (shortestFirst == null) {
      shortestFirst = byLength.ascending(squaredLength, diagonalCount);
    }
  }

  /** One branch for all conditions, of which each alone is as good as random. */
  private void tryRemove(int h, int mostVertices) {
    int t = mesh.twin(h);
    int atStart = turn(before[h], after[t]);
    int atEnd = turn(before[t], after[h]);
    int own = part[h];
    int other = part[t];
    int united = corners[own] + corners[other] - 4 + atStart + atEnd;
    if ((atStart | atEnd | (mostVertices - united)) < 0 || own == other) {
      kept++;
      return;
    }
    straight |= (atStart & atEnd) == 0;
    // The smaller list, mostly a triangle, goes to the part of the larger one.
    if (corners[own] < corners[other]) {
      relabel(h, other);
    } else {
      relabel(t, own);
    }
    corners[part[t]] = united;
    join(before[h], after[t]);
    join(before[t], after[h]);
    after[h] = -1;
    after[t] = -1;
  }

  private void relabel(int first, int to) {
    int e = first;
    do {
      part[e] = to;
      e = after[e];
    } while (e != first);
  }

  private void join(int h, int next) {
    after[h] = next;
    before[next] = h;
  }

  /** Turn at the vertex where half-edge h ends and the next one starts. */
  private int turn(int h, int next) {
    return Predicates.orientation(start, h, next, following[next]);
  }

  private void keep() {
    bestKept = kept;
    bestStraight = straight;
    int[] swap = bestAfter;
    bestAfter = after;
    after = swap;
    swap = bestBefore;
    bestBefore = before;
    before = swap;
  }

  /** The parts of the first of the merges since {@link #begin} that gave the fewest; once. */
  ConvexParts fewestParts() {
    int n = mesh.halfEdgeCount();
    int size = 0;
    int[] starts = new int[mesh.triangleCount() - diagonalCount + bestKept + 1];
    int count = 0;
    for (int h = 0; h < n; h++) {
      if (bestAfter[h] < 0) {
        continue;
      }
      int e = h;
      while (bestAfter[e] >= 0) {
        if (!bestStraight || turn(bestBefore[e], e) != 0) {
          out[2 * size] = start[2 * e];
          out[2 * size + 1] = start[2 * e + 1];
          size++;
        }
        int next = bestAfter[e];
        bestAfter[e] = -1;
        e = next;
      }
      starts[++count] = size;
    }
    return new ConvexParts(Arrays.copyOf(out, 2 * size), starts);
  }
}
