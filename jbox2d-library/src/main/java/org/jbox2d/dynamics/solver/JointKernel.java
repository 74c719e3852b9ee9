package org.jbox2d.dynamics.solver;

/**
 * Solves the rows of one kind of joint. A kernel has no state: all it needs is in the rows and the
 * bodies, so one instance serves all worlds. Each stage is called for a run of rows {@code [from,
 * to)} of its own kind, most of them once.
 */
public abstract class JointKernel {
  private final int order;
  private final int firstImpulse;
  private final int impulses;

  /**
   * @param order place among the kernels: rows of an island are solved in this order
   * @param firstImpulse place in a row's block of the impulses kept from step to step
   * @param impulses how many there are
   */
  protected JointKernel(int order, int firstImpulse, int impulses) {
    this.order = order;
    this.firstImpulse = firstImpulse;
    this.impulses = impulses;
  }

  /** Place among the kernels. */
  public final int order() {
    return order;
  }

  /** Multiplies the impulses of rows {@code [from, to)}: from those of a substep to a step's. */
  final void scaleImpulses(JointRows rows, int from, int to, float factor) {
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r] + firstImpulse;
      for (int i = 0; i < impulses; i++) {
        rows.f[o + i] *= factor;
      }
    }
  }

  /** Returns the largest {@code r w^2} of a row's arms, m/s^2; 0 for a row without arms. */
  float bend(JointRows rows, int row, SolverBodies bodies) {
    int o = rows.floatAt[row];
    int at = rows.bodyAt[row];
    return Math.max(
        Arms.bend(rows.f, o, bodies.vel[SolverBodies.STRIDE * rows.bodies[at] + 2]),
        Arms.bend(rows.f, o + 2, bodies.vel[SolverBodies.STRIDE * rows.bodies[at + 1] + 2]));
  }

  /**
   * Returns by how much the moment that a row bore in the last step would turn the lighter of its
   * bodies, rad/s; 0 for a row that bears none.
   */
  float twist(JointRows rows, int row, SolverBodies bodies) {
    return 0f;
  }

  /**
   * Takes the bodies' velocities as those before the forces of a substep, where a kernel needs
   * them. For a whole step they are written when the row is gathered.
   */
  void keepVelocities(JointRows rows, int from, int to, SolverBodies bodies) {}

  /**
   * Computes arms and effective masses from the positions, and applies the impulses kept from the
   * last step, scaled by {@link StepConfig#dtRatio} (or zeroes them where warm starting is off).
   */
  public abstract void prepare(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);

  /** One velocity iteration. */
  public abstract void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);

  /** Whether positions are corrected in each substep, not only in the last of a step. */
  boolean isCorrectedOften() {
    return false;
  }

  /**
   * One position iteration.
   *
   * @return whether all rows are within tolerance ({@link StepConfig#linearSlop}, {@link
   *     StepConfig#angularSlop})
   */
  public abstract boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);
}
