package org.jbox2d.dynamics.solver;

import java.util.Arrays;
import org.jbox2d.common.MathUtils;

/**
 * The bodies of a step as flat arrays. A body's index is its slot; strides are four floats, so that
 * what one body needs lies in one cache line.
 *
 * <ul>
 *   <li>{@code vel[4i..]}: linear velocity x, y (m/s), angular velocity (rad/s), unused
 *   <li>{@code pos[4i..]}: centre of mass x, y (m), sine and cosine of the angle
 *   <li>{@code angle[i]}: angle (rad), unbounded
 *   <li>{@code accel[4i..]}: acceleration by gravity and forces x, y (m/s^2), angular (rad/s^2),
 *       unused; for solvers with substeps
 *   <li>{@code damping[2i..]}: linear and angular damping (1/s); for solvers with substeps
 *   <li>{@code delta[4i..]}: way since the step began x, y (m), turn (rad), unused; for solvers
 *       with substeps
 *   <li>{@code mass[4i..]}: inverse mass (1/kg), inverse inertia about the centre (1/(kg m^2)),
 *       local centre x, y (m)
 * </ul>
 */
public final class SolverBodies {
  public static final int STRIDE = 4;

  /**
   * Turn up to which {@link #turn} serves for a whole step, rad; its error is below 3e-6 rad there,
   * and lasts a step.
   */
  private static final float SMALL_TURN = 0.02f;

  /**
   * Turn from which {@link #turn} takes the exact sine and cosine, rad: 8 degrees, the largest
   * correction of a joint. Contacts turn slivers of a centimetre further.
   */
  private static final float LARGE_TURN = 8f / 180f * MathUtils.PI;

  public int count;
  public float[] vel = new float[0];
  public float[] pos = new float[0];
  public float[] mass = new float[0];
  public float[] angle = new float[0];
  public float[] accel = new float[0];
  public float[] damping = new float[0];
  public float[] delta = new float[0];

  /** Makes room for {@code n} bodies; keeps what the first {@link #count} hold. */
  public void ensureCapacity(int n) {
    if (n <= angle.length) {
      return;
    }
    int capacity = Math.max(64, Math.max(n, angle.length + (angle.length >> 1)));
    vel = Arrays.copyOf(vel, STRIDE * capacity);
    pos = Arrays.copyOf(pos, STRIDE * capacity);
    mass = Arrays.copyOf(mass, STRIDE * capacity);
    angle = Arrays.copyOf(angle, capacity);
    accel = Arrays.copyOf(accel, STRIDE * capacity);
    damping = Arrays.copyOf(damping, 2 * capacity);
    delta = Arrays.copyOf(delta, STRIDE * capacity);
  }

  /**
   * Moves bodies {@code [0, n)} by their velocities over {@code dt} (semi-implicit Euler), at most
   * {@code maxTranslation} and {@code maxRotation} far; a velocity above that is scaled down.
   *
   * @return how many velocities were capped
   */
  public int integratePositions(int n, float dt, float maxTranslation, float maxRotation) {
    int capped = 0;
    float maxTranslation2 = maxTranslation * maxTranslation;
    for (int i = 0; i < n; i++) {
      int o = STRIDE * i;
      float vx = vel[o];
      float vy = vel[o + 1];
      float w = vel[o + 2];
      float dx = vx * dt;
      float dy = vy * dt;
      float way2 = dx * dx + dy * dy;
      if (way2 > maxTranslation2) {
        float ratio = maxTranslation / (float) Math.sqrt(way2);
        vel[o] = vx *= ratio;
        vel[o + 1] = vy *= ratio;
        capped++;
      }
      if (Math.abs(w * dt) > maxRotation) {
        vel[o + 2] = w *= maxRotation / Math.abs(w * dt);
        capped++;
      }
      pos[o] += vx * dt;
      pos[o + 1] += vy * dt;
      swing(i, w * dt);
    }
    return capped;
  }

  /** Turns a body by what its angular velocity brings in a step; see {@link #SMALL_TURN}. */
  void swing(int i, float da) {
    if (Math.abs(da) > SMALL_TURN) {
      setAngle(i, angle[i] + da);
    } else if (da != 0f) {
      turn(i, da);
    }
  }

  /** Sets the angle of a body and its sine and cosine. */
  public void setAngle(int i, float a) {
    angle[i] = a;
    pos[STRIDE * i + 2] = MathUtils.sin(a);
    pos[STRIDE * i + 3] = MathUtils.cos(a);
  }

  /**
   * Turns a body; by a small angle without trigonometry.
   *
   * <p>The unit vector {@code (c, s)} is moved along its tangent and drawn back to unit length by
   * one Newton step for {@code 1/sqrt}, {@code (3 - |q|^2) / 2}: the angle's error is {@code
   * da^3/3}, below 1e-4 rad for the largest correction in use (8 degrees) and far below float
   * rounding for usual ones. Beyond the square root of 3 the step would diverge. The exact sine and
   * cosine are taken from {@link #angle} when the step ends.
   */
  public void turn(int i, float da) {
    if (Math.abs(da) > LARGE_TURN) {
      setAngle(i, angle[i] + da);
      return;
    }
    angle[i] += da;
    int o = STRIDE * i;
    float s = pos[o + 2];
    float c = pos[o + 3];
    float s1 = s + da * c;
    float c1 = c - da * s;
    float k = 0.5f * (3f - (s1 * s1 + c1 * c1));
    pos[o + 2] = s1 * k;
    pos[o + 3] = c1 * k;
  }
}
