package org.jbox2d.common;

import java.io.Serializable;

/** A vector of three numbers; naming as in {@link Vec2}. */
public class Vec3 implements Serializable {

  private static final long serialVersionUID = 1L;

  public float x;
  public float y;
  public float z;

  public Vec3() {}

  public Vec3(float x, float y, float z) {
    this.x = x;
    this.y = y;
    this.z = z;
  }

  public Vec3(Vec3 toCopy) {
    this(toCopy.x, toCopy.y, toCopy.z);
  }

  public Vec3 set(Vec3 v) {
    return set(v.x, v.y, v.z);
  }

  public Vec3 set(float x, float y, float z) {
    this.x = x;
    this.y = y;
    this.z = z;
    return this;
  }

  public void setZero() {
    set(0f, 0f, 0f);
  }

  public Vec3 addLocal(Vec3 v) {
    x += v.x;
    y += v.y;
    z += v.z;
    return this;
  }

  public Vec3 add(Vec3 v) {
    return new Vec3(x + v.x, y + v.y, z + v.z);
  }

  public Vec3 subLocal(Vec3 v) {
    x -= v.x;
    y -= v.y;
    z -= v.z;
    return this;
  }

  public Vec3 sub(Vec3 v) {
    return new Vec3(x - v.x, y - v.y, z - v.z);
  }

  public Vec3 mulLocal(float a) {
    x *= a;
    y *= a;
    z *= a;
    return this;
  }

  public Vec3 mul(float a) {
    return new Vec3(x * a, y * a, z * a);
  }

  public Vec3 negate() {
    return new Vec3(-x, -y, -z);
  }

  public Vec3 negateLocal() {
    x = -x;
    y = -y;
    z = -z;
    return this;
  }

  @Override
  public Vec3 clone() {
    return new Vec3(x, y, z);
  }

  @Override
  public String toString() {
    return "(" + x + "," + y + "," + z + ")";
  }

  public static final float dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }

  public static final Vec3 cross(Vec3 a, Vec3 b) {
    Vec3 out = new Vec3();
    crossToOutUnsafe(a, b, out);
    return out;
  }

  public static final void crossToOut(Vec3 a, Vec3 b, Vec3 out) {
    float cx = a.y * b.z - a.z * b.y;
    float cy = a.z * b.x - a.x * b.z;
    float cz = a.x * b.y - a.y * b.x;
    out.x = cx;
    out.y = cy;
    out.z = cz;
  }

  public static final void crossToOutUnsafe(Vec3 a, Vec3 b, Vec3 out) {
    assert out != a && out != b;
    out.x = a.y * b.z - a.z * b.y;
    out.y = a.z * b.x - a.x * b.z;
    out.z = a.x * b.y - a.y * b.x;
  }

  @Override
  public int hashCode() {
    int hash = Float.floatToIntBits(x);
    hash = 31 * hash + Float.floatToIntBits(y);
    return 31 * hash + Float.floatToIntBits(z);
  }

  /** Whether {@code obj} is a vector with the same bits. */
  @Override
  public boolean equals(Object obj) {
    if (this == obj) {
      return true;
    }
    if (obj == null || obj.getClass() != getClass()) {
      return false;
    }
    Vec3 other = (Vec3) obj;
    return Float.floatToIntBits(x) == Float.floatToIntBits(other.x)
        && Float.floatToIntBits(y) == Float.floatToIntBits(other.y)
        && Float.floatToIntBits(z) == Float.floatToIntBits(other.z);
  }
}
