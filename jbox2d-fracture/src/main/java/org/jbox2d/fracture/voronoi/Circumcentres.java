package org.jbox2d.fracture.voronoi;

import org.jbox2d.fracture.geometry.Predicates;

/**
 * The bounded faces of a Delaunay triangulation and their circumcentres. Triangles whose
 * circumcircles are the same are one face, so that they have one centre; whether they are is
 * decided exactly. Owns its arrays and reuses them.
 */
final class Circumcentres {
  /** The face of the outside. */
  static final int NONE = -1;

  private static final int UNSEEN = -2;

  /**
   * Sine of the angle between two sides of a triangle above which its circumcentre is known to a
   * relative error of about 2^-52 over this, even if the differences of coordinates were rounded.
   */
  private static final double WELL_SHAPED = 1e-6;

  /**
   * Centres of well-shaped triangles that differ by more than this share of the radius are not the
   * same; rounding is below 1e-9.
   */
  private static final double SAME_CENTRE = 1e-7;

  /**
   * Sine that stands for those too small to be told from zero: the centre is so far away that only
   * its direction matters.
   */
  private static final double LEAST_CROSS = 1e-25;

  /** Numbers in {@link #side} for each side: its start, the vector to its end, its length. */
  private static final int SIDE = 5;

  private Delaunay delaunay;
  private Clip clip;
  private int count;
  private boolean[] wellShaped = new boolean[0];
  private int[] parent = new int[0];
  private double[] centre = new double[0];
  private final double[] side = new double[3 * SIDE];

  /**
   * Finds all faces and notes at each directed edge the one on its left; centres near the border of
   * the rectangle are put on it.
   */
  void compute(Delaunay triangulation, Clip rectangle) {
    delaunay = triangulation;
    clip = rectangle;
    int directed = delaunay.edgeEnd();
    // A face has three directed edges.
    if (parent.length < directed / 3 + 1) {
      int size = directed + directed / 2;
      parent = new int[size / 3 + 1];
      wellShaped = new boolean[size / 3 + 1];
      centre = new double[2 * (size / 3 + 1)];
    }
    for (int e = 0; e < directed; e++) {
      delaunay.setNote(e, UNSEEN);
    }
    markUnboundedFace();
    numberFaces(directed);
    uniteCocircular(directed);
  }

  /** Number of faces before those with one centre were united. */
  int count() {
    return count;
  }

  double x(int face) {
    return centre[2 * face];
  }

  double y(int face) {
    return centre[2 * face + 1];
  }

  private void markUnboundedFace() {
    int hull = delaunay.hullEdge();
    if (hull == NONE) {
      return;
    }
    int e = hull;
    do {
      delaunay.setNote(e, NONE);
      e = delaunay.nextLeft(e);
    } while (e != hull);
  }

  private void numberFaces(int directed) {
    count = 0;
    for (int e = 0; e < directed; e++) {
      if (delaunay.note(e) != UNSEEN || !delaunay.isEdge(e)) {
        continue;
      }
      int f = delaunay.nextLeft(e);
      int g = delaunay.nextLeft(f);
      delaunay.setNote(e, count);
      delaunay.setNote(f, count);
      delaunay.setNote(g, count);
      parent[count] = count;
      computeCentre(count, delaunay.origin(e), delaunay.origin(f), delaunay.origin(g));
      count++;
    }
  }

  /**
   * Circumcentre of triangle A, B, C with U = B - A, V = C - A (thesis, section 3):
   *
   * <pre>
   * S = A + (Vy |U|^2 - Uy |V|^2, Ux |V|^2 - Vx |U|^2) / (2 U x V)
   * </pre>
   *
   * A is the start of the shortest side, so that the numerators do not cancel; U x V is evaluated
   * with compensation. The sides are put into a table and the shortest is looked up there: any is
   * as likely, and a branch would be guessed wrong twice in three times.
   */
  private void computeCentre(int face, int p, int q, int r) {
    double le = setSide(0, p, q);
    double lf = setSide(SIDE, q, r);
    double lg = setSide(2 * SIDE, r, p);
    int shortest = le <= lf ? 0 : SIDE;
    shortest = Math.min(le, lf) <= lg ? shortest : 2 * SIDE;
    int before = shortest == 0 ? 2 * SIDE : shortest - SIDE;
    double ux = side[shortest + 2];
    double uy = side[shortest + 3];
    double uu = side[shortest + 4];
    double vx = -side[before + 2];
    double vy = -side[before + 3];
    double vv = side[before + 4];
    double cross = Predicates.crossValue(ux, vy, uy, vx);
    double product = uu * vv;
    boolean good = cross * cross > WELL_SHAPED * WELL_SHAPED * product;
    wellShaped[face] = good;
    if (!good) {
      // The differences may have been rounded; then the sign may be lost, but the triangle is known
      // to have an area.
      cross = Math.max(cross, LEAST_CROSS * Math.sqrt(product));
    }
    double twiceCross = 2 * cross;
    double cx = side[shortest] + (vy * uu - uy * vv) / twiceCross;
    double cy = side[shortest + 1] + (ux * vv - vx * uu) / twiceCross;
    centre[2 * face] = clip.ontoBorderX(cx);
    centre[2 * face + 1] = clip.ontoBorderY(cy);
  }

  /** Enters the side from p to q; returns its squared length. */
  private double setSide(int k, int p, int q) {
    double px = delaunay.x(p);
    double py = delaunay.y(p);
    double dx = delaunay.x(q) - px;
    double dy = delaunay.y(q) - py;
    double squaredLength = dx * dx + dy * dy;
    side[k] = px;
    side[k + 1] = py;
    side[k + 2] = dx;
    side[k + 3] = dy;
    side[k + 4] = squaredLength;
    return squaredLength;
  }

  // ---- cocircular triangles ----

  private void uniteCocircular(int directed) {
    boolean any = false;
    for (int e = 0; e < directed; e += 2) {
      // The inside has numbers from 0; an edge that is not in use was never seen.
      if ((delaunay.note(e) | delaunay.note(e + 1)) >= 0
          && mayBeCocircular(e)
          && delaunay.inCircleSign(e) == 0) {
        int f = root(delaunay.note(e));
        int g = root(delaunay.note(e + 1));
        parent[Math.max(f, g)] = Math.min(f, g);
        any = true;
      }
    }
    for (int e = 0; any && e < directed; e++) {
      if (delaunay.note(e) >= 0) {
        delaunay.setNote(e, root(delaunay.note(e)));
      }
    }
  }

  /**
   * False if the centres on both sides of an edge are known well and differ by far more than
   * rounding.
   */
  private boolean mayBeCocircular(int e) {
    int f = delaunay.note(e);
    int g = delaunay.note(e + 1);
    if (!wellShaped[f] || !wellShaped[g]) {
      return true;
    }
    double dx = centre[2 * f] - centre[2 * g];
    double dy = centre[2 * f + 1] - centre[2 * g + 1];
    double rx = centre[2 * f] - delaunay.x(delaunay.origin(e));
    double ry = centre[2 * f + 1] - delaunay.y(delaunay.origin(e));
    return dx * dx + dy * dy <= SAME_CENTRE * SAME_CENTRE * (rx * rx + ry * ry);
  }

  private int root(int f) {
    int r = f;
    while (parent[r] != r) {
      parent[r] = parent[parent[r]];
      r = parent[r];
    }
    return r;
  }
}
