package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Sequential impulses: velocity iterations with warm starting, then position iterations that stop
 * as soon as an island is within tolerance. Islands are independent, so each is solved to its end
 * while its data is in the cache.
 *
 * <p>Stages, in order: {@link #prepare}, {@link #solveVelocities}, positions integrated by the
 * caller, {@link #solvePositions}.
 */
public final class SequentialImpulses {
  /** A step is done with an island when no point is deeper than this many slops. */
  private static final float ACCEPTED_SLOPS = 3f;

  /** How often the velocity iterations of an island that has gained energy are done again. */
  private static final int MOST_ROUNDS = 4;

  /** Share of its energy that an island may gain by bounces. */
  private static final double MOST_GAIN = 0.01;

  /** Share of themselves to which bounces are lowered where they bring in more. */
  private static final float LOWERED = 0.9f;

  /** How often they are; what is left of them then is a twelfth. */
  private static final int MOST_LOWERED = 24;

  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private final JointRows joints;
  private final EnergyBooks energy;

  public SequentialImpulses(SolverBodies bodies, ContactConstraints contacts, JointRows joints) {
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = joints;
    energy = new EnergyBooks(bodies, contacts);
  }

  /** Notes the energy of an island's bodies {@code slots[b0, b1)} before it is prepared. */
  public void noteEnergy(int[] slots, int b0, int b1) {
    energy.open(slots, b0, b1);
  }

  /** Prepares and warm starts one island: contacts {@code [c0, c1)}, joints {@code [j0, j1)}. */
  public void prepare(int c0, int c1, int j0, int j1, StepConfig step) {
    ContactPreparation.prepare(contacts, bodies, c0, c1, step.velocityThreshold);
    if (step.warmStarting) {
      ContactVelocityKernel.warmStart(contacts, bodies, c0, c1);
    }
    for (int r = j0; r < j1; ) {
      int end = joints.endOfRun(r, j1);
      joints.kernel[r].prepare(joints, r, end, bodies, step);
      r = end;
    }
  }

  /**
   * Iterates on where an island without joints has more energy than was noted (see {@link
   * EnergyBooks}), at last with lower bounces.
   */
  public void takeGain(int[] slots, int b0, int b1, int c0, int c1, StepConfig step) {
    double wild = EnergyBooks.WILD;
    if (!energy.isExceeded(slots, b0, b1, wild) || energy.isDriven(c0, c1)) {
      return;
    }
    for (int n = 0; n < MOST_ROUNDS && energy.isExceeded(slots, b0, b1, wild); n++) {
      solveVelocities(c0, c1, 0, 0, step);
    }
    for (int n = 0; n < MOST_LOWERED && energy.gain(slots, b0, b1, wild) > MOST_GAIN; n++) {
      if (!lowerBounces(c0, c1)) {
        return;
      }
      solveVelocities(c0, c1, 0, 0, step);
    }
  }

  /**
   * Lowers the speeds at which points are to part; returns whether one is to. Each is to be a share
   * of the speed at which the point closed; where several bodies meet at once, all of that together
   * may be more energy than there was (Brogliato, "Nonsmooth Mechanics", 3rd ed. 2016, chapter 5:
   * Newton's law of impact is consistent with energy for single impacts).
   */
  private boolean lowerBounces(int c0, int c1) {
    boolean any = false;
    for (int i = c0; i < c1; i++) {
      for (int j = 0; j < contacts.pointCount[i]; j++) {
        int o = V_STRIDE * i + POINT + POINT_STRIDE * j + BIAS;
        any |= contacts.vel[o] > 0f;
        contacts.vel[o] *= LOWERED;
      }
    }
    return any;
  }

  /** Runs the velocity iterations of one island. */
  public void solveVelocities(int c0, int c1, int j0, int j1, StepConfig step) {
    for (int n = 0; n < step.velocityIterations; n++) {
      for (int r = j0; r < j1; ) {
        int end = joints.endOfRun(r, j1);
        joints.kernel[r].solveVelocity(joints, r, end, bodies, step);
        r = end;
      }
      ContactVelocityKernel.solve(contacts, bodies, c0, c1);
    }
  }

  /**
   * Runs the position iterations of one island.
   *
   * @return whether it ended within tolerance
   */
  public boolean solvePositions(int c0, int c1, int j0, int j1, StepConfig step) {
    for (int n = 0; n < step.positionIterations; n++) {
      float least =
          ContactPositionKernel.solve(
              contacts, bodies, c0, c1, step.baumgarte, step.linearSlop, step.maxLinearCorrection);
      boolean done = least >= -ACCEPTED_SLOPS * step.linearSlop;
      for (int r = j0; r < j1; ) {
        int end = joints.endOfRun(r, j1);
        done &= joints.kernel[r].solvePosition(joints, r, end, bodies, step);
        r = end;
      }
      if (done) {
        return true;
      }
    }
    return false;
  }
}
