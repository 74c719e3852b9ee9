package org.jbox2d.dynamics.solver;

/**
 * A soft constraint that pulls a point of one body to a target.
 *
 * <p>A spring-damper {@code F = -k C - d Cdot} integrated implicitly is a velocity constraint with
 * softness gamma and bias beta (Catto, "Soft constraints", GDC 2011):
 *
 * <pre>
 *   Cdot + beta C + gamma P = 0,   gamma = 1 / (h (d + h k)),   beta C = C h k gamma
 *   k = m omega^2,  d = 2 m zeta omega,  omega = 2 pi frequency
 * </pre>
 *
 * m is the mass of the body. The impulse of a step is at most {@code maxForce h}.
 */
public final class MouseKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = 18;

  // In: local anchor relative to the centre of mass, target, mass, frequency (Hz), damping ratio,
  // largest force.
  private static final int LOCAL_X = 0;
  private static final int LOCAL_Y = 1;
  private static final int TARGET_X = 2;
  private static final int TARGET_Y = 3;
  private static final int BODY_MASS = 4;
  private static final int FREQUENCY = 5;
  private static final int DAMPING = 6;
  private static final int MAX_FORCE = 7;
  // In and out: impulse.
  private static final int IMPULSE_X = 8;
  private static final int IMPULSE_Y = 9;
  // Own: arm, inverse of K + gamma (symmetric), softness, bias.
  private static final int RX = 10;
  private static final int RY = 11;
  private static final int M11 = 12;
  private static final int M12 = 13;
  private static final int M22 = 14;
  private static final int GAMMA = 15;
  private static final int BIAS_X = 16;
  private static final int BIAS_Y = 17;

  /**
   * Angular velocity that a held body keeps of the last step's at 60 Hz, so that it does not spin
   * on for ever.
   */
  private static final float SPIN_KEPT = 0.98f;

  MouseKernel(int order) {
    super(order, IMPULSE_X, 2);
  }

  /**
   * Fills in a row's block.
   *
   * @param localX anchor relative to the centre of mass, in the body's frame, m
   * @param bodyMass mass from which the spring's stiffness follows, kg
   */
  public static void write(
      float[] f,
      int o,
      float localX,
      float localY,
      float targetX,
      float targetY,
      float bodyMass,
      float frequency,
      float damping,
      float maxForce,
      float impulseX,
      float impulseY) {
    f[o + LOCAL_X] = localX;
    f[o + LOCAL_Y] = localY;
    f[o + TARGET_X] = targetX;
    f[o + TARGET_Y] = targetY;
    f[o + BODY_MASS] = bodyMass;
    f[o + FREQUENCY] = frequency;
    f[o + DAMPING] = damping;
    f[o + MAX_FORCE] = maxForce;
    f[o + IMPULSE_X] = impulseX;
    f[o + IMPULSE_Y] = impulseY;
  }

  /** Returns the impulse on the body along x, N s. */
  public static float impulseX(float[] f, int o) {
    return f[o + IMPULSE_X];
  }

  /** Returns the impulse on the body along y, N s. */
  public static float impulseY(float[] f, int o) {
    return f[o + IMPULSE_Y];
  }

  @Override
  float bend(JointRows rows, int row, SolverBodies bodies) {
    return 0f;
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float h = step.dt;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      float[] x = bodies.pos;
      float rx = x[b + 3] * f[o + LOCAL_X] - x[b + 2] * f[o + LOCAL_Y];
      float ry = x[b + 2] * f[o + LOCAL_X] + x[b + 3] * f[o + LOCAL_Y];
      f[o + RX] = rx;
      f[o + RY] = ry;

      float omega = 2f * (float) Math.PI * f[o + FREQUENCY];
      float stiffness = f[o + BODY_MASS] * omega * omega;
      float damper = 2f * f[o + BODY_MASS] * f[o + DAMPING] * omega;
      float soft = h * (damper + h * stiffness);
      float gamma = soft > 0f ? 1f / soft : 0f;
      float beta = h * stiffness * gamma;
      f[o + GAMMA] = gamma;
      f[o + BIAS_X] = beta * (x[b] + rx - f[o + TARGET_X]);
      f[o + BIAS_Y] = beta * (x[b + 1] + ry - f[o + TARGET_Y]);

      float m = bodies.mass[b];
      float i = bodies.mass[b + 1];
      float k11 = m + i * ry * ry + gamma;
      float k12 = -i * rx * ry;
      float k22 = m + i * rx * rx + gamma;
      float det = k11 * k22 - k12 * k12;
      float inv = det > 0f ? 1f / det : 0f;
      f[o + M11] = inv * k22;
      f[o + M12] = -inv * k12;
      f[o + M22] = inv * k11;

      float[] v = bodies.vel;
      v[b + 2] *= 1f - (1f - SPIN_KEPT) * (60f * h);
      float keep = step.warmStarting ? step.dtRatio : 0f;
      f[o + IMPULSE_X] *= keep;
      f[o + IMPULSE_Y] *= keep;
      apply(v, b, m, i, rx, ry, f[o + IMPULSE_X], f[o + IMPULSE_Y]);
    }
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      float rx = f[o + RX];
      float ry = f[o + RY];
      float oldX = f[o + IMPULSE_X];
      float oldY = f[o + IMPULSE_Y];
      float cx = v[b] - v[b + 2] * ry + f[o + BIAS_X] + f[o + GAMMA] * oldX;
      float cy = v[b + 1] + v[b + 2] * rx + f[o + BIAS_Y] + f[o + GAMMA] * oldY;
      float px = oldX - (f[o + M11] * cx + f[o + M12] * cy);
      float py = oldY - (f[o + M12] * cx + f[o + M22] * cy);
      float limit = f[o + MAX_FORCE] * step.dt;
      float size2 = px * px + py * py;
      if (size2 > limit * limit) {
        float scale = limit / (float) Math.sqrt(size2);
        px *= scale;
        py *= scale;
      }
      f[o + IMPULSE_X] = px;
      f[o + IMPULSE_Y] = py;
      apply(v, b, bodies.mass[b], bodies.mass[b + 1], rx, ry, px - oldX, py - oldY);
    }
  }

  /** A soft constraint has no position error to correct. */
  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    return true;
  }

  private static void apply(
      float[] v, int b, float m, float i, float rx, float ry, float px, float py) {
    v[b] += m * px;
    v[b + 1] += m * py;
    v[b + 2] += i * (rx * py - ry * px);
  }
}
