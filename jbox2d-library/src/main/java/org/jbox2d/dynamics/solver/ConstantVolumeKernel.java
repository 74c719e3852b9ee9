package org.jbox2d.dynamics.solver;

/**
 * Keeps the area of the polygon whose corners are the centres of n bodies.
 *
 * <pre>
 *   C      = 1/2 sum x_i x x_i+1 - target
 *   dC/dx_i = 1/2 (y_i+1 - y_i-1, x_i-1 - x_i+1)
 *   K      = sum mi |dC/dx_i|^2
 * </pre>
 *
 * One equality row over all bodies: a pressure, equal on all edges. The area may have either sign.
 * The bend of the path (see {@link Arms}) is {@code h/2 sum v_i x v_i+1}; the area is a quadratic
 * form, so with it the step's area is exact. Position correction by Newton steps, none of which
 * moves a body further than the largest linear correction. If the ring has collapsed into one
 * place, the gradient vanishes and nothing is done. Source of the area: Green's theorem; of the
 * solution: Baumgarte and Catto as for any equality (GDC 2009).
 */
public final class ConstantVolumeKernel extends JointKernel {
  private static final int TARGET = 0;
  // In and out.
  private static final int IMPULSE = 1;
  // Own.
  private static final int MASS = 2;
  // Gradients, two floats a body.
  private static final int J = 3;

  /**
   * A ring whose gradient, squared, is below this share of its area has collapsed; its direction is
   * noise.
   */
  private static final float FLAT = 1e-6f;

  /**
   * Largest share of the bend in what the speeds do in first order. Beyond it, bodies move as far
   * as the ring is wide in one step, and the iterations would run away.
   */
  private static final float MOST_BEND = 0.25f;

  ConstantVolumeKernel(int order) {
    super(order, IMPULSE, 1);
  }

  /** Length of the block of a row with n bodies. */
  public static int floats(int n) {
    return J + 2 * n;
  }

  /** Fills in the area that is to be kept, m^2, and the impulse kept from the last step. */
  public static void write(float[] f, int o, float target, float impulse) {
    f[o + TARGET] = target;
    f[o + IMPULSE] = impulse;
  }

  /** Returns the impulse on the area, N s / m. */
  public static float impulse(float[] f, int o) {
    return f[o + IMPULSE];
  }

  /** Returns the gradient of the area by the place of body i along x, m. */
  public static float gradientX(float[] f, int o, int i) {
    return f[o + J + 2 * i];
  }

  /** Returns the gradient of the area by the place of body i along y, m. */
  public static float gradientY(float[] f, int o, int i) {
    return f[o + J + 2 * i + 1];
  }

  @Override
  float bend(JointRows rows, int row, SolverBodies bodies) {
    return 0f;
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      place(rows, r, bodies);
      f[o + IMPULSE] *= keep;
      push(rows, r, bodies, f[o + IMPULSE]);
    }
  }

  /** Computes gradients and mass; returns C. */
  private static float place(JointRows rows, int r, SolverBodies bodies) {
    float[] f = rows.f;
    float[] x = bodies.pos;
    int o = rows.floatAt[r];
    int s = rows.bodyAt[r];
    int n = rows.bodyCount[r];
    int first = SolverBodies.STRIDE * rows.bodies[s];
    int last = SolverBodies.STRIDE * rows.bodies[s + n - 1];
    int b = first;
    float area = 0f;
    float sum = 0f;
    float masses = 0f;
    for (int i = 0; i < n; i++) {
      int next = i + 1 < n ? SolverBodies.STRIDE * rows.bodies[s + i + 1] : first;
      float gx = 0.5f * (x[next + 1] - x[last + 1]);
      float gy = 0.5f * (x[last] - x[next]);
      f[o + J + 2 * i] = gx;
      f[o + J + 2 * i + 1] = gy;
      sum += bodies.mass[b] * (gx * gx + gy * gy);
      masses += bodies.mass[b];
      // Relative to the first corner, so that a polygon far from the origin keeps its digits.
      area +=
          (x[b] - x[first]) * (x[next + 1] - x[first + 1])
              - (x[b + 1] - x[first + 1]) * (x[next] - x[first]);
      last = b;
      b = next;
    }
    float least = Math.max(Float.MIN_NORMAL, FLAT * masses * Math.abs(f[o + TARGET]));
    f[o + MASS] = sum > least ? 1f / sum : 0f;
    return 0.5f * area - f[o + TARGET];
  }

  private static void push(JointRows rows, int r, SolverBodies bodies, float p) {
    float[] f = rows.f;
    int s = rows.bodyAt[r];
    int j = rows.floatAt[r] + J;
    for (int i = 0; i < rows.bodyCount[r]; i++) {
      int b = SolverBodies.STRIDE * rows.bodies[s + i];
      float m = bodies.mass[b] * p;
      bodies.vel[b] += m * f[j + 2 * i];
      bodies.vel[b + 1] += m * f[j + 2 * i + 1];
    }
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int s = rows.bodyAt[r];
      int n = rows.bodyCount[r];
      int first = SolverBodies.STRIDE * rows.bodies[s];
      int b = first;
      float speed = 0f;
      float bend = 0f;
      float bound = 0f;
      for (int i = 0; i < n; i++) {
        int next = i + 1 < n ? SolverBodies.STRIDE * rows.bodies[s + i + 1] : first;
        float vx = v[b] - v[first];
        float vy = v[b + 1] - v[first + 1];
        float gx = f[o + J + 2 * i];
        float gy = f[o + J + 2 * i + 1];
        speed += gx * vx + gy * vy;
        bound += Math.abs(gx * vx) + Math.abs(gy * vy);
        bend += vx * (v[next + 1] - v[first + 1]) - vy * (v[next] - v[first]);
        b = next;
      }
      bound *= MOST_BEND;
      bend = Math.max(-bound, Math.min(bound, 0.5f * step.dt * bend));
      float p = -f[o + MASS] * (speed + bend);
      f[o + IMPULSE] += p;
      push(rows, r, bodies, p);
    }
  }

  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int s = rows.bodyAt[r];
      int n = rows.bodyCount[r];
      float c = place(rows, r, bodies);
      float p = -f[o + MASS] * c;
      float longest = 0f;
      for (int i = 0; i < n; i++) {
        float m = p * bodies.mass[SolverBodies.STRIDE * rows.bodies[s + i]];
        float gx = m * f[o + J + 2 * i];
        float gy = m * f[o + J + 2 * i + 1];
        longest = Math.max(longest, gx * gx + gy * gy);
      }
      longest = (float) Math.sqrt(longest);
      p *= Arms.share(longest, step.maxLinearCorrection);
      for (int i = 0; i < n; i++) {
        int b = SolverBodies.STRIDE * rows.bodies[s + i];
        float m = p * bodies.mass[b];
        bodies.pos[b] += m * f[o + J + 2 * i];
        bodies.pos[b + 1] += m * f[o + J + 2 * i + 1];
      }
      done &= longest <= step.linearSlop;
    }
    return done;
  }
}
