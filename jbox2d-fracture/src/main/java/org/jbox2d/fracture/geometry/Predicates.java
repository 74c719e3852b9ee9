package org.jbox2d.fracture.geometry;

/**
 * Exact orientation of three points in the plane.
 *
 * <p>The sign is that of the real determinant of the given doubles, never of its rounded value. A
 * floating-point filter answers nearly always; what it leaves open is decided by exact products.
 * Source of the filter and of the error-free transformations: J. R. Shewchuk, "Adaptive Precision
 * Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete &amp; Computational
 * Geometry 18 (1997), sections 2 and 4.2.
 *
 * <p>Range: coordinates are zero or have a magnitude between 1e-70 and 1e+70, so that no product
 * under- or overflows. Every finite float satisfies this.
 */
public final class Predicates {
  /** Half the distance from 1 to the next double: the unit roundoff. */
  static final double UNIT_ROUNDOFF = 0x1p-53;

  /**
   * Relative error bound of the plain evaluation of the orientation determinant (section 4.2, "A"
   * bound).
   */
  private static final double ORIENTATION_BOUND = (3 + 16 * UNIT_ROUNDOFF) * UNIT_ROUNDOFF;

  /** 2^27 + 1, which splits a double into two halves of 26 bits (Dekker 1971). */
  private static final double SPLITTER = 0x1p27 + 1;

  private Predicates() {}

  /**
   * Side of point c relative to the directed line from a to b.
   *
   * @return +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they are collinear
   */
  public static int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy);
    double right = (ay - cy) * (bx - cx);
    double determinant = left - right;
    double bound = ORIENTATION_BOUND * (Math.abs(left) + Math.abs(right));
    if (Math.abs(determinant) > bound) {
      return signOf(determinant);
    }
    return exactOrientation(ax, ay, bx, by, cx, cy);
  }

  /**
   * Sign of a number that is not zero, without a branch: either is as likely, so a processor would
   * guess it wrong half of the time.
   */
  static int signOf(double value) {
    return (int) (Double.doubleToRawLongBits(value) >> 63) | 1;
  }

  /** The same, for points k, l, m of an array of interleaved coordinates. */
  public static int orientation(double[] xy, int k, int l, int m) {
    return orientation(
        xy[2 * k], xy[2 * k + 1], xy[2 * l], xy[2 * l + 1], xy[2 * m], xy[2 * m + 1]);
  }

  private static int exactOrientation(
      double ax, double ay, double bx, double by, double cx, double cy) {
    double acx = ax - cx;
    double acy = ay - cy;
    double bcx = bx - cx;
    double bcy = by - cy;
    double acxTail = differenceTail(ax, cx, acx);
    double acyTail = differenceTail(ay, cy, acy);
    double bcxTail = differenceTail(bx, cx, bcx);
    double bcyTail = differenceTail(by, cy, bcy);
    if (acxTail == 0 && acyTail == 0 && bcxTail == 0 && bcyTail == 0) {
      return compareProducts(acx, bcy, acy, bcx);
    }
    Expansion p = new Expansion(2).setPair(acxTail, acx);
    Expansion q = new Expansion(2).setPair(bcyTail, bcy);
    Expansion r = new Expansion(2).setPair(acyTail, acy);
    Expansion s = new Expansion(2).setPair(bcxTail, bcx);
    Expansion scratch = new Expansion(32);
    Expansion scratch2 = new Expansion(32);
    Expansion first = new Expansion(8).setProduct(p, q, scratch, scratch2);
    Expansion second = new Expansion(8).setProduct(r, s, scratch, scratch2);
    return new Expansion(16).setDifference(first, second).sign();
  }

  /**
   * Sign of a*b - c*d, exactly.
   *
   * <p>Rounding is monotone, so the rounded products decide if they differ; if they are equal,
   * their rounding errors, which are representable, decide.
   */
  static int compareProducts(double a, double b, double c, double d) {
    double ab = a * b;
    double cd = c * d;
    if (ab != cd) {
      return ab > cd ? 1 : -1;
    }
    double abTail = productTail(a, b, ab);
    double cdTail = productTail(c, d, cd);
    return abTail > cdTail ? 1 : abTail < cdTail ? -1 : 0;
  }

  /** The value a*b - c*d to nearly full relative precision, however much cancels. */
  public static double crossValue(double a, double b, double c, double d) {
    double ab = a * b;
    double cd = c * d;
    return (ab - cd) + (productTail(a, b, ab) - productTail(c, d, cd));
  }

  /** What a - b lost when it was rounded to {@code difference} (Knuth's two-sum). */
  static double differenceTail(double a, double b, double difference) {
    double bVirtual = a - difference;
    double aVirtual = difference + bVirtual;
    return (a - aVirtual) + (bVirtual - b);
  }

  /** What a * b lost when it was rounded to {@code product} (Dekker). */
  static double productTail(double a, double b, double product) {
    double split = SPLITTER * a;
    double aHigh = split - (split - a);
    double aLow = a - aHigh;
    split = SPLITTER * b;
    double bHigh = split - (split - b);
    double bLow = b - bHigh;
    return aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
  }
}
