package org.jbox2d.common;

import java.util.Random;

/**
 * Mathematics that gives the same bits on every JVM and in every JIT mode.
 *
 * <p>{@code Math.sin} and its kin may differ between platforms in the last place, which would soon
 * make two runs of a world differ. The functions here use only additions, multiplications,
 * divisions and square roots of doubles, which IEEE 754 and Java 17 define to the last bit.
 */
public class MathUtils extends PlatformMathUtils {

  public static final float PI = 3.1415927f;
  public static final float TWOPI = (float) (2.0 * Math.PI);
  public static final float INV_PI = 1f / PI;
  public static final float HALF_PI = PI / 2;
  public static final float QUARTER_PI = PI / 4;
  public static final float THREE_HALVES_PI = TWOPI - HALF_PI;

  /** Degrees to radians. */
  public static final float DEG2RAD = PI / 180;

  /** Radians to degrees. */
  public static final float RAD2DEG = 180 / PI;

  private static final double TWO_PI_D = 2.0 * Math.PI;
  private static final double HALF_PI_D = 0.5 * Math.PI;
  private static final double QUARTER_PI_D = 0.25 * Math.PI;
  private static final double TWO_OVER_PI = 2.0 / Math.PI;

  /** The leading 33 bits of pi/2: a multiple by an integer below 2^20 is exact in a double. */
  private static final double HALF_PI_HEAD = 0x1.921fb544p0;

  /** pi/2 less {@link #HALF_PI_HEAD}, rounded to a double. */
  private static final double HALF_PI_TAIL = 0x1.0b4611a626331p-34;

  /**
   * Up to here, in radians, the two-part reduction is exact enough; beyond it {@code StrictMath}
   * takes over.
   */
  private static final double REDUCTION_LIMIT = 1.0e6;

  /** tan(pi/8), where the two branches of the arc tangent meet. */
  private static final double TAN_EIGHTH_PI = 0x1.a827999fcef32p-2;

  /** Sines at multiples of {@link Settings#SINCOS_LUT_PRECISION}. Read it only. */
  public static final float[] sinLUT = sineTable();

  public MathUtils() {}

  private static float[] sineTable() {
    float[] table = new float[Settings.SINCOS_LUT_LENGTH];
    for (int i = 0; i < table.length; i++) {
      table[i] = sinExact(i * Settings.SINCOS_LUT_PRECISION);
    }
    return table;
  }

  /**
   * Sine of {@code x} radians, to 1 ulp; NaN for an infinite argument. Reads the table if {@link
   * Settings#SINCOS_LUT_ENABLED}.
   */
  public static final float sin(float x) {
    return Settings.SINCOS_LUT_ENABLED ? sinLUT(x) : sinExact(x);
  }

  /**
   * Cosine of {@code x} radians, to 1 ulp; NaN for an infinite argument. Reads the table if {@link
   * Settings#SINCOS_LUT_ENABLED}.
   */
  public static final float cos(float x) {
    return Settings.SINCOS_LUT_ENABLED ? sinLUT(HALF_PI - x) : cosExact(x);
  }

  /*
   * Reduction (W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980, chapter 8): x = k pi/2 + r with
   * |r| <= pi/4 (a hair more after rounding of k). pi/2 is split in two so that k * head is exact and x - k * head cancels
   * without error; what is left is the rounding of k * tail, below 1e-21 k. The last two bits of k name the quadrant.
   */

  private static float sinExact(float x) {
    if (!(Math.abs(x) < REDUCTION_LIMIT)) {
      return (float) StrictMath.sin(x);
    }
    int k = nearestQuadrant(x);
    double r = remainder(x, k);
    double value = (k & 1) == 0 ? sinKernel(r) : cosKernel(r);
    return (float) ((k & 2) == 0 ? value : -value);
  }

  private static float cosExact(float x) {
    if (!(Math.abs(x) < REDUCTION_LIMIT)) {
      return (float) StrictMath.cos(x);
    }
    int k = nearestQuadrant(x);
    double r = remainder(x, k);
    double value = (k & 1) == 0 ? cosKernel(r) : sinKernel(r);
    return (float) (((k + 1) & 2) == 0 ? value : -value);
  }

  private static int nearestQuadrant(float x) {
    double scaled = x * TWO_OVER_PI;
    return (int) (scaled >= 0 ? scaled + 0.5 : scaled - 0.5);
  }

  private static double remainder(float x, int k) {
    return (x - k * HALF_PI_HEAD) - k * HALF_PI_TAIL;
  }

