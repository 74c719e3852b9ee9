package org.jbox2d.common;

import java.io.Serializable;

/** A rigid motion: a rotation followed by a translation, from local to world coordinates. */
public class Transform implements Serializable {

  private static final long serialVersionUID = 1L;

  /** The translation: where the local origin is. */
  public final Vec2 p;

  /** The rotation. */
  public final Rot q;

  /** The identity. */
  public Transform() {
    p = new Vec2();
    q = new Rot();
  }

  public Transform(Transform xf) {
    this(xf.p, xf.q);
  }

  /** Copies both arguments. */
  public Transform(Vec2 position, Rot rotation) {
    p = position.clone();
    q = rotation.clone();
  }

  public final Transform set(Transform xf) {
    p.set(xf.p);
    q.set(xf.q);
    return this;
  }

  /** Sets position and angle (radians). */
  public final void set(Vec2 p, float angle) {
    this.p.set(p);
    q.set(angle);
  }

  public final void setIdentity() {
    p.setZero();
    q.setIdentity();
  }

  /** {@code v} in world coordinates. */
  public static final Vec2 mul(Transform t, Vec2 v) {
    Vec2 out = new Vec2();
    mulToOutUnsafe(t, v, out);
    return out;
  }

  /** {@code v} in world coordinates; {@code out} may be {@code v}. */
  public static final void mulToOut(Transform t, Vec2 v, Vec2 out) {
    Rot q = t.q;
    float worldY = q.s * v.x + q.c * v.y + t.p.y;
    out.x = q.c * v.x - q.s * v.y + t.p.x;
    out.y = worldY;
  }

  /** As {@link #mulToOut(Transform, Vec2, Vec2)}, where {@code out} must not be {@code v}. */
  public static final void mulToOutUnsafe(Transform t, Vec2 v, Vec2 out) {
    assert out != v;
    Rot q = t.q;
    out.x = q.c * v.x - q.s * v.y + t.p.x;
    out.y = q.s * v.x + q.c * v.y + t.p.y;
  }

  /** {@code v} in local coordinates. */
  public static final Vec2 mulTrans(Transform t, Vec2 v) {
    Vec2 out = new Vec2();
    mulTransToOutUnsafe(t, v, out);
    return out;
  }

  /** {@code v} in local coordinates; {@code out} may be {@code v}. */
  public static final void mulTransToOut(Transform t, Vec2 v, Vec2 out) {
    float dx = v.x - t.p.x;
    float dy = v.y - t.p.y;
    out.x = t.q.c * dx + t.q.s * dy;
    out.y = t.q.c * dy - t.q.s * dx;
  }

  /** As {@link #mulTransToOut(Transform, Vec2, Vec2)}, where {@code out} must not be {@code v}. */
  public static final void mulTransToOutUnsafe(Transform t, Vec2 v, Vec2 out) {
    assert out != v;
    mulTransToOut(t, v, out);
  }

  /** First b, then a. */
  public static final Transform mul(Transform a, Transform b) {
    Transform out = new Transform();
    mulToOutUnsafe(a, b, out);
    return out;
  }

  /** First b, then a; {@code out} must not be {@code a}. */
  public static final void mulToOut(Transform a, Transform b, Transform out) {
    assert out != a;
    mulToOut(a, b.p, out.p);
    Rot.mul(a.q, b.q, out.q);
  }

  /**
   * As {@link #mulToOut(Transform, Transform, Transform)}, where {@code out} must be neither
   * argument.
   */
  public static final void mulToOutUnsafe(Transform a, Transform b, Transform out) {
    assert out != a && out != b;
    mulToOutUnsafe(a, b.p, out.p);
    Rot.mulUnsafe(a.q, b.q, out.q);
  }

  /** The inverse of a times b: from b's coordinates to a's. */
  public static final Transform mulTrans(Transform a, Transform b) {
    Transform out = new Transform();
    mulTransToOutUnsafe(a, b, out);
    return out;
  }

  /** The inverse of a times b; {@code out} must not be {@code a}. */
  public static final void mulTransToOut(Transform a, Transform b, Transform out) {
    assert out != a;
    mulTransToOut(a, b.p, out.p);
    Rot.mulTrans(a.q, b.q, out.q);
  }

  /**
   * As {@link #mulTransToOut(Transform, Transform, Transform)}, where {@code out} must be neither
   * argument.
   */
  public static final void mulTransToOutUnsafe(Transform a, Transform b, Transform out) {
    assert out != a && out != b;
    mulTransToOutUnsafe(a, b.p, out.p);
    Rot.mulTransUnsafe(a.q, b.q, out.q);
  }

  @Override
  public final String toString() {
    return "XForm:\nPosition: " + p + "\nR: \n" + q + "\n";
  }
}
