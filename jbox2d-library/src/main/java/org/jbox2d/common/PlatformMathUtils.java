package org.jbox2d.common;

/** Base of {@link MathUtils}; clients reach its member through that class. */
class PlatformMathUtils {

  PlatformMathUtils() {}

  /**
   * {@code a} to the power {@code b}, correctly the same on every JVM. As accurate as {@link
   * MathUtils#pow}.
   */
  public static float fastPow(float a, float b) {
    return (float) StrictMath.pow(a, b);
  }
}
