package org.jbox2d.fracture.triangulation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.voronoi.Delaunay;

/**
 * Triangulates by the Delaunay triangulation of the vertices, into which the edges of the outline
 * are forced by flips; the triangles left of the outline's edges, and what they reach without
 * crossing one, are inside. All decisions are exact, so it succeeds for every simple outline; holes
 * and rings that touch in vertices are no special case.
 *
 * <p>Source: S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
 * Computers &amp; Structures 47 (1993). The last step there, restoring the Delaunay property beside
 * the new edges, is left out: the diagonals are removed again anyway.
 */
public final class DelaunayTriangulator implements Triangulator {
  private final Delaunay delaunay = new Delaunay();
  private boolean[] constrained = new boolean[0];
  private boolean[] inside = new boolean[0];
  private int[] queue = new int[0];

  @Override
  public boolean triangulate(Outline outline, TriangleMesh mesh) {
    delaunay.compute(outline.coordinates(), outline.vertexCount());
    int edges = delaunay.edgeEnd();
    if (queue.length < edges) {
      constrained = new boolean[2 * edges];
      inside = new boolean[2 * edges];
      queue = new int[2 * edges];
    }
    Arrays.fill(constrained, 0, edges, false);
    Arrays.fill(inside, 0, edges, false);
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = delaunay.rankOfSite(outline.ringEnd(r) - 1);
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        int next = delaunay.rankOfSite(i);
        if (!force(last, next)) {
          return false;
        }
        last = next;
      }
    }
    return collect(outline, mesh);
  }

  // ---- constraints ----

  /** Makes a-b an edge and marks it; false if a vertex lies on it. */
  private boolean force(int a, int b) {
    int e = find(a, b);
    if (e < 0) {
      int crossing = queueCrossing(a, b);
      if (crossing < 0) {
        return false;
      }
      flipAway(a, b, crossing);
      e = find(a, b);
    }
    if (e >= 0) {
      constrained[e] = true;
      constrained[e ^ 1] = true;
    }
    return e >= 0;
  }

  private int find(int a, int b) {
    int first = delaunay.firstEdge(a);
    int e = first;
    do {
      if (delaunay.destination(e) == b) {
        return e;
      }
      e = delaunay.next(e);
    } while (e != first);
    return -1;
  }

  /** Sign of the turn a, b, c. */
  private int turn(int a, int b, int c) {
    return Predicates.orientation(
        delaunay.x(a), delaunay.y(a), delaunay.x(b), delaunay.y(b), delaunay.x(c), delaunay.y(c));
  }

  /**
   * Walks from a to b and queues the edges crossed. Each is seen from the triangle before it, so it
   * starts right of a-b and ends left of it.
   *
   * @return how many, or -1 if a vertex lies on a-b
   */
  private int queueCrossing(int a, int b) {
    int first = delaunay.firstEdge(a);
    int e = first;
    while (!(turn(a, delaunay.destination(e), b) > 0
        && turn(a, delaunay.destination(delaunay.next(e)), b) < 0)) {
      e = delaunay.next(e);
      if (e == first) {
        return -1;
      }
    }
    int count = 0;
    int crossed = delaunay.nextLeft(e);
    while (true) {
      if (constrained[crossed]) {
        return -1;
      }
      queue[count++] = crossed;
      int beyond = delaunay.nextLeft(crossed ^ 1);
      int apex = delaunay.destination(beyond);
      if (apex == b) {
        return count;
      }
      int side = turn(a, b, apex);
      if (side == 0) {
        return -1;
      }
      crossed = side > 0 ? beyond : delaunay.nextLeft(beyond);
    }
  }

  /**
   * Flips queued edges whose quadrilateral is strictly convex until none crosses a-b (Sloan,
   * section 3.3).
   */
  private void flipAway(int a, int b, int crossing) {
    int size = queue.length;
    int head = 0;
    int count = crossing;
    while (count > 0) {
      int e = queue[head];
      head = head + 1 == size ? 0 : head + 1;
      count--;
      int p = delaunay.destination(delaunay.next(e));
      int q = delaunay.destination(delaunay.previous(e));
      boolean convex = turn(p, q, delaunay.origin(e)) * turn(p, q, delaunay.destination(e)) < 0;
      if (convex) {
        delaunay.flip(e);
        boolean crosses = p != a && p != b && q != a && q != b && turn(a, b, p) * turn(a, b, q) < 0;
        if (!crosses) {
          continue;
        }
      }
      int tail = head + count;
      queue[tail >= size ? tail - size : tail] = e;
      count++;
    }
  }

  // ---- triangles ----

  private boolean collect(Outline outline, TriangleMesh mesh) {
    mesh.clear();
    int count = 0;
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = delaunay.rankOfSite(outline.ringEnd(r) - 1);
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        int next = delaunay.rankOfSite(i);
        count = enter(find(last, next), count, mesh);
        if (count < 0) {
          return false;
        }
        last = next;
      }
    }
    for (int k = 0; k < count; k++) {
      int e = queue[k];
      for (int side = 0; side < 3; side++) {
        if (!constrained[e]) {
          count = enter(e ^ 1, count, mesh);
          if (count < 0) {
            return false;
          }
        }
        e = delaunay.nextLeft(e);
      }
    }
    return mesh.link(outline.vertexCount());
  }

  /**
   * Adds the triangle left of e unless it has been; returns the new length of the queue, or -1 if
   * there is no triangle.
   */
  private int enter(int e, int count, TriangleMesh mesh) {
    if (inside[e]) {
      return count;
    }
    int f = delaunay.nextLeft(e);
    int g = delaunay.nextLeft(f);
    if (delaunay.nextLeft(g) != e
        || turn(delaunay.origin(e), delaunay.origin(f), delaunay.origin(g)) <= 0) {
      return -1;
    }
    inside[e] = true;
    inside[f] = true;
    inside[g] = true;
    mesh.add(
        delaunay.siteOfRank(delaunay.origin(e)),
        delaunay.siteOfRank(delaunay.origin(f)),
        delaunay.siteOfRank(delaunay.origin(g)));
    queue[count] = e;
    return count + 1;
  }
}
