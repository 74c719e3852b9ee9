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

  /** For each half-edge the one after it in its triangle. */
  private int[] following = new int[0];

  private int[] after = new int[0];
  private int[] before = new int[0];
  private int[] parent = new int[0];
  private int[] corners = new int[0];
  private int partCount;

  /** The lists of the merge that gave the fewest parts, and their number. */
  private int[] bestAfter = new int[0];

  private int[] bestBefore = new int[0];
  private int bestCount;
  private double[] out = new double[0];
  private boolean[] done = new boolean[0];

  /** Takes up a triangulation. */
  void begin(Outline outline, TriangleMesh triangles) {
    mesh = triangles;
    int n = mesh.halfEdgeCount();
    ensure(n);
    double[] xy = outline.coordinates();
    for (int h = 0; h < n; h++) {
      int v = mesh.vertex(h);
      start[2 * h] = xy[2 * v];
      start[2 * h + 1] = xy[2 * v + 1];
    }
    diagonalCount = 0;
    for (int h = 0; h < n; h++) {
      int t = mesh.twin(h);
      if (h < t && turn(preceding(h), following[t]) >= 0 && turn(preceding(t), following[h]) >= 0) {
        squaredLength[diagonalCount] = squaredLength(h);
        diagonal[diagonalCount++] = h;
      }
    }
    shortestFirst = null;
    bestCount = Integer.MAX_VALUE;
  }

  private int preceding(int h) {
    return following[following[h]];
  }

  private void ensure(int n) {
    if (after.length < n) {
      int size = n + n / 2;
      after = new int[size];
      before = new int[size];
      bestAfter = new int[size];
      bestBefore = new int[size];
      parent = new int[size];
      corners = new int[size];
      diagonal = new int[size];
      squaredLength = new double[size];
      out = new double[2 * size];
      start = new double[2 * size];
      done = new boolean[size];
      following = new int[size];
      for (int h = 0; h < size; h++) {
        following[h] = TriangleMesh.following(h);
      }
    }
  }

  private double squaredLength(int h) {
    int next = following[h];
    double dx = start[2 * next] - start[2 * h];
    double dy = start[2 * next + 1] - start[2 * h + 1];
    return dx * dx + dy * dy;
  }

  /** Merges the triangles in an order; returns the number of parts. */
  int merge(int mostVertices, DiagonalOrder order) {
    int n = mesh.halfEdgeCount();
    System.arraycopy(following, 0, after, 0, n);
    for (int h = 0; h < n; h += 3) {
      before[h] = h + 2;
      before[h + 1] = h;
      before[h + 2] = h + 1;
    }
    partCount = mesh.triangleCount();
    for (int t = 0; t < partCount; t++) {
      parent[t] = t;
      corners[t] = 3;
    }
    if (order == DiagonalOrder.LONGEST_FIRST) {
      removeLongestFirst(mostVertices);
    } else if (order == DiagonalOrder.SHORTEST_FIRST) {
      removeShortestFirst(mostVertices);
    } else {
      removeAsFound(mostVertices);
    }
    if (partCount < bestCount) {
      keep();
    }
    return partCount;
  }

  private void removeAsFound(int mostVertices) {
    for (int k = 0; k < diagonalCount; k++) {
      tryRemove(diagonal[k], mostVertices);
    }
  }

  private void removeShortestFirst(int mostVertices) {
    sort();
    for (int k = 0; k < diagonalCount; k++) {
      tryRemove(diagonal[shortestFirst[k]], mostVertices);
    }
  }

  /** Backwards, but diagonals of the same length in the order in which they were found. */
  private void removeLongestFirst(int mostVertices) {
    sort();
    int end = diagonalCount;
    while (end > 0) {
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

  private int root(int p) {
    int r = p;
    while (parent[r] != r) {
      parent[r] = parent[parent[r]];
      r = parent[r];
    }
    return r;
  }

  private void tryRemove(int h, int mostVertices) {
    int t = mesh.twin(h);
    int atStart = turn(before[h], after[t]);
    if (atStart < 0) {
      return;
    }
    int atEnd = turn(before[t], after[h]);
    if (atEnd < 0) {
      return;
    }
    int own = root(h / 3);
    int other = root(t / 3);
    if (own == other) {
      return;
    }
    int united = corners[own] + corners[other] - 4 + atStart + atEnd;
    if (united > mostVertices) {
      return;
    }
    join(before[h], after[t]);
    join(before[t], after[h]);
    parent[other] = own;
    corners[own] = united;
    after[h] = -1;
    after[t] = -1;
    partCount--;
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
    bestCount = partCount;
    int[] swap = bestAfter;
    bestAfter = after;
    after = swap;
    swap = bestBefore;
    bestBefore = before;
    before = swap;
  }

  /** The parts of the first of the merges since {@link #begin} that gave the fewest. */
  ConvexParts fewestParts() {
    int n = mesh.halfEdgeCount();
    Arrays.fill(done, 0, n, false);
    int size = 0;
    int[] starts = new int[bestCount + 1];
    int count = 0;
    for (int h = 0; h < n; h++) {
      if (done[h] || bestAfter[h] < 0) {
        continue;
      }
      int e = h;
      do {
        done[e] = true;
        if (turn(bestBefore[e], e) != 0) {
          out[2 * size] = start[2 * e];
          out[2 * size + 1] = start[2 * e + 1];
          size++;
        }
        e = bestAfter[e];
      } while (e != h);
      starts[++count] = size;
    }
    return new ConvexParts(Arrays.copyOf(out, 2 * size), starts);
  }
}
