package org.jbox2d.dynamics;

import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.Effort;
import org.jbox2d.dynamics.solver.SequentialImpulses;
import org.jbox2d.dynamics.solver.SoftStep;
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
  private final StepJoints joints = new StepJoints();
  private final SequentialImpulses sequential =
      new SequentialImpulses(bodies, constraints, joints.rows);
  private final SoftStep soft = new SoftStep(bodies, constraints, joints.rows);
  private final IslandEffort effort;
  private final SolvedContactReport report;

  /** Rises with each step; tells which bodies that do not move have a slot. */
  private long stamp;

  /** Number of awake bodies when they were gathered. */
  private int gathered;

  /**
   * Whether the bodies of joints have their centres of mass where the last step found them, if they
   * have its slots.
   */
  private boolean sameCentres;

  /** Moves on what lags behind, when it has been solved. */
  final LateIslands late;

  private final IslandSleep sleep = new IslandSleep();
  private boolean[] settled = new boolean[64];

  IslandSolver(World world) {
    this.world = world;
    effort = new IslandEffort(world.awake, islands, new Effort(bodies, constraints, joints.rows));
    late = new LateIslands(world.awake, islands, bodies, constraints);
    report = new SolvedContactReport(constraints, bodies, false);
  }

  void solve(StepConfig step, Solver solver, Profile profile) {
    profile.solveInit.startAccum();
    islands.build(world.awake, world.m_contactManager);
    boolean substeps = !solver.isSequentialImpulses();
    gatherBodies(step, substeps);
    gatherJoints();
    gatherContacts(step);
    if (islands.materials) {
      report.keepVelocities(substeps ? step.dt : 0f);
    }
    if (settled.length < islands.count) {
      settled = new boolean[islands.count + (islands.count >> 1)];
    }
    profile.solveInit.accumElapsed();
    if (substeps) {
      profile.solveVelocity.startAccum();
      solveSubsteps(step, solver);
      profile.cappedVelocities = soft.capped();
      profile.solveVelocity.accumElapsed();
    } else {
      profile.solveVelocity.startAccum();
      solveVelocities(step);
      profile.solveVelocity.accumElapsed();
      profile.solvePosition.startAccum();
      solvePositions(step, profile);
      profile.solvePosition.accumElapsed();
    }
    scatter(step);
    if (isHeard()) {
      if (substeps) {
        soft.sumImpulses(islands.contactCount);
      }
      ContactListener listener = world.m_contactManager.m_contactListener;
      report.send(islands.contacts, islands.contactCount, listener, islands.materials, step);
    }
    islands.release();
  }

  /** Whether anybody hears of what contacts did. */
  private boolean isHeard() {
    return world.m_contactManager.m_contactListener != null || islands.materials;
  }

  // --- Gather ---

  /**
   * Copies the awake bodies to their slots; applies gravity, forces and damping to the velocities
   * or, for substeps, writes them down.
   */
  private void gatherBodies(StepConfig step, boolean substeps) {
    stamp++;
    sameCentres = true;
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
      compareCentre(b, i);
      writeState(b, i);
      if (b.m_type != BodyType.DYNAMIC) {
        continue;
      }
      if (substeps) {
        writeForces(b, i, step);
      } else {
        integrateVelocity(b, i, step);
      }
    }
  }

  /**
   * Comes before the slot is written. Bits are compared, so that a zero of the other sign is told
   * from the one before.
   */
  private void compareCentre(Body b, int slot) {
    Vec2 centre = b.m_sweep.localCenter;
    int o = SolverBodies.STRIDE * slot;
    sameCentres &=
        Float.floatToRawIntBits(centre.x) == Float.floatToRawIntBits(bodies.mass[o + 2])
            && Float.floatToRawIntBits(centre.y) == Float.floatToRawIntBits(bodies.mass[o + 3]);
  }

  private void writeForces(Body b, int slot, StepConfig step) {
    int o = SolverBodies.STRIDE * slot;
    float[] a = bodies.accel;
    // As in integrateVelocity.
    float gravity = b.m_invMass > 0f ? b.m_gravityScale : 0f;
    a[o] = gravity * step.gravityX + b.m_invMass * b.m_force.x;
    a[o + 1] = gravity * step.gravityY + b.m_invMass * b.m_force.y;
    a[o + 2] = b.m_invI * b.m_torque;
    bodies.damping[2 * slot] = b.m_linearDamping;
    bodies.damping[2 * slot + 1] = b.m_angularDamping;
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
    bodies.accel[o] = 0f;
    bodies.accel[o + 1] = 0f;
    bodies.accel[o + 2] = 0f;
    bodies.damping[2 * slot] = 0f;
    bodies.damping[2 * slot + 1] = 0f;
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
      constraints.bodyA[i] = slotOf(c.m_bodyA);
      constraints.bodyB[i] = slotOf(c.m_bodyB);
      ContactGather.writeVelocityRecord(constraints, i, c, bodies, step);
      ContactGather.writePositionRecord(constraints, i, c, bodies, step);
    }
  }

  /**
   * Comes before contacts, which give slots to bodies that do not move, too: so those of joints
   * have the same slots from step to step, and rows can be kept.
   */
  private void gatherJoints() {
    for (int i = 0; i < islands.stillCount; i++) {
      Body b = islands.stillBodies[i];
      if (b.slotStamp != stamp) {
        bodies.ensureCapacity(bodies.count + 1);
        compareCentre(b, bodies.count);
        slotOf(b);
      }
    }
    joints.rows.masses = bodies.mass;
    joints.gather(islands, sameCentres);
  }

  // --- Solve ---

  private void solveVelocities(StepConfig step) {
    islands.groupBodies();
    int[] b = islands.bodyStart;
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    for (int k = 0; k < islands.count; k++) {
      if (c[k] < c[k + 1] || j[k] < j[k + 1]) {
        boolean checked = step.warmStarting && j[k] == j[k + 1];
        if (checked) {
          sequential.noteEnergy(islands.bodies, b[k], b[k + 1]);
        }
        sequential.prepare(c[k], c[k + 1], j[k], j[k + 1], step);
        BounceTiming.correct(constraints, islands.contacts, c[k], c[k + 1], 0f, step);
        sequential.solveVelocities(c[k], c[k + 1], j[k], j[k + 1], step);
        if (checked) {
          sequential.takeGain(islands.bodies, b[k], b[k + 1], c[k], c[k + 1], step);
        }
      }
    }
  }

  private void solvePositions(StepConfig step, Profile profile) {
    profile.cappedVelocities =
        bodies.integratePositions(gathered, step.dt, step.maxTranslation, step.maxRotation);
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    for (int k = 0; k < islands.count; k++) {
      settled[k] =
          (c[k] == c[k + 1] && j[k] == j[k + 1])
              || sequential.solvePositions(c[k], c[k + 1], j[k], j[k + 1], step);
    }
  }

  private void solveSubsteps(StepConfig step, Solver solver) {
    islands.groupBodies();
    soft.begin(isHeard());
    int[] b = islands.bodyStart;
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    for (int k = 0; k < islands.count; k++) {
      if (c[k] == c[k + 1] && j[k] == j[k + 1]) {
        soft.moveFree(islands.bodies[b[k]], step.dt);
        settled[k] = true;
      } else {
        int n = solver.isAdaptive() ? effort.substeps(k, step, solver) : solver.getLeastSubsteps();
        settled[k] =
            soft.solve(islands.bodies, b[k], b[k + 1], c[k], c[k + 1], j[k], j[k + 1], step, n);
        if (solver.isAdaptive() && !soft.jointsSettled()) {
          effort.noteStretched(k, n, solver);
        }
      }
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
    joints.scatter();
  }

  /** Moves the bounds of the bodies that were solved. */
  void synchronizeFixtures() {
    for (int i = 0; i < gathered; i++) {
      world.awake.bodies[i].synchronizeFixtures();
    }
  }

  // --- Sleep ---

  /** Puts islands to sleep that have come to rest. */
  void updateSleep(StepConfig step) {
    sleep.update(world, islands, settled, gathered, step.dt);
  }
}
