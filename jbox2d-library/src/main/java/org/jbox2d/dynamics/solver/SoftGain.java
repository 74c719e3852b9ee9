package org.jbox2d.dynamics.solver;

/**
 * Takes from islands without joints the energy that impulses kept from before have brought in with
 * {@link SoftStep}; {@link EnergyBooks} tells where there is some.
 *
 * <p>The impulses of a load that is gone threw up what it had lain on; so did those of a heap that
 * is driven apart. There iterations go on, from the impulses there are: those take back what is too
 * much, and lose nothing of what still holds up the rest. Only what is wild even then is solved
 * anew from no impulses.
 */
final class SoftGain {
  /**
   * Further passes over an island that has gained energy, at most. Most need a few; a stack whose
   * gravity ends, where each pass takes what is too much on by one storey, as many as it is high.
   */
  private static final int PASSES = 32;

  /**
   * Share of itself that a pass must leave of a gain at most, if another one is to be of use. What
   * topples gains a little by the arms of its contacts, which are those of the start of the step;
   * no pass takes that back.
   */
  private static final double USEFUL = 0.97;

  /** Passes over an island that is solved anew: as many as sequential impulses mostly make. */
  private static final int ANEW_PASSES = 8;

  /**
   * Speed, as of the mean energy of an island, from which on a gain is taken away, m/s, whatever
   * the gravity. Far less is not seen.
   */
  private static final double LEAST_SPEED = 0.005;

  /**
   * Time of a fall to that speed under gravity, s, if a substep is not longer: 0.05 m/s on earth.
   * So much is in an island that sets itself down; taken away there, it would sink, and from 0.02
   * m/s on a house of cards fell. Without gravity nothing sets itself down.
   */
  private static final double LEAST_FALL = 0.005;

  /**
   * Speed that the last pass of a substep took away, as a share of that speed, from which on it is
   * looked whether energy came in. At rest it is less; where a load is gone each contact of a pile
   * gives but a little, and all of them together throw up what lies on top.
   */
  private static final double UNREST = 0.4;

  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private final SoftContactKernel kernel;
  private final EnergyBooks energy;
  private double much;

  SoftGain(SolverBodies bodies, ContactConstraints contacts, SoftContactKernel kernel) {
    this.bodies = bodies;
    this.contacts = contacts;
    this.kernel = kernel;
    energy = new EnergyBooks(bodies, contacts);
  }

  /** Notes the energy of the bodies {@code slots[b0, b1)} before a step of some substeps. */
  void open(int[] slots, int b0, int b1, StepConfig step, int substeps) {
    energy.open(slots, b0, b1);
    double x = step.gravityX;
    double y = step.gravityY;
    double fall = Math.max(LEAST_FALL, step.dt / substeps);
    much = Math.max(LEAST_SPEED, Math.sqrt(x * x + y * y) * fall);
  }

  /**
   * Ends a substep, in which the bodies have moved already; it is their velocities that change.
   *
   * @param free velocities in the substep before contacts acted
   * @param summed as in {@link SoftContactKernel#relax}
   */
  void take(int[] slots, int b0, int b1, int c0, int c1, float[] free, boolean summed) {
    if (kernel.changed <= UNREST * much) {
      return;
    }
    double excess = energy.excess(slots, b0, b1, much);
    if (excess == 0 || energy.isDriven(c0, c1)) {
      return;
    }
    double before = Double.MAX_VALUE;
    for (int n = 0; n < PASSES && excess > 0 && excess < USEFUL * before; n++) {
      kernel.relax(contacts, bodies, c0, c1, summed, true);
      before = excess;
      excess = energy.excess(slots, b0, b1, much);
    }
    if (energy.isExceeded(slots, b0, b1, EnergyBooks.WILD)) {
      solveAnew(slots, b0, b1, c0, c1, free, summed);
    }
  }

  private void solveAnew(
      int[] slots, int b0, int b1, int c0, int c1, float[] free, boolean summed) {
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      System.arraycopy(free, o, bodies.vel, o, 3);
    }
    for (int i = c0; i < c1; i++) {
      kernel.drop(contacts, i);
    }
    for (int n = 0; n < ANEW_PASSES; n++) {
      kernel.relax(contacts, bodies, c0, c1, summed, true);
    }
  }
}
