package org.jbox2d.fracture.geometry;

/**
 * Sine, cosine, angle and logarithm in double precision, the same bits on every JVM and in every
 * JIT mode: only additions, multiplications and divisions, which Java defines to the last bit. They
 * are what {@code StrictMath} gives to within two units in the last place of the larger of value
 * and 1, without the call out of Java that {@code StrictMath} is in Java 8 to 20.
 */
public final class Angles {
  private static final double HALF_PI = 0.5 * Math.PI;
  private static final double QUARTER_PI = 0.25 * Math.PI;
  private static final double EIGHTH_PI = 0.125 * Math.PI;

  /** The leading 33 bits of pi/2: a multiple by an integer below 2^20 is exact. */
  private static final double HALF_PI_HEAD = 0x1.921fb544p0;

  /** pi/2 less {@link #HALF_PI_HEAD}, rounded to a double. */
  private static final double HALF_PI_TAIL = 0x1.0b4611a626331p-34;

  /** Up to here, in radians, the two-part reduction is exact enough. */
  private static final double REDUCTION_LIMIT = 1e6;

  /** Tangents of pi/16, pi/8 and 3 pi/16. */
  private static final double TAN_1 = 0.198912367379658;

  private static final double TAN_2 = 0.41421356237309503;
  private static final double TAN_3 = 0.6681786379192989;

  private static final double SQRT_2 = 1.4142135623730951;

  /** The leading 32 bits of ln 2, and the rest. */
  private static final double LN_2_HEAD = 0x1.62e42feep-1;

  private static final double LN_2_TAIL = 0x1.a39ef35793c76p-33;

  /** The exponent field of 1. */
  private static final int EXPONENT_OF_ONE = 1023;

  private Angles() {}

  /*
   * Reduction (W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980,
   * chapter 8): x = k pi/2 + r with |r| <= pi/4. The last two bits of k name the quadrant.
   */

  /** Sine of x radians. */
  public static double sin(double x) {
    if (!(Math.abs(x) < REDUCTION_LIMIT)) {
      return StrictMath.sin(x);
    }
    int k = nearestQuadrant(x);
    double r = remainder(x, k);
    double value = (k & 1) == 0 ? sinKernel(r) : cosKernel(r);
    return (k & 2) == 0 ? value : -value;
  }

  /** Cosine of x radians. */
  public static double cos(double x) {
    if (!(Math.abs(x) < REDUCTION_LIMIT)) {
      return StrictMath.cos(x);
    }
    int k = nearestQuadrant(x);
    double r = remainder(x, k);
    double value = (k & 1) == 0 ? cosKernel(r) : sinKernel(r);
    return ((k + 1) & 2) == 0 ? value : -value;
  }

  /**
   * The vector of length 1 at an angle of x radians: {@link #cos} and {@link #sin}, one after the
   * other in {@code out}. Which quadrant an angle is in is often as good as random, so there is no
   * branch on it.
   */
  public static void direction(double x, double[] out) {
    if (!(Math.abs(x) < REDUCTION_LIMIT)) {
      out[0] = StrictMath.cos(x);
      out[1] = StrictMath.sin(x);
      return;
    }
    int k = nearestQuadrant(x);
    double r = remainder(x, k);
    long sine = Double.doubleToRawLongBits(sinKernel(r));
    long cosine = Double.doubleToRawLongBits(cosKernel(r));
    long differing = (sine ^ cosine) & -(long) (k & 1);
    long signOfCosine = (long) ((k + 1) & 2) << 62;
    long signOfSine = (long) (k & 2) << 62;
    out[0] = Double.longBitsToDouble(cosine ^ differing ^ signOfCosine);
    out[1] = Double.longBitsToDouble(sine ^ differing ^ signOfSine);
  }

  private static int nearestQuadrant(double x) {
    double quarters = x / HALF_PI;
    return (int) (quarters + Math.copySign(0.5, quarters));
  }

  private static double remainder(double x, int k) {
    return (x - k * HALF_PI_HEAD) - k * HALF_PI_TAIL;
  }

  /** Taylor series to r^15; for |r| up to pi/4 the next term is below 6e-17 of the value. */
  private static double sinKernel(double r) {
    double z = r * r;
    double high = 1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 + z * SIN_15));
    return r + r * z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * high)));
  }

  private static final double SIN_15 = -1.0 / 1307674368000.0;

  /** Taylor series to r^16; for |r| up to pi/4 the next term is below 3e-18. */
  private static double cosKernel(double r) {
    double z = r * r;
    double high = -1.0 / 3628800 + z * (1.0 / 479001600 + z * (COS_14 + z * COS_16));
    return 1 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320 + z * high))));
  }

  private static final double COS_14 = -1.0 / 87178291200.0;
  private static final double COS_16 = 1.0 / 20922789888000.0;

  /**
   * Angle of the vector (x, y), finite and not zero, in [-pi, pi].
   *
   * <p>With a the larger and b the smaller magnitude, c one of 0, tan(pi/8) and 1, and {@code t =
   * (b - c a) / (a + c b)}: atan(b / a) = atan c + atan t (Abramowitz and Stegun, 4.4.34), such
   * that |t| is at most tan(pi/16).
   */
  public static double atan2(double y, double x) {
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double a = Math.max(ax, ay);
    double b = Math.min(ax, ay);
    double angle;
    if (b <= TAN_1 * a) {
      angle = atanKernel(b / a);
    } else if (b <= TAN_3 * a) {
      angle = EIGHTH_PI + atanKernel((b - TAN_2 * a) / (a + TAN_2 * b));
    } else {
      angle = QUARTER_PI + atanKernel((b - a) / (a + b));
    }
    if (ay > ax) {
      angle = HALF_PI - angle;
    }
    if (x < 0) {
      angle = Math.PI - angle;
    }
    return y < 0 ? -angle : angle;
  }

  /** Taylor series to t^23; for |t| up to tan(pi/16) the next term is below 1e-18 of the value. */
  private static double atanKernel(double t) {
    double z = t * t;
    double high = -1.0 / 15 + z * (1.0 / 17 + z * (-1.0 / 19 + z * (1.0 / 21 - z * (1.0 / 23))));
    double middle = -1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13 + z * high)));
    return t + t * z * (-1.0 / 3 + z * (1.0 / 5 + z * middle));
  }

  /**
   * Natural logarithm of a positive normal number.
   *
   * <p>{@code x = 2^k m} with m in [sqrt(1/2), sqrt(2)), and {@code ln m = 2 artanh((m - 1) / (m +
   * 1))} (Abramowitz and Stegun, 4.1.27) by its Taylor series to s^21, whose next term is below
   * 2e-19 of the value.
   */
  public static double log(double x) {
    long bits = Double.doubleToRawLongBits(x);
    int k = (int) (bits >> 52) - EXPONENT_OF_ONE;
    double m = Double.longBitsToDouble(bits - ((long) k << 52));
    if (m > SQRT_2) {
      m *= 0.5;
      k++;
    }
    double s = (m - 1) / (m + 1);
    double z = s * s;
    double high = 1.0 / 13 + z * (1.0 / 15 + z * (1.0 / 17 + z * (1.0 / 19 + z * (1.0 / 21))));
    double middle = 1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9 + z * (1.0 / 11 + z * high)));
    double artanh = s + s * z * (1.0 / 3 + z * middle);
    return k * LN_2_HEAD + (k * LN_2_TAIL + 2 * artanh);
  }
}
