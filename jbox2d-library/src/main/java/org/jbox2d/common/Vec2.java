package org.jbox2d.common;

import java.io.Serializable;

/**
 * A vector of the plane. Methods named {@code ...Local} change this vector and return it; {@code
 * ...ToOut} write their result into the last argument, which may be one of the others unless the
 * name ends in {@code Unsafe}.
 */
public class Vec2 implements Serializable {

  private static final long serialVersionUID = 1L;

  public float x;
  public float y;

  public Vec2() {}

  public Vec2(float x, float y) {
    this.x = x;
    this.y = y;
  }

  public Vec2(Vec2 toCopy) {
    this(toCopy.x, toCopy.y);
  }

  public final void setZero() {
    x = 0f;
    y = 0f;
  }

  public final Vec2 set(float x, float y) {
    this.x = x;
    this.y = y;
    return this;
  }

  public final Vec2 set(Vec2 v) {
    x = v.x;
    y = v.y;
    return this;
  }

  public final Vec2 add(Vec2 v) {
    return new Vec2(x + v.x, y + v.y);
  }

  public final Vec2 sub(Vec2 v) {
    return new Vec2(x - v.x, y - v.y);
  }

  public final Vec2 mul(float a) {
    return new Vec2(x * a, y * a);
  }

  public final Vec2 negate() {
    return new Vec2(-x, -y);
  }

  public final Vec2 negateLocal() {
    x = -x;
    y = -y;
    return this;
  }

  public final Vec2 addLocal(Vec2 v) {
    x += v.x;
    y += v.y;
    return this;
  }

  public final Vec2 addLocal(float x, float y) {
    this.x += x;
    this.y += y;
    return this;
  }

  public final Vec2 subLocal(Vec2 v) {
    x -= v.x;
    y -= v.y;
    return this;
  }

  public final Vec2 mulLocal(float a) {
    x *= a;
    y *= a;
    return this;
  }

  /**
   * This vector turned by a quarter counter-clockwise: {@code dot(skew(), v) == cross(this, v)}.
   */
  public final Vec2 skew() {
    return new Vec2(-y, x);
  }

  /** Writes {@link #skew()} into {@code out}, which must not be this vector. */
  public final void skew(Vec2 out) {
    out.x = -y;
    out.y = x;
  }

  public final float length() {
    return MathUtils.sqrt(x * x + y * y);
  }

  public final float lengthSquared() {
    return x * x + y * y;
  }

  /**
   * Scales this vector to length 1 and returns the length it had. A vector shorter than {@link
   * Settings#EPSILON} has no usable direction: it stays, and 0 is returned.
   */
  public final float normalize() {
    float length = length();
    if (length < Settings.EPSILON) {
      return 0f;
    }
    float inverse = 1.0f / length;
    x *= inverse;
    y *= inverse;
    return length;
  }

  /** Whether both coordinates are finite. */
  public final boolean isValid() {
    return Math.abs(x) <= Float.MAX_VALUE && Math.abs(y) <= Float.MAX_VALUE;
  }

  /** The vector of the coordinates' magnitudes. */
  public final Vec2 abs() {
    return new Vec2(Math.abs(x), Math.abs(y));
  }

  public final void absLocal() {
    x = Math.abs(x);
    y = Math.abs(y);
  }

  @Override
  public final Vec2 clone() {
    return new Vec2(x, y);
  }

  @Override
  public final String toString() {
    return "(" + x + "," + y + ")";
  }

  public static final Vec2 abs(Vec2 a) {
    return a.abs();
  }

  public static final void absToOut(Vec2 a, Vec2 out) {
    out.x = Math.abs(a.x);
    out.y = Math.abs(a.y);
  }

  public static final float dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
  }

  /**
   * The third coordinate of the cross product; positive if {@code b} is counter-clockwise from
   * {@code a}.
   */
  public static final float cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
  }

  /**
   * {@code a} turned clockwise by a quarter and scaled by {@code s}: the cross product with (0, 0,
   * s).
   */
  public static final Vec2 cross(Vec2 a, float s) {
    return new Vec2(s * a.y, -s * a.x);
  }

  public static final void crossToOut(Vec2 a, float s, Vec2 out) {
    float turned = -s * a.x;
    out.x = s * a.y;
    out.y = turned;
  }

  public static final void crossToOutUnsafe(Vec2 a, float s, Vec2 out) {
    assert out != a;
    out.x = s * a.y;
    out.y = -s * a.x;
  }

  /**
   * {@code a} turned counter-clockwise by a quarter and scaled by {@code s}: the velocity at {@code
   * a} of a spin {@code s}.
   */
  public static final Vec2 cross(float s, Vec2 a) {
    return new Vec2(-s * a.y, s * a.x);
  }

  public static final void crossToOut(float s, Vec2 a, Vec2 out) {
    float turned = s * a.x;
    out.x = -s * a.y;
    out.y = turned;
  }

  public static final void crossToOutUnsafe(float s, Vec2 a, Vec2 out) {
    assert out != a;
    out.x = -s * a.y;
    out.y = s * a.x;
  }

  public static final void negateToOut(Vec2 a, Vec2 out) {
    out.x = -a.x;
    out.y = -a.y;
  }

  /** The smaller of each coordinate. */
  public static final Vec2 min(Vec2 a, Vec2 b) {
    return new Vec2(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y);
  }

  public static final void minToOut(Vec2 a, Vec2 b, Vec2 out) {
    out.x = a.x < b.x ? a.x : b.x;
    out.y = a.y < b.y ? a.y : b.y;
  }

  /** The larger of each coordinate. */
  public static final Vec2 max(Vec2 a, Vec2 b) {
    return new Vec2(a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y);
  }

  public static final void maxToOut(Vec2 a, Vec2 b, Vec2 out) {
    out.x = a.x > b.x ? a.x : b.x;
    out.y = a.y > b.y ? a.y : b.y;
  }

  @Override
  public int hashCode() {
    return 31 * Float.floatToIntBits(x) + Float.floatToIntBits(y);
  }

  /** Whether {@code obj} is a vector with the same bits; 0 and -0 differ, NaN equals itself. */
  @Override
  public boolean equals(Object obj) {
    if (this == obj) {
      return true;
    }
    if (obj == null || obj.getClass() != getClass()) {
      return false;
    }
    Vec2 other = (Vec2) obj;
    return Float.floatToIntBits(x) == Float.floatToIntBits(other.x)
        && Float.floatToIntBits(y) == Float.floatToIntBits(other.y);
  }
}
