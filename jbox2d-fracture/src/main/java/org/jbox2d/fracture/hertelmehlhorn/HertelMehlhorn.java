package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.geometry.SortedIndices;
import org.jbox2d.fracture.triangulation.TriangleMesh;

/**
 * Removes the inessential diagonals of a triangulation: those whose removal leaves a convex part of
 * no more vertices than allowed. Never more than four times as many parts as need be, if vertices
 * are not limited.
 *
 * <p>Source: S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons", Foundations of
 * Computation Theory (1983). Which diagonals are essential depends on the order; {@link Order}
 * names those that are tried.
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
  /** Order in which diagonals are looked at. */
  enum Order {
    /** As the triangulation gave them. */
    AS_FOUND,
    /** Longest first. */
    LONGEST_FIRST,
    /** Shortest first. */
    SHORTEST_FIRST
  }

  private TriangleMesh mesh;
  private double[] xy;
  private int[] after = new int[96];
  private int[] before = new int[96];
  private int[] part = new int[96];
  private int[] parent = new int[32];
  private int[] corners = new int[32];
  private int[] diagonal = new int[96];
  private int[] scratch = new int[96];
  private double[] key = new double[96];
  private int partCount;

  /** Merges triangles; returns the number of parts. */
  int merge(Outline outline, TriangleMesh triangles, int mostVertices, Order order) {
    mesh = triangles;
    xy = outline.coordinates();
    begin();
    int diagonals = collect(order);
    for (int k = 0; k < diagonals; k++) {
      tryRemove(diagonal[k], mostVertices);
    }
    return partCount;
  }

  private void begin() {
    int n = mesh.halfEdgeCount();
    if (after.length < n) {
      after = new int[2 * n];
      before = new int[2 * n];
      part = new int[2 * n];
      parent = new int[2 * n];
      corners = new int[2 * n];
      diagonal = new int[2 * n];
      scratch = new int[2 * n];
      key = new double[2 * n];
    }
    for (int h = 0; h < n; h++) {
      int following = TriangleMesh.following(h);
      after[h] = following;
      before[following] = h;
      part[h] = h / 3;
    }
    partCount = mesh.triangleCount();
    for (int t = 0; t < partCount; t++) {
      parent[t] = t;
      corners[t] = 3;
    }
  }

  private int collect(Order order) {
    int count = 0;
    for (int h = 0; h < mesh.halfEdgeCount(); h++) {
      if (h < mesh.twin(h)) {
        diagonal[count++] = h;
        key[h] = order == Order.LONGEST_FIRST ? -squaredLength(h) : squaredLength(h);
      }
    }
    if (order != Order.AS_FOUND) {
      SortedIndices.sort(diagonal, count, key, key, scratch);
    }
    return count;
  }

  private double squaredLength(int h) {
    int a = mesh.vertex(h);
    int b = mesh.vertex(TriangleMesh.following(h));
    double dx = xy[2 * b] - xy[2 * a];
    double dy = xy[2 * b + 1] - xy[2 * a + 1];
    return dx * dx + dy * dy;
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
    int own = root(part[h]);
    int other = root(part[t]);
    if (own == other) {
      return;
    }
    int atStart = turn(before[h], after[t]);
    int atEnd = turn(before[t], after[h]);
    if (atStart < 0 || atEnd < 0) {
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
    return Predicates.orientation(
        xy, mesh.vertex(h), mesh.vertex(next), mesh.vertex(TriangleMesh.following(next)));
  }

  /** The parts of the last merge. */
  ConvexParts parts() {
    int n = mesh.halfEdgeCount();
    double[] out = new double[2 * n];
    int[] starts = new int[partCount + 1];
    boolean[] done = new boolean[n];
    int size = 0;
    int count = 0;
    for (int h = 0; h < n; h++) {
      if (done[h] || after[h] < 0) {
        continue;
      }
      int e = h;
      do {
        done[e] = true;
        if (turn(before[e], e) != 0) {
          out[2 * size] = xy[2 * mesh.vertex(e)];
          out[2 * size + 1] = xy[2 * mesh.vertex(e) + 1];
          size++;
        }
        e = after[e];
      } while (e != h);
      starts[++count] = size;
    }
    return new ConvexParts(Arrays.copyOf(out, 2 * size), starts);
  }
}
