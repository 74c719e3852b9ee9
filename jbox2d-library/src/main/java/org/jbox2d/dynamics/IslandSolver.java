package org.jbox2d.dynamics;

import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.common.Settings;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.SequentialImpulses;
import org.jbox2d.dynamics.solver.SolverBodies;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Solves the constraints of a step: gathers bodies, contacts and joints into flat arrays, runs the
 * solver island by island, scatters the results, reports them, and puts calm islands to sleep.
 */
final class IslandSolver {
  private final World world;
  private final Islands islands = new Islands();
  private final SolverBodies bodies = new SolverBodies();
  private final ContactConstraints constraints = new ContactConstraints();
  private final JointRows joints = new JointRows();
  private final SequentialImpulses solver = new SequentialImpulses(bodies, constraints, joints);
  private final SolvedContactReport report;

  /** Rises with each step; tells which bodies that do not move have a slot. */
  private long stamp;

  /** Number of awake bodies when they were gathered. */
  private int gathered;

  private float[] minSleepTime = new float[64];
  private boolean[] settled = new boolean[64];

  IslandSolver(World world) {
    this.world = world;
    report = new SolvedContactReport(constraints, bodies, false);
  }

  void solve(StepConfig step, Profile profile) {
    profile.solveInit.startAccum();
    islands.build(world.awake, world.m_contactManager);
    gatherBodies(step);
    gatherContacts(step);
    gatherJoints();
    report.keepVelocities();
    profile.solveInit.accumElapsed();
    profile.solveVelocity.startAccum();
    solveVelocities(step);
    profile.solveVelocity.accumElapsed();
    profile.solvePosition.startAccum();
    solvePositions(step, profile);
    profile.solvePosition.accumElapsed();
    scatter(step);
    ContactListener listener = world.m_contactManager.m_contactListener;
    if (listener != null || islands.materials) {
      report.send(islands.contacts, islands.contactCount, listener, step);
    }
    islands.release();
  }

  // --- Gather ---

  /**
   * Copies the awake bodies to their slots and applies gravity, forces and damping to the
   * velocities.
   */
  private void gatherBodies(StepConfig step) {
    stamp++;
    AwakeSet awake = world.awake;
    int n = awake.count;
    bodies.count = n;
    gathered = n;
    bodies.ensureCapacity(n);
    for (int i = 0; i < n; i++) {
      Body b = awake.bodies[i];
      b.m_islandIndex = i;
      b.m_sweep.c0.set(b.m_sweep.c);
      b.m_sweep.a0 = b.m_sweep.a;
      b.m_sweep.alpha0 = 0f;
      b.m_xf0.set(b.m_xf);
      writeState(b, i);
      if (b.m_type == BodyType.DYNAMIC) {
        integrateVelocity(b, i, step);
      }
    }
  }

  private void writeState(Body b, int slot) {
    int o = SolverBodies.STRIDE * slot;
    float[] v = bodies.vel;
    float[] x = bodies.pos;
    float[] m = bodies.mass;
    v[o] = b.m_linearVelocity.x;
    v[o + 1] = b.m_linearVelocity.y;
    v[o + 2] = b.m_angularVelocity;
    x[o] = b.m_sweep.c.x;
    x[o + 1] = b.m_sweep.c.y;
    x[o + 2] = b.m_xf.q.s;
    x[o + 3] = b.m_xf.q.c;
    m[o] = b.m_invMass;
    m[o + 1] = b.m_invI;
    m[o + 2] = b.m_sweep.localCenter.x;
    m[o + 3] = b.m_sweep.localCenter.y;
    bodies.angle[slot] = b.m_sweep.a;
  }

  /**
   * Semi-implicit Euler: {@code v += h (g + F/m)}; damping {@code dv/dt = -c v} by implicit Euler,
   * {@code v /= 1 + h c}, which is stable for any c.
   */
  private void integrateVelocity(Body b, int slot, StepConfig step) {
    float h = step.dt;
    float[] v = bodies.vel;
    int o = SolverBodies.STRIDE * slot;
    // A body that never moves by forces (mass given as infinite) is not moved by gravity either.
    float gravity = b.m_invMass > 0f ? b.m_gravityScale : 0f;
    float linear = 1f / (1f + h * b.m_linearDamping);
    v[o] = (v[o] + h * (gravity * step.gravityX + b.m_invMass * b.m_force.x)) * linear;
    v[o + 1] = (v[o + 1] + h * (gravity * step.gravityY + b.m_invMass * b.m_force.y)) * linear;
    v[o + 2] = (v[o + 2] + h * b.m_invI * b.m_torque) / (1f + h * b.m_angularDamping);
  }

