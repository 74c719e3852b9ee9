package org.jbox2d.fracture.triangulation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.Predicates;
import org.jbox2d.fracture.voronoi.Delaunay;

/**
 * Triangulates by the Delaunay triangulation of the vertices, into which the edges of the outline
 * are forced by flips; the triangles left of the outline's edges, and what they reach without
 * crossing one, are inside. All decisions are exact, so it succeeds for every simple outline; holes
 * and rings that touch in vertices are no special case.
 *
 * <p>It also fails for every outline whose edges meet where they may not: at any time there is a
 * plane subdivision with straight edges, since only diagonals of strictly convex quadrilaterals are
 * flipped. So if each edge of the outline has become an edge of its own there, no two of them share
 * more than an end. Where points are repeated, rings might still cross there, or visit a point
 * twice: then the outline is checked.
 *
 * <p>Source: S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
 * Computers &amp; Structures 47 (1993). The last step there, restoring the Delaunay property beside
 * the new edges, is left out: the diagonals are removed again anyway.
 */
public final class DelaunayTriangulator implements Triangulator {
  /** States of a directed edge; others are the half-edge of the mesh it has become. */
  private static final int UNSEEN = -1;

  private static final int UNBOUNDED = -2;

  private final Delaunay delaunay = new Delaunay();
  private final OutlineCheck check = new OutlineCheck();
  private boolean[] constrained = new boolean[0];
  private int[] state = new int[0];
  private int[] queue = new int[0];

  /** For each vertex the directed edge that the edge of the outline to it has become. */
  private int[] edgeTo = new int[0];

  private int[] following = new int[0];

  @Override
  public boolean refusesCrossings() {
    return true;
  }

  @Override
  public boolean triangulate(Outline outline, TriangleMesh mesh) {
    delaunay.compute(outline.coordinates(), outline.vertexCount());
    prepare(outline.vertexCount());
    if (delaunay.count() < 3
        || (delaunay.count() < outline.vertexCount() && !check.run(outline, true))) {
      return false;
    }
    boolean forced =
        delaunay.count() == outline.vertexCount() ? forceMissing(outline) : forceAll(outline);
    return forced && collect(outline, mesh);
  }

  private void prepare(int vertices) {
    int edges = delaunay.edgeEnd();
    if (queue.length < edges) {
      constrained = new boolean[2 * edges];
      state = new int[2 * edges];
      queue = new int[2 * edges];
    }
    if (edgeTo.length < vertices + 1) {
      edgeTo = new int[2 * vertices];
      following = new int[2 * vertices];
    }
    Arrays.fill(constrained, 0, edges, false);
    Arrays.fill(state, 0, edges, UNSEEN);
  }

  // ---- constraints ----

  private boolean forceAll(Outline outline) {
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = delaunay.rankOfSite(outline.ringEnd(r) - 1);
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        int next = delaunay.rankOfSite(i);
        edgeTo[i] = force(last, next);
        if (edgeTo[i] < 0) {
          return false;
        }
        last = next;
      }
    }
    return true;
  }

  /**
   * The same if no point is repeated: most edges of the outline are edges of the triangulation
   * already. These are found by one look at each of its edges, without a branch, since about every
   * other is one.
   */
  private boolean forceMissing(Outline outline) {
    int n = outline.vertexCount();
    for (int r = 0; r < outline.ringCount(); r++) {
      int end = outline.ringEnd(r);
      for (int i = outline.ringStart(r); i < end; i++) {
        following[i] = i + 1 < end ? i + 1 : outline.ringStart(r);
      }
    }
    Arrays.fill(edgeTo, 0, n, -1);
    // Place n takes what is no edge of the outline.
    for (int e = 0; e < delaunay.edgeEnd(); e += 2) {
      if (delaunay.isEdge(e)) {
        int a = delaunay.siteOfRank(delaunay.origin(e));
        int b = delaunay.siteOfRank(delaunay.destination(e));
        int along = same(following[a], b);
        int against = same(following[b], a);
        edgeTo[n ^ ((n ^ b) & along)] = e;
        edgeTo[n ^ ((n ^ a) & against)] = e + 1;
      }
    }
    for (int i = 0; i < n; i++) {
      int e = edgeTo[i];
      if (e >= 0) {
        constrained[e] = true;
        constrained[e ^ 1] = true;
      }
    }
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = outline.ringEnd(r) - 1;
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        if (edgeTo[i] < 0) {
          int e = force(delaunay.rankOfSite(last), delaunay.rankOfSite(i));
          if (e < 0) {
            return false;
          }
          edgeTo[i] = e;
        }
        last = i;
      }
    }
    return true;
  }

  private static int same(int p, int q) {
    return ((p ^ q) - 1) >> 31;
  }

  /**
   * Makes a-b an edge and marks it.
   *
   * @return the edge, or -1 if a vertex lies on a-b, or it crosses or is an edge of the outline
   */
  private int force(int a, int b) {
    int e = find(a, b);
    if (e < 0) {
      int crossing = queueCrossing(a, b);
      if (crossing < 0) {
        return -1;
      }
      flipAway(a, b, crossing);
      e = find(a, b);
    }
    if (e < 0 || constrained[e]) {
      return -1;
    }
    constrained[e] = true;
    constrained[e ^ 1] = true;
    return e;
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
    int following = delaunay.next(e);
    boolean left = turn(a, delaunay.destination(e), b) > 0;
    int side = turn(a, delaunay.destination(following), b);
    while (!left || side >= 0) {
      left = side > 0;
      e = following;
      if (e == first) {
        return -1;
      }
      following = delaunay.next(e);
      side = turn(a, delaunay.destination(following), b);
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
      side = turn(a, b, apex);
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
    markUnboundedFace();
    int count = 0;
    for (int i = 0; i < outline.vertexCount(); i++) {
      int e = edgeTo[i];
      if (state[e] < 0) {
        if (state[e] == UNBOUNDED) {
          return false;
        }
        enter(e, mesh);
        queue[count++] = e;
      }
    }
    for (int k = 0; k < count; k++) {
      int e = queue[k];
      for (int side = 0; side < 3; side++) {
        if (!constrained[e]) {
          int across = e ^ 1;
          if (state[across] < 0) {
            if (state[across] == UNBOUNDED) {
              return false;
            }
            enter(across, mesh);
            queue[count++] = across;
          }
          mesh.linkTwins(state[e], state[across]);
        }
        e = delaunay.nextLeft(e);
      }
    }
    return true;
  }

  private void markUnboundedFace() {
    int hull = delaunay.hullEdge();
    int e = hull;
    do {
      state[e] = UNBOUNDED;
      e = delaunay.nextLeft(e);
    } while (e != hull);
  }

  /** Adds the triangle left of e. */
  private void enter(int e, TriangleMesh mesh) {
    int f = delaunay.nextLeft(e);
    int g = delaunay.nextLeft(f);
    int h = mesh.halfEdgeCount();
    state[e] = h;
    state[f] = h + 1;
    state[g] = h + 2;
    mesh.add(
        delaunay.siteOfRank(delaunay.origin(e)),
        delaunay.siteOfRank(delaunay.origin(f)),
        delaunay.siteOfRank(delaunay.origin(g)));
  }
}