  /**
   * Taylor series of the sine to r^11. For {@code |r| <= pi/4} the next term is below 1e-11 of the
   * value: 0.0002 ulp of a float.
   */
  private static double sinKernel(double r) {
    double z = r * r;
    double tail = -1.0 / 5040 + z * (1.0 / 362880 - z * (1.0 / 39916800));
    return r * (1.0 + z * (-1.0 / 6 + z * (1.0 / 120 + z * tail)));
  }

  /**
   * Taylor series of the cosine to r^12. For {@code |r| <= pi/4} the next term is below 1e-12 of
   * the value.
   */
  private static double cosKernel(double r) {
    double z = r * r;
    double tail = 1.0 / 40320 + z * (-1.0 / 3628800 + z * (1.0 / 479001600));
    return 1.0 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 + z * tail)));
  }

  /**
   * Sine from the table, interpolated if {@link Settings#SINCOS_LUT_LERP}; accurate to 1e-4,
   * interpolated to 1e-6.
   */
  public static final float sinLUT(float x) {
    double turn = x - TWO_PI_D * Math.floor(x / TWO_PI_D);
    if (!(turn >= 0)) {
      return Float.NaN;
    }
    double position = turn / Settings.SINCOS_LUT_PRECISION;
    int length = sinLUT.length;
    if (!Settings.SINCOS_LUT_LERP) {
      return sinLUT[(int) (position + 0.5) % length];
    }
    int i = (int) position;
    float low = sinLUT[i % length];
    float high = sinLUT[(i + 1) % length];
    return (float) (low + (position - i) * (high - low));
  }

  /** Magnitude. */
  public static final float abs(float x) {
    return Math.abs(x);
  }

  /** Magnitude. */
  public static final float fastAbs(float x) {
    return Math.abs(x);
  }

  /** Magnitude; {@code Integer.MIN_VALUE} stays. */
  public static final int abs(int x) {
    return Math.abs(x);
  }

  /** Largest integer not above {@code x}; clipped to the range of int. */
  public static final int floor(float x) {
    return (int) Math.floor(x);
  }

  /** Largest integer not above {@code x}, for |x| below 2^31. */
  public static final int fastFloor(float x) {
    int truncated = (int) x;
    return x < truncated ? truncated - 1 : truncated;
  }

  /** Smallest integer not below {@code x}; clipped to the range of int. */
  public static final int ceil(float x) {
    return (int) Math.ceil(x);
  }

  /** Smallest integer not below {@code x}, for |x| below 2^31. */
  public static final int fastCeil(float x) {
    int truncated = (int) x;
    return x > truncated ? truncated + 1 : truncated;
  }

  /** Nearest integer, halves upwards. */
  public static final int round(float x) {
    return Math.round(x);
  }

  /** Smallest power of two that is not below {@code x}; 1 for {@code x <= 1}. */
  public static final int ceilPowerOf2(int x) {
    return x <= 1 ? 1 : Integer.highestOneBit(x - 1) << 1;
  }

  /** Smallest power of two above {@code x}, for {@code x >= 0}. */
  public static final int nextPowerOfTwo(int x) {
    return x <= 0 ? 1 : Integer.highestOneBit(x) << 1;
  }

  /** Whether {@code x} is a positive power of two. */
  public static final boolean isPowerOfTwo(int x) {
    return x > 0 && (x & (x - 1)) == 0;
  }

  public static final float max(float a, float b) {
    return a > b ? a : b;
  }

  public static final int max(int a, int b) {
    return a > b ? a : b;
  }

  public static final float min(float a, float b) {
    return a < b ? a : b;
  }

  public static final int min(int a, int b) {
    return a < b ? a : b;
  }

  /**
   * Maps {@code val} linearly so that {@code fromMin} goes to {@code toMin} and {@code fromMax} to
   * {@code toMax}.
   */
  public static final float map(float val, float fromMin, float fromMax, float toMin, float toMax) {
    return toMin + (val - fromMin) * ((toMax - toMin) / (fromMax - fromMin));
  }

  /** The value of [low, high] nearest to {@code a}. */
  public static final float clamp(float a, float low, float high) {
    return max(low, min(a, high));
  }

  /** {@link #clamp(float, float, float)} for each coordinate, as a new vector. */
  public static final Vec2 clamp(Vec2 a, Vec2 low, Vec2 high) {
    return new Vec2(clamp(a.x, low.x, high.x), clamp(a.y, low.y, high.y));
  }

  /**
   * {@link #clamp(float, float, float)} for each coordinate; {@code dest} may be any of the
   * arguments.
   */
  public static final void clampToOut(Vec2 a, Vec2 low, Vec2 high, Vec2 dest) {
    dest.x = clamp(a.x, low.x, high.x);
    dest.y = clamp(a.y, low.y, high.y);
  }

  /**
   * Angle of the vector (x, y) in [-pi, pi], to 1 ulp, with the signs of zero of {@link
   * Math#atan2}. Off by up to 0.005 rad if {@link Settings#FAST_ATAN2}.
   *
   * <p>The quotient t of the smaller and the larger coordinate lies in [0, 1]; atan t = pi/4 +
   * atan((t - 1) / (t + 1)) brings it to {@code |t| <= tan(pi/8)}, where the Taylor series
   * converges fast (Abramowitz and Stegun, 4.4.34 and 4.4.42).
   */
  public static final float atan2(float y, float x) {
    if (Settings.FAST_ATAN2) {
      return fastAtan2(y, x);
    }
    double ax = Math.abs((double) x);
    double ay = Math.abs((double) y);
    double large = ax > ay ? ax : ay;
    if (!(large > 0 && large <= Float.MAX_VALUE) || x != x || y != y) {
      return (float) StrictMath.atan2(y, x);
    }
    double t = (ax > ay ? ay : ax) / large;
    double angle = t > TAN_EIGHTH_PI ? QUARTER_PI_D + atanKernel((t - 1) / (t + 1)) : atanKernel(t);
    if (ay > ax) {
      angle = HALF_PI_D - angle;
    }
    if (x < 0) {
      angle = Math.PI - angle;
    }
    return (float) Math.copySign(angle, y);
  }

  /**
   * Taylor series of the arc tangent to t^23. For {@code |t| <= tan(pi/8)} the next term is below
   * 3e-11 of the value.
   */
  private static double atanKernel(double t) {
    double z = t * t;
    double high = 1.0 / 17 + z * (-1.0 / 19 + z * (1.0 / 21 - z * (1.0 / 23)));
    double middle = 1.0 / 9 + z * (-1.0 / 11 + z * (1.0 / 13 + z * (-1.0 / 15 + z * high)));
    return t + t * z * (-1.0 / 3 + z * (1.0 / 5 + z * (-1.0 / 7 + z * middle)));
  }

  /**
   * Angle of the vector (x, y) in [-pi, pi] to 0.005 rad, by atan t = t / (1 + 0.28 t^2) (R. Lyons,
   * Streamlining Digital Signal Processing, 2007, chapter 16).
   */
  public static final float fastAtan2(float y, float x) {
    if (x == 0 && y == 0) {
      return 0;
    }
    if (Math.abs(x) > Math.abs(y)) {
      float t = y / x;
      float angle = t / (1 + 0.28f * t * t);
      return x > 0 ? angle : angle + Math.copySign(PI, y);
    }
    float t = x / y;
    return Math.copySign(HALF_PI, y) - t / (1 + 0.28f * t * t);
  }

  /** {@code a} to the power {@code b}, the same on every JVM. */
  public static final float pow(float a, float b) {
    return (float) StrictMath.pow(a, b);
  }

  /** The angle in [-pi/2, pi/2] that has the same sine as {@code theta}. */
  public static final float reduceAngle(float theta) {
    double turn = theta - TWO_PI_D * Math.rint(theta / TWO_PI_D);
    if (turn > HALF_PI_D) {
      turn = Math.PI - turn;
    } else if (turn < -HALF_PI_D) {
      turn = -Math.PI - turn;
    }
    return (float) turn;
  }

  /**
   * A number from [argLow, argHigh) by {@link Math#random}: differs from run to run, so nothing in
   * the engine calls it.
   */
  public static final float randomFloat(float argLow, float argHigh) {
    return (float) (argLow + Math.random() * ((double) argHigh - argLow));
  }

  /** A number from [argLow, argHigh), taken from {@code r}. */
  public static final float randomFloat(Random r, float argLow, float argHigh) {
    return argLow + r.nextFloat() * (argHigh - argLow);
  }

  public static final float sqrt(float x) {
    return (float) Math.sqrt(x);
  }

  public static final float distanceSquared(Vec2 v1, Vec2 v2) {
    float dx = v1.x - v2.x;
    float dy = v1.y - v2.y;
    return dx * dx + dy * dy;
  }

  public static final float distance(Vec2 v1, Vec2 v2) {
    return sqrt(distanceSquared(v1, v2));
  }
}
