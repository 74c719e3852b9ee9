package org.jbox2d.dynamics.solver;

/**
 * How fast the links of {@link HingeChains} sway: turned by an angle t, one is turned back by the
 * moments {@code T r t} of the tensions at both of its ends, so its angular frequency is
 *
 * <pre>
 *   w^2 = (T1 r1 + T2 r2) / I
 * </pre>
 *
 * with the tensions of the last step, and no less than the weight of what hangs on them. Neighbours
 * that hold still make it highest; it is a bound for those that do not.
 */
final class ChainSway {
  /** Share of the weight that hangs on a link below which it counts as slack. */
  private static final float LEAST_TENSION = 0.5f;

  private final SolverBodies bodies;
  private final JointRows rows;
  private final HingeChains chains;

  ChainSway(SolverBodies bodies, JointRows rows, HingeChains chains) {
    this.bodies = bodies;
    this.rows = rows;
    this.chains = chains;
  }

  /**
   * Returns the largest {@code w^2} of all chains that have been found, 1/s^2. Infinite where the
   * last step says nothing of the next: where a link is slack, and may be jerked taut, or has just
   * been struck.
   */
  float square(float gravity, StepConfig step) {
    float most = 0f;
    for (int k = 0; k < chains.count(); k++) {
      most = Math.max(most, square(chains.start(k), chains.start(k + 1), gravity, step));
    }
    return most;
  }

  private float square(int from, int to, float gravity, StepConfig step) {
    float[] m = bodies.mass;
    float most = 0f;
    float moment = 0f;
    float weight = 0f;
    for (int i = from; i < to; i++) {
      int near = chains.nearBody(i);
      int at = SolverBodies.STRIDE * near;
      weight += gravity / m[at];
      float tension = tension(i, step);
      boolean slack = tension > 0f && tension < LEAST_TENSION * weight;
      if (slack || isStruck(i, step)) {
        return Float.POSITIVE_INFINITY;
      }
      tension = Math.max(tension, weight);
      most = Math.max(most, m[at + 1] * (moment + tension * arm(i, near)));
      moment = tension * arm(i, chains.farBody(i));
    }
    return Math.max(most, m[SolverBodies.STRIDE * chains.farBody(to - 1) + 1] * moment);
  }

  /** Returns what a link bore in the last step, N; 0 if it was not there. */
  private float tension(int i, StepConfig step) {
    int o = rows.floatAt[chains.row(i)];
    float x = RevoluteKernel.impulseX(rows.f, o);
    float y = RevoluteKernel.impulseY(rows.f, o);
    return step.dtRatio * step.invDt * (float) Math.sqrt(x * x + y * y);
  }

  /** Whether the points of a link come apart by more than a slop in the step; turns its arms. */
  private boolean isStruck(int i, StepConfig step) {
    int r = chains.row(i);
    int o = rows.floatAt[r];
    int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
    int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
    Arms.turn(rows.f, o, bodies.pos, a, b);
    float x = step.dt * Arms.speedX(rows.f, o, bodies.vel, a, b);
    float y = step.dt * Arms.speedY(rows.f, o, bodies.vel, a, b);
    return x * x + y * y > step.linearSlop * step.linearSlop;
  }

  /** Returns the length of a link's turned arm in one of its bodies, m. */
  private float arm(int i, int slot) {
    int r = chains.row(i);
    boolean isB = rows.bodies[rows.bodyAt[r] + 1] == slot;
    int o = rows.floatAt[r] + (isB ? Arms.RBX : Arms.RAX);
    float x = rows.f[o];
    float y = rows.f[o + 1];
    return (float) Math.sqrt(x * x + y * y);
  }
}
