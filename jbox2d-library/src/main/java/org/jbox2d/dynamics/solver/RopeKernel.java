package org.jbox2d.dynamics.solver;

/**
 * Keeps two points from getting further apart than a length.
 *
 * <pre>
 *   C = |d| - length &lt;= 0,   Cdot = u . (vB + wB x rB - vA - wA x rA)
 * </pre>
 *
 * Jacobian and mass as in {@link DistanceKernel}. The rope only pulls: the accumulated impulse
 * along u is clamped to be at most 0 (Catto, "Iterative dynamics with temporal coherence", 2005).
 * While it is slack, the points may part by what is left of it within the step: {@code Cdot +
 * stretch + C/h <= 0}; so it becomes taut without overshooting.
 */
public final class RopeKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 9;

  private static final int LENGTH = 8;
  // In and out.
  private static final int IMPULSE = 9;
  // Own.
  private static final int UX = 10;
  private static final int UY = 11;
  private static final int MASS = 12;
  private static final int ROOM = 13;
  private static final int EXCESS = 14;
  private static final int INV_LENGTH = 15;
  private static final int MOST_STRETCH = 16;

  RopeKernel(int order) {
    super(order, IMPULSE, 1);
  }

  /** Fills in a row's block behind its {@link Arms}. */
  public static void write(float[] f, int o, float length, float impulse) {
    f[o + LENGTH] = length;
    f[o + IMPULSE] = impulse;
  }

  /** Returns the impulse along {@link #axisX}, {@link #axisY} on body B, N s; not positive. */
  public static float impulse(float[] f, int o) {
    return f[o + IMPULSE];
  }

  /** Returns the direction from A to B along x. */
  public static float axisX(float[] f, int o) {
    return f[o + UX];
  }

  /** Returns the direction from A to B along y. */
  public static float axisY(float[] f, int o) {
    return f[o + UY];
  }

  /** Returns by how much the points were further apart than the length when the step began, m. */
  public static float excess(float[] f, int o) {
    return f[o + EXCESS];
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      Arms.turn(f, o, bodies.pos, a, b);
      float dx = Arms.gapX(f, o, bodies.pos, a, b);
      float dy = Arms.gapY(f, o, bodies.pos, a, b);
      float length = (float) Math.sqrt(dx * dx + dy * dy);
      float ux = length > 0f ? dx / length : 1f;
      float uy = length > 0f ? dy / length : 0f;
      f[o + UX] = ux;
      f[o + UY] = uy;
      float k = Arms.along(f, o, bodies.mass, a, b, ux, uy);
      f[o + MASS] = k > 0f ? 1f / k : 0f;
      float c = length - f[o + LENGTH];
      f[o + EXCESS] = c;
      float inv = f[o + INV_LENGTH] = length > 0f ? 1f / length : 0f;
      float atStart = Arms.stretch(f, o, v, a, b, ux, uy, inv, step.dt);
      f[o + MOST_STRETCH] = Arms.mostStretch(atStart, Math.max(c, 0f), step);
      float p = f[o + IMPULSE] *= step.warmStarting ? step.dtRatio : 0f;
      Arms.push(f, o, v, bodies.mass, a, b, p * ux, p * uy, 0f);
      f[o + ROOM] = Math.max(-c, 0f) * step.invDt;
    }
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float ux = f[o + UX];
      float uy = f[o + UY];
      float speed = ux * Arms.speedX(f, o, v, a, b) + uy * Arms.speedY(f, o, v, a, b);
      float stretch = Arms.stretch(f, o, v, a, b, ux, uy, f[o + INV_LENGTH], step.dt);
      speed += Arms.bounded(stretch, f[o + MOST_STRETCH]) - f[o + ROOM];
      float old = f[o + IMPULSE];
      float sum = Math.min(0f, old - f[o + MASS] * speed);
      f[o + IMPULSE] = sum;
      float p = sum - old;
      Arms.push(f, o, v, bodies.mass, a, b, p * ux, p * uy, 0f);
    }
  }

  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      float length = f[o + LENGTH];
      float most = step.maxLinearCorrection;
      done &= Arms.reach(f, o, bodies, slotA, slotB, length, true, most) <= step.linearSlop;
    }
    return done;
  }
}
