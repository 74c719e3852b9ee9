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

  /** Numbers in {@link #centre} for each face, the last of them not used. */
  private static final int STRIDE = 4;

  private Delaunay delaunay;
  private int[] records;
  private Clip clip;
  private int count;
  private int[] parent = new int[0];

  /**
   * For each face the circumcentre and the square of the distance within which another is the same
   * or may be: a share of the radius, or infinite if the centre is not known well.
   */
  private double[] centre = new double[0];

  /**
   * Finds all faces and notes at each directed edge the one on its left; centres near the border of
   * the rectangle are put on it.
   */
  void compute(Delaunay triangulation, Clip rectangle) {
    delaunay = triangulation;
    records = triangulation.records();
    clip = rectangle;
    int directed = delaunay.edgeEnd();
    // A face has three directed edges.
    if (parent.length < directed / 3 + 1) {
      int size = directed + directed / 2;
      parent = new int[size / 3 + 1];
      centre = new double[STRIDE * (size / 3 + 1)];
    }
    markUnboundedFace();
    count = 0;
    for (int e = 0; e < directed; e++) {
      if (EdgeRings.note(records, e) == EdgeRings.UNNOTED && EdgeRings.origin(records, e) >= 0) {
        takeFace(count++, e);
      }
    }
    uniteCocircular(directed);
  }

  /** Number of faces before those with one centre were united. */
  int count() {
    return count;
  }

  double x(int face) {
    return centre[STRIDE * face];
  }

  double y(int face) {
    return centre[STRIDE * face + 1];
  }

  private void markUnboundedFace() {
    int hull = delaunay.hullEdge();
    if (hull == NONE) {
      return;
    }
    int e = hull;
    do {
      EdgeRings.setNote(records, e, NONE);
      e = EdgeRings.nextLeft(records, e);
    } while (e != hull);
  }

  /**
   * Notes a triangle at its edges and finds its circumcentre. With A, B, C its corners and U = B -
   * A, V = C - A (thesis, section 3) that is
   *
   * <pre>
   * S = A + (Vy |U|^2 - Uy |V|^2, Ux |V|^2 - Vx |U|^2) / (2 U x V)
   * </pre>
   *
   * A is the start of the shortest side, so that the numerators do not cancel; U x V is evaluated
   * with compensation. Any side is as likely the shortest.
   */
  private void takeFace(int face, int e) {
    double[] xy = delaunay.coordinates();
    int f = EdgeRings.nextLeft(records, e);
    int g = EdgeRings.nextLeft(records, f);
    EdgeRings.setNote(records, e, face);
    EdgeRings.setNote(records, f, face);
    EdgeRings.setNote(records, g, face);
    parent[face] = face;
    int p = 2 * EdgeRings.origin(records, e);
    int q = 2 * EdgeRings.origin(records, f);
    int r = 2 * EdgeRings.origin(records, g);
    double le = squaredDistance(xy, p, q);
    double lf = squaredDistance(xy, q, r);
    double lg = squaredDistance(xy, r, p);
    int ifF = signMask(lf - le);
    int ifG = signMask(lg - le) & signMask(lg - lf);
    int a = choose(ifG, r, choose(ifF, q, p));
    int b = choose(ifG, p, choose(ifF, r, q));
    int c = p ^ q ^ r ^ a ^ b;
    double ax = xy[a];
    double ay = xy[a + 1];
    double ux = xy[b] - ax;
    double uy = xy[b + 1] - ay;
    double uu = ux * ux + uy * uy;
    double vx = xy[c] - ax;
    double vy = xy[c + 1] - ay;
    double vv = vx * vx + vy * vy;
    double cross = Predicates.crossValue(ux, vy, uy, vx);
    double product = uu * vv;
    boolean wellShaped = cross * cross > WELL_SHAPED * WELL_SHAPED * product;
    if (!wellShaped) {
      // The differences may have been rounded; then the sign may be lost, but the triangle is known
      // to have an area.
      cross = Math.max(cross, LEAST_CROSS * Math.sqrt(product));
    }
    double twiceCross = 2 * cross;
    double sx = (vy * uu - uy * vv) / twiceCross;
    double sy = (ux * vv - vx * uu) / twiceCross;
    int k = STRIDE * face;
    centre[k] = clip.ontoBorderX(ax + sx);
    centre[k + 1] = clip.ontoBorderY(ay + sy);
    centre[k + 2] = SAME_CENTRE * SAME_CENTRE * (sx * sx + sy * sy);
    if (!wellShaped) {
      centre[k + 2] = Double.POSITIVE_INFINITY;
    }
  }

  private static double squaredDistance(double[] xy, int p, int q) {
    double dx = xy[q] - xy[p];
    double dy = xy[q + 1] - xy[p + 1];
    return dx * dx + dy * dy;
  }

  /** All ones for a negative number, zero for others. */
  private static int signMask(double value) {
    return (int) (Double.doubleToRawLongBits(value) >> 63);
  }

  /** The first of two numbers if the mask is all ones, the second if it is zero. */
  private static int choose(int mask, int first, int second) {
    return second ^ ((first ^ second) & mask);
  }

  // ---- cocircular triangles ----

  private void uniteCocircular(int directed) {
    boolean any = false;
    for (int e = 0; e < directed; e += 2) {
      int f = EdgeRings.note(records, e);
      int g = EdgeRings.note(records, e + 1);
      // The inside has numbers from 0; an edge that is not in use was never seen.
      if ((f | g) >= 0 && mayBeCocircular(f, g) && delaunay.inCircleSign(e) == 0) {
        f = root(f);
        g = root(g);
        parent[Math.max(f, g)] = Math.min(f, g);
        any = true;
      }
    }
    for (int e = 0; any && e < directed; e++) {
      if (EdgeRings.note(records, e) >= 0) {
        EdgeRings.setNote(records, e, root(EdgeRings.note(records, e)));
      }
    }
  }

  /** False if the centres of two faces are known well and differ by far more than rounding. */
  private boolean mayBeCocircular(int f, int g) {
    int j = STRIDE * f;
    int k = STRIDE * g;
    double dx = centre[j] - centre[k];
    double dy = centre[j + 1] - centre[k + 1];
    double squaredDistance = dx * dx + dy * dy;
    return squaredDistance <= centre[j + 2] || squaredDistance <= centre[k + 2];
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