  /**
   * Returns the slot of a body; one that does not move gets a slot behind the awake ones when first
   * met in a step.
   */
  private int slotOf(Body b) {
    if (b.awakeIndex >= 0) {
      return b.awakeIndex;
    }
    if (b.slotStamp != stamp) {
      b.slotStamp = stamp;
      int slot = bodies.count++;
      bodies.ensureCapacity(bodies.count);
      b.m_islandIndex = slot;
      writeState(b, slot);
      int o = SolverBodies.STRIDE * slot;
      bodies.mass[o] = 0f;
      bodies.mass[o + 1] = 0f;
    }
    return b.m_islandIndex;
  }

  private void gatherContacts(StepConfig step) {
    int n = islands.contactCount;
    constraints.count = n;
    constraints.ensureCapacity(n);
    for (int i = 0; i < n; i++) {
      Contact c = islands.contacts[i];
      constraints.bodyA[i] = slotOf(c.m_fixtureA.m_body);
      constraints.bodyB[i] = slotOf(c.m_fixtureB.m_body);
      ContactGather.writeVelocityRecord(constraints, i, c, bodies, step);
      ContactGather.writePositionRecord(constraints, i, c, bodies);
    }
  }

  private void gatherJoints() {
    joints.clear();
    for (int i = 0; i < islands.jointCount; i++) {
      Joint joint = islands.joints[i];
      for (int k = 0; k < joint.bodyCount(); k++) {
        slotOf(joint.body(k));
      }
      joint.gather(joints);
    }
  }

  // --- Solve ---

  private void solveVelocities(StepConfig step) {
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    for (int k = 0; k < islands.count; k++) {
      if (c[k] < c[k + 1] || j[k] < j[k + 1]) {
        solver.prepare(c[k], c[k + 1], j[k], j[k + 1], step);
        BounceTiming.correct(constraints, islands.contacts, c[k], c[k + 1], 0f, step);
        solver.solveVelocities(c[k], c[k + 1], j[k], j[k + 1], step);
      }
    }
  }

  private void solvePositions(StepConfig step, Profile profile) {
    profile.cappedVelocities =
        bodies.integratePositions(gathered, step.dt, step.maxTranslation, step.maxRotation);
    if (settled.length < islands.count) {
      settled = new boolean[islands.count + (islands.count >> 1)];
    }
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    for (int k = 0; k < islands.count; k++) {
      settled[k] =
          (c[k] == c[k + 1] && j[k] == j[k + 1])
              || solver.solvePositions(c[k], c[k + 1], j[k], j[k + 1], step);
    }
  }

  // --- Scatter ---

  private void scatter(StepConfig step) {
    AwakeSet awake = world.awake;
    float[] v = bodies.vel;
    float[] x = bodies.pos;
    for (int i = 0; i < gathered; i++) {
      Body b = awake.bodies[i];
      int o = SolverBodies.STRIDE * i;
      b.m_linearVelocity.x = v[o];
      b.m_linearVelocity.y = v[o + 1];
      b.m_angularVelocity = v[o + 2];
      b.m_sweep.c.x = x[o];
      b.m_sweep.c.y = x[o + 1];
      if (b.m_sweep.a != bodies.angle[i]) {
        b.m_sweep.a = bodies.angle[i];
        b.synchronizeTransform();
      } else {
        b.placeOrigin();
      }
    }
    for (int i = 0; i < islands.contactCount; i++) {
      ContactGather.readImpulses(constraints, i, islands.contacts[i]);
    }
    for (int i = 0; i < islands.jointCount; i++) {
      islands.joints[i].scatter(joints, i);
    }
  }

  /** Moves the bounds of the bodies that were solved. */
  void synchronizeFixtures() {
    for (int i = 0; i < gathered; i++) {
      world.awake.bodies[i].synchronizeFixtures();
    }
  }

  // --- Sleep ---

  /**
   * An island sleeps when all its bodies have been slow for long enough and its positions are
   * within tolerance.
   */
  void updateSleep(StepConfig step) {
    if (minSleepTime.length < islands.count) {
      minSleepTime = new float[islands.count + (islands.count >> 1)];
    }
    for (int k = 0; k < islands.count; k++) {
      minSleepTime[k] = settled[k] ? Float.MAX_VALUE : 0f;
    }
    AwakeSet awake = world.awake;
    float linear2 = Settings.linearSleepTolerance * Settings.linearSleepTolerance;
    // Bodies that listeners have woken since lie behind these; they have no island and are awake
    // anyway.
    int n = gathered;
    for (int i = 0; i < n; i++) {
      Body b = awake.bodies[i];
      boolean calm =
          (b.m_flags & Body.e_autoSleepFlag) != 0
              && Math.abs(b.m_angularVelocity) <= Settings.angularSleepTolerance
              && b.m_linearVelocity.lengthSquared() <= linear2;
      b.m_sleepTime = calm ? b.m_sleepTime + step.dt : 0f;
      int k = islands.islandOf[i];
      minSleepTime[k] = Math.min(minSleepTime[k], b.m_sleepTime);
    }
    for (int i = n - 1; i >= 0; i--) {
      if (minSleepTime[islands.islandOf[i]] >= Settings.timeToSleep) {
        world.fallAsleep(awake.bodies[i]);
      }
    }
  }
}
