package org.jbox2d.common;

import java.io.Serializable;

/**
 * The motion of a body over a step: its centre of mass goes from {@link #c0} to {@link #c} and its
 * angle from {@link #a0} to {@link #a}, both linearly in time. Shapes turn about the centre of
 * mass, which need not be the body's origin.
 */
public class Sweep implements Serializable {

  private static final long serialVersionUID = 1L;

  /** Centre of mass in body coordinates. */
  public final Vec2 localCenter = new Vec2();

  /** Centre of mass in world coordinates at the start. */
  public final Vec2 c0 = new Vec2();

  /** Centre of mass in world coordinates at the end. */
  public final Vec2 c = new Vec2();

  /** Angle at the start, in radians. */
  public float a0;

  /** Angle at the end, in radians. */
  public float a;

  /** The part of the step, in [0, 1), that the start of this sweep has already reached. */
  public float alpha0;

  public Sweep() {}

  public final Sweep set(Sweep other) {
    localCenter.set(other.localCenter);
    c0.set(other.c0);
    c.set(other.c);
    a0 = other.a0;
    a = other.a;
    alpha0 = other.alpha0;
    return this;
  }

  /**
   * Brings {@link #a0} into [0, 2 pi) and moves {@link #a} by the same whole turns, so that angles
   * keep their precision.
   */
  public final void normalize() {
    double turns = 2.0 * Math.PI * Math.floor(a0 / (2.0 * Math.PI));
    a0 = (float) (a0 - turns);
    a = (float) (a - turns);
  }

  /**
   * Writes the body's transform at {@code beta} in [0, 1], from the start of this sweep to its end.
   */
  public final void getTransform(Transform xf, float beta) {
    float start = 1.0f - beta;
    xf.q.set(start * a0 + beta * a);
    Rot q = xf.q;
    xf.p.x = start * c0.x + beta * c.x - (q.c * localCenter.x - q.s * localCenter.y);
    xf.p.y = start * c0.y + beta * c.y - (q.s * localCenter.x + q.c * localCenter.y);
  }

  /**
   * Moves the start of this sweep on to {@code alpha} in [{@link #alpha0}, 1), a part of the whole
   * step.
   */
  public final void advance(float alpha) {
    assert alpha0 < 1f;
    float beta = (alpha - alpha0) / (1.0f - alpha0);
    c0.x += beta * (c.x - c0.x);
    c0.y += beta * (c.y - c0.y);
    a0 += beta * (a - a0);
    alpha0 = alpha;
  }

  @Override
  public String toString() {
    return "Sweep:\nlocalCenter: "
        + localCenter
        + "\nc0: "
        + c0
        + ", c: "
        + c
        + "\na0: "
        + a0
        + ", a: "
        + a
        + "\nalpha0: "
        + alpha0;
  }
}
