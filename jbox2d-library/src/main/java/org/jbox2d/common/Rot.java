package org.jbox2d.common;

import java.io.Serializable;

/** A rotation, kept as sine and cosine of its angle. */
public class Rot implements Serializable {

  private static final long serialVersionUID = 1L;

  /** Sine of the angle. */
  public float s;

  /** Cosine of the angle. */
  public float c;

  /** The identity. */
  public Rot() {
    c = 1f;
  }

  /** The counter-clockwise rotation by {@code angle} radians. */
  public Rot(float angle) {
    set(angle);
  }

  public float getSin() {
    return s;
  }

  public float getCos() {
    return c;
  }

  /** Sets the counter-clockwise rotation by {@code angle} radians. */
  public Rot set(float angle) {
    s = MathUtils.sin(angle);
    c = MathUtils.cos(angle);
    return this;
  }

  public Rot set(Rot other) {
    s = other.s;
    c = other.c;
    return this;
  }

  public Rot setIdentity() {
    s = 0f;
    c = 1f;
    return this;
  }

  /** The angle in [-pi, pi]. */
  public float getAngle() {
    return MathUtils.atan2(s, c);
  }

  /** Writes the image of (1, 0). */
  public void getXAxis(Vec2 xAxis) {
    xAxis.set(c, s);
  }

  /** Writes the image of (0, 1). */
  public void getYAxis(Vec2 yAxis) {
    yAxis.set(-s, c);
  }

  @Override
  public Rot clone() {
    return new Rot().set(this);
  }

  @Override
  public String toString() {
    return "Rot(s:" + s + ", c:" + c + ")";
  }

  /** {@code out = q r}: first r, then q. */
  public static final void mul(Rot q, Rot r, Rot out) {
    float cosine = q.c * r.c - q.s * r.s;
    out.s = q.s * r.c + q.c * r.s;
    out.c = cosine;
  }

  /** As {@link #mul}, where {@code out} must be neither argument. */
  public static final void mulUnsafe(Rot q, Rot r, Rot out) {
    assert out != q && out != r;
    out.s = q.s * r.c + q.c * r.s;
    out.c = q.c * r.c - q.s * r.s;
  }

  /** {@code out} is the inverse of q times r: the rotation from q to r. */
  public static final void mulTrans(Rot q, Rot r, Rot out) {
    float cosine = q.c * r.c + q.s * r.s;
    out.s = q.c * r.s - q.s * r.c;
    out.c = cosine;
  }

  /** As {@link #mulTrans(Rot, Rot, Rot)}, where {@code out} must be neither argument. */
  public static final void mulTransUnsafe(Rot q, Rot r, Rot out) {
    assert out != q && out != r;
    out.s = q.c * r.s - q.s * r.c;
    out.c = q.c * r.c + q.s * r.s;
  }

  /** Rotates {@code v}. */
  public static final void mulToOut(Rot q, Vec2 v, Vec2 out) {
    float turned = q.s * v.x + q.c * v.y;
    out.x = q.c * v.x - q.s * v.y;
    out.y = turned;
  }

  /** As {@link #mulToOut}, where {@code out} must not be {@code v}. */
  public static final void mulToOutUnsafe(Rot q, Vec2 v, Vec2 out) {
    assert out != v;
    out.x = q.c * v.x - q.s * v.y;
    out.y = q.s * v.x + q.c * v.y;
  }

  /** Rotates {@code v} back. */
  public static final void mulTrans(Rot q, Vec2 v, Vec2 out) {
    float turned = q.c * v.y - q.s * v.x;
    out.x = q.c * v.x + q.s * v.y;
    out.y = turned;
  }

  /** As {@link #mulTrans(Rot, Vec2, Vec2)}, where {@code out} must not be {@code v}. */
  public static final void mulTransUnsafe(Rot q, Vec2 v, Vec2 out) {
    assert out != v;
    out.x = q.c * v.x + q.s * v.y;
    out.y = q.c * v.y - q.s * v.x;
  }
}
