package org.jbox2d.dynamics.solver;

/** Passes over the joints of an island, {@code [j0, j1)}, in {@link SoftStep}. */
final class SoftJoints {
  /**
   * Turn of a body in a substep from which on its joints are solved further times, rad. The bend of
   * a path follows from the velocity, and one pass takes it from that before the impulses: a rod
   * that turns by t about a pin gains {@code 3 t^6} of its energy in a substep, half of it in 20 s
   * at 40 rad/s and 60 steps of 4 substeps; with two further passes nothing.
   */
  private static final float FAST_TURN = 0.1f;

  /** The same from which on its path is too coarse to be followed more closely. */
  private static final float WILD_TURN = 0.5f;

  /** What its arm must come to, {@code r t^2} in slops, for that to matter. */
  private static final float FAST_BEND_SLOPS = 0.2f;

  private static final int FAST_PASSES = 2;

  private final SolverBodies bodies;
  private final JointRows rows;
  private final HingeChains chains;

  /** Joints that turn fast in this substep. */
  private int[] fast = new int[16];

  private int fastCount;

  SoftJoints(SolverBodies bodies, JointRows rows) {
    this.bodies = bodies;
    this.rows = rows;
    chains = new HingeChains(bodies, rows);
  }

  /**
   * Begins an island: bodies {@code slots[b0, b1)}.
   *
   * @param touching whether it has contacts
   */
  void begin(int j0, int j1, int[] slots, int b0, int b1, boolean touching, StepConfig sub) {
    fastCount = 0;
    chains.find(j0, j1, slots, b0, b1, touching, sub);
  }

  /** Notes velocities before the forces of a substep, for kernels that need them. */
  void keepVelocities(int j0, int j1) {
    for (int r = j0; r < j1; ) {
      int end = rows.endOfRun(r, j1);
      rows.kernel[r].keepVelocities(rows, r, end, bodies);
      r = end;
    }
  }

  /** Prepares a substep; the bodies have been accelerated. */
  void prepare(int j0, int j1, StepConfig sub) {
    fastCount = 0;
    for (int r = j0; r < j1; ) {
      int end = rows.endOfRun(r, j1);
      rows.kernel[r].prepare(rows, r, end, bodies, sub);
      r = end;
    }
    chains.factor();
  }

  /**
   * Finds the joints of {@link #FAST_TURN} once they are prepared, of bodies {@code slots[b0, b1)}
   * that touch nothing: where bodies touch, more energy is lost than fast joints bring in.
   */
  void findFast(int j0, int j1, int[] slots, int b0, int b1, StepConfig sub) {
    float fastest = 0f;
    for (int k = b0; k < b1; k++) {
      fastest = Math.max(fastest, Math.abs(bodies.vel[SolverBodies.STRIDE * slots[k] + 2]));
    }
    if (fastest * sub.dt <= FAST_TURN) {
      return;
    }
    if (fast.length < j1 - j0) {
      fast = new int[j1 - j0 + (j1 - j0 >> 1)];
    }
    float bend = FAST_BEND_SLOPS * sub.linearSlop * sub.invDt * sub.invDt;
    for (int r = j0; r < j1; r++) {
      float turn = sub.dt * fastestOf(r);
      boolean isFast = turn > FAST_TURN && turn < WILD_TURN;
      if (isFast && rows.kernel[r].bend(rows, r, bodies) > bend) {
        fast[fastCount++] = r;
      }
    }
  }

  /** Returns the largest angular speed of a row's bodies, rad/s. */
  private float fastestOf(int row) {
    int at = rows.bodyAt[row];
    float fastest = 0f;
    for (int k = at; k < at + rows.bodyCount[row]; k++) {
      fastest = Math.max(fastest, Math.abs(bodies.vel[SolverBodies.STRIDE * rows.bodies[k] + 2]));
    }
    return fastest;
  }

  /** One pass over all joints, further ones over those that turn fast, and the chains at once. */
  void solve(int j0, int j1, StepConfig sub) {
    for (int r = j0; r < j1; ) {
      int end = rows.endOfRun(r, j1);
      rows.kernel[r].solveVelocity(rows, r, end, bodies, sub);
      r = end;
    }
    for (int n = 0; n < FAST_PASSES; n++) {
      for (int i = 0; i < fastCount; i++) {
        int r = fast[i];
        rows.kernel[r].solveVelocity(rows, r, r + 1, bodies, sub);
      }
    }
    chains.solve(sub);
  }

  /**
   * Corrects positions in the last substep, and before it those of chains and of kernels that need
   * it. Following their curves, joints hardly leave them in a substep; to correct all of them each
   * time costs a sixth of a net's step, and errors stay the same to a few percent.
   *
   * @return whether all that were looked at are within tolerance
   */
  boolean correct(int j0, int j1, boolean last, StepConfig sub) {
    chains.correct(sub);
    boolean done = true;
    for (int r = j0; r < j1; ) {
      int end = rows.endOfRun(r, j1);
      if (last || rows.kernel[r].isCorrectedOften()) {
        done &= rows.kernel[r].solvePosition(rows, r, end, bodies, sub);
      }
      r = end;
    }
    return done;
  }

  /** Whether {@link #correct} moves bodies. */
  boolean areCorrected(int j0, int j1, boolean last) {
    if (last || chains.areThere()) {
      return j0 < j1;
    }
    for (int r = j0; r < j1; r = rows.endOfRun(r, j1)) {
      if (rows.kernel[r].isCorrectedOften()) {
        return true;
      }
    }
    return false;
  }

  /** Multiplies the impulses of a substep up to those of a step. */
  void scaleImpulses(int j0, int j1, int substeps) {
    for (int r = j0; r < j1; ) {
      int end = rows.endOfRun(r, j1);
      rows.kernel[r].scaleImpulses(rows, r, end, substeps);
      r = end;
    }
  }

  /** Sets {@code marks} of the bodies that have joints to {@code mark}. */
  void mark(int j0, int j1, int[] marks, int mark) {
    for (int r = j0; r < j1; r++) {
      int at = rows.bodyAt[r];
      for (int k = at; k < at + rows.bodyCount[r]; k++) {
        marks[rows.bodies[k]] = mark;
      }
    }
  }
}
