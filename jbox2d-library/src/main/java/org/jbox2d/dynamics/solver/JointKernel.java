package org.jbox2d.dynamics.solver;

/**
 * Solves the rows of one kind of joint. A kernel has no state: all it needs is in the rows and the
 * bodies, so one instance serves all worlds. Each stage is called once for a run of rows {@code
 * [from, to)} of its own kind.
 */
public abstract class JointKernel {
  private final int order;

  /**
   * @param order place among the kernels: rows of an island are solved in this order
   */
  protected JointKernel(int order) {
    this.order = order;
  }

  /** Place among the kernels. */
  public final int order() {
    return order;
  }

  /**
   * Computes arms and effective masses from the positions, and applies the impulses kept from the
   * last step, scaled by {@link StepConfig#dtRatio} (or zeroes them where warm starting is off).
   */
  public abstract void prepare(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);

  /** One velocity iteration. */
  public abstract void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);

  /**
   * One position iteration.
   *
   * @return whether all rows are within tolerance ({@link StepConfig#linearSlop}, {@link
   *     StepConfig#angularSlop})
   */
  public abstract boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step);
}
