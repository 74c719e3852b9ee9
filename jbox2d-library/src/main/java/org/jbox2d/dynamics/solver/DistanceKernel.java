package org.jbox2d.dynamics.solver;

/**
 * Keeps two points at a distance, hard or by a spring.
 *
 * <pre>
 *   C    = |d| - length,   d = xB + rB - xA - rA,   u = d / |d|
 *   Cdot = u . (vB + wB x rB - vA - wA x rA)
 *   J M^-1 J^T = mA + mB + iA (rA x u)^2 + iB (rB x u)^2
 * </pre>
 *
 * Hard: {@code Cdot + stretch = 0} (see {@link Arms}), position correction by Newton steps. Soft:
 * see {@link Spring}, no position correction. Nothing is clamped: the joint pulls and pushes. If
 * the points coincide, the x axis serves as direction.
 */
public final class DistanceKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 17;

  private static final int LENGTH = 8;
  private static final int FREQUENCY = 9;
  private static final int DAMPING = 10;

  /** Place of six floats: velocities of A and B before the step's forces (x, y, angular). */
  public static final int BEFORE = 11;

  // In and out.
  private static final int IMPULSE = 17;
  // Own.
  private static final int UX = 18;
  private static final int UY = 19;
  private static final int MASS = 20;
  private static final int GAMMA = 21;
  private static final int BIAS = 22;
  private static final int INV_LENGTH = 23;
  private static final int MOST_STRETCH = 24;

  DistanceKernel(int order) {
    super(order, IMPULSE, 1);
  }

  /**
   * Fills in a row's block behind its {@link Arms}; {@link #BEFORE} is needed for a spring alone.
   *
   * @param frequency Hz; 0 for a hard constraint
   */
  public static void write(
      float[] f, int o, float length, float frequency, float damping, float impulse) {
    f[o + LENGTH] = length;
    f[o + FREQUENCY] = frequency;
    f[o + DAMPING] = damping;
    f[o + IMPULSE] = impulse;
  }

  /** Returns the impulse along {@link #axisX}, {@link #axisY} on body B, N s. */
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

  @Override
  void keepVelocities(JointRows rows, int from, int to, SolverBodies bodies) {
    for (int r = from; r < to; r++) {
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      System.arraycopy(bodies.vel, a, rows.f, rows.floatAt[r] + BEFORE, 3);
      System.arraycopy(bodies.vel, b, rows.f, rows.floatAt[r] + BEFORE + 3, 3);
    }
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    float h = step.dt;
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
      if (f[o + FREQUENCY] > 0f && k > 0f) {
        float before = before(f, o, ux, uy);
        Spring.soften(
            f, o + GAMMA, k, f[o + FREQUENCY], f[o + DAMPING], h, length - f[o + LENGTH], before);
        k += f[o + GAMMA];
      } else {
        f[o + GAMMA] = 0f;
        float inv = f[o + INV_LENGTH] = length > 0f ? 1f / length : 0f;
        float atStart = Arms.stretch(f, o, v, a, b, ux, uy, inv, h);
        f[o + MOST_STRETCH] = Arms.mostStretch(atStart, length - f[o + LENGTH], step);
      }
      f[o + MASS] = k > 0f ? 1f / k : 0f;
      float p = f[o + IMPULSE] *= step.warmStarting ? step.dtRatio : 0f;
      Arms.push(f, o, v, bodies.mass, a, b, p * ux, p * uy, 0f);
    }
  }

  private static float before(float[] f, int o, float ux, float uy) {
    int s = o + BEFORE;
    float x = f[s + 3] - f[s + 5] * f[o + Arms.RBY] - f[s] + f[s + 2] * f[o + Arms.RAY];
    float y = f[s + 4] + f[s + 5] * f[o + Arms.RBX] - f[s + 1] - f[s + 2] * f[o + Arms.RAX];
    return ux * x + uy * y;
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
      speed +=
          f[o + GAMMA] > 0f
              ? f[o + BIAS] + f[o + GAMMA] * f[o + IMPULSE]
              : Arms.bounded(
                  Arms.stretch(f, o, v, a, b, ux, uy, f[o + INV_LENGTH], step.dt),
                  f[o + MOST_STRETCH]);
      float p = -f[o + MASS] * speed;
      f[o + IMPULSE] += p;
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
      if (f[o + FREQUENCY] > 0f) {
        continue;
      }
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      float length = f[o + LENGTH];
      float most = step.maxLinearCorrection;
      done &= Arms.reach(f, o, bodies, slotA, slotB, length, false, most) <= step.linearSlop;
    }
    return done;
  }
}
