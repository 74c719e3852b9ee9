package org.jbox2d.fracture.geometry;

/**
 * Exact in-circle test. An instance owns the scratch room of the exact fallback, so that inputs
 * full of ties (grids, circles) cost no garbage; use one per thread.
 *
 * <p>Source: Shewchuk 1997 (see {@link Predicates}), section 4.3. Range as for {@link Predicates}.
 */
public final class InCircle {
  /** Relative error bound of the plain evaluation (section 4.3, "A" bound). */
  private static final double BOUND =
      (10 + 96 * Predicates.UNIT_ROUNDOFF) * Predicates.UNIT_ROUNDOFF;

  private final Expansion[] difference = new Expansion[6];
  private final Expansion product1 = new Expansion(8);
  private final Expansion product2 = new Expansion(8);
  private final Expansion minor = new Expansion(16);
  private final Expansion lift = new Expansion(16);
  private final Expansion term = new Expansion(512);
  private final Expansion total = new Expansion(1536);
  private final Expansion next = new Expansion(1536);
  private final Expansion scratch1 = new Expansion(1536);
  private final Expansion scratch2 = new Expansion(1536);

  /** Creates a test with its own scratch room. */
  public InCircle() {
    for (int i = 0; i < difference.length; i++) {
      difference[i] = new Expansion(2);
    }
  }

  /**
   * Side of point d relative to the circle through a, b, c.
   *
   * @return for a, b, c counter-clockwise: +1 if d is strictly inside, -1 if strictly outside, 0 if
   *     on the circle; the opposite for a, b, c clockwise
   */
  public int sign(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double adx = ax - dx;
    double ady = ay - dy;
    double bdx = bx - dx;
    double bdy = by - dy;
    double cdx = cx - dx;
    double cdy = cy - dy;

    double bc = bdx * cdy;
    double cb = cdx * bdy;
    double aLift = adx * adx + ady * ady;
    double ca = cdx * ady;
    double ac = adx * cdy;
    double bLift = bdx * bdx + bdy * bdy;
    double ab = adx * bdy;
    double ba = bdx * ady;
    double cLift = cdx * cdx + cdy * cdy;

    double determinant = aLift * (bc - cb) + bLift * (ca - ac) + cLift * (ab - ba);
    double permanent =
        (Math.abs(bc) + Math.abs(cb)) * aLift
            + (Math.abs(ca) + Math.abs(ac)) * bLift
            + (Math.abs(ab) + Math.abs(ba)) * cLift;
    double bound = BOUND * permanent;
    if (Math.abs(determinant) > bound) {
      return Predicates.signOf(determinant);
    }
    return exact(ax, ay, bx, by, cx, cy, dx, dy);
  }

  /** The same, for points a, b, c, d of an array of interleaved coordinates. */
  public int sign(double[] xy, int a, int b, int c, int d) {
    return sign(
        xy[2 * a],
        xy[2 * a + 1],
        xy[2 * b],
        xy[2 * b + 1],
        xy[2 * c],
        xy[2 * c + 1],
        xy[2 * d],
        xy[2 * d + 1]);
  }

  /** Apart from {@link #sign}, to keep that small enough to be compiled into its callers. */
  private int exact(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    setDifference(0, ax, dx);
    setDifference(1, ay, dy);
    setDifference(2, bx, dx);
    setDifference(3, by, dy);
    setDifference(4, cx, dx);
    setDifference(5, cy, dy);
    return exactSign();
  }

  private void setDifference(int i, double p, double q) {
    double rounded = p - q;
    difference[i].setPair(Predicates.differenceTail(p, q, rounded), rounded);
  }

  /** |a|^2 (b x c) + |b|^2 (c x a) + |c|^2 (a x b), with a, b, c relative to d. */
  private int exactSign() {
    total.setPair(0, 0);
    for (int i = 0; i < 3; i++) {
      Expansion px = difference[2 * i];
      Expansion py = difference[2 * i + 1];
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      product1.setProduct(difference[2 * j], difference[2 * k + 1], scratch1, scratch2);
      product2.setProduct(difference[2 * k], difference[2 * j + 1], scratch1, scratch2);
      minor.setDifference(product1, product2);
      product1.setProduct(px, px, scratch1, scratch2);
      product2.setProduct(py, py, scratch1, scratch2);
      lift.setSum(product1, product2);
      term.setProduct(minor, lift, scratch1, scratch2);
      next.setSum(total, term);
      total.set(next);
    }
    return total.sign();
  }
}
