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
  /**
   * For how many steps an island keeps its substeps when it needs fewer, and by what share they
   * then fall. Velocities belong to the middle of a substep, so each change of its length costs
   * some energy, and one with the phase of a swing would go on taking or giving it; a pile settles
   * by some tenths of a millimetre.
   */
  private static final int SWING_HELD = 240;

  private static final int PILE_HELD = 30;

  private static final float EFFORT_FALL = 0.7f;

  /**
   * Up to how many substeps an island gets one more after each step that its joints ended out of
   * tolerance.
   */
  private static final int RESIDUAL_SUBSTEPS = 4;

  /**
   * For how many links in a row that bound is one higher. What a step leaves in a hanging row is
   * {@code 1.8 N g h^2 / n^2} at its upper end, N the links and n the substeps: measured on chains
   * of 30 to 300, with 4 to 32 substeps. A swing bears three times its weight and cracks like a
   * whip; 200 links stretched to twice their length.
   */
  private static final int LINKS_A_SUBSTEP = 32;

  /** Contacts and joints of an island times its substeps, above the usual number of those. */
  private static final int MOST_EFFORT = 1024;

  /** The same for links in a row, which need the more substeps the more they are. */
  private static final int MOST_ROW_EFFORT = 4096;

  private final World world;
  private final Islands islands = new Islands();
  private final SolverBodies bodies = new SolverBodies();
  private final ContactConstraints constraints = new ContactConstraints();
  private final StepJoints joints = new StepJoints();
  private final SequentialImpulses sequential =
      new SequentialImpulses(bodies, constraints, joints.rows);
  private final SoftStep soft = new SoftStep(bodies, constraints, joints.rows);
  private final Effort effort = new Effort(bodies, constraints, joints.rows);
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

  private final IslandSleep sleep = new IslandSleep();
  private boolean[] settled = new boolean[64];

  IslandSolver(World world) {
    this.world = world;
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
        int n = solver.isAdaptive() ? substepsOf(k, step, solver) : solver.getLeastSubsteps();
        settled[k] =
            soft.solve(islands.bodies, b[k], b[k + 1], c[k], c[k + 1], j[k], j[k + 1], step, n);
        if (solver.isAdaptive() && !soft.jointsSettled() && n < residualSubsteps(k)) {
          keepEffort(k, Math.min(n + 1, mostSubsteps(k, solver)), 0);
        }
      }
    }
  }

  /**
   * How many substeps an island gets: as many as it needs now, and for a while after as many as it
   * has needed.
   *
   * <p>What contacts ask for at most doubles from step to step. They go by the impulses of the last
   * step: a load is still there in the next, a blow is over. And what touches something is held but
   * shortly even if it has joints: it loses more energy than a change of substeps takes, and its
   * limbs turn fast for no longer than a blow lasts.
   */
  private int substepsOf(int island, StepConfig step, Solver solver) {
    int b0 = islands.bodyStart[island];
    int b1 = islands.bodyStart[island + 1];
    int held = 0;
    int age = Integer.MAX_VALUE;
    for (int i = b0; i < b1; i++) {
      Body b = world.awake.bodies[islands.bodies[i]];
      held = Math.max(held, b.effort);
      age = Math.min(age, b.effortAge);
    }
    int least = solver.getLeastSubsteps();
    int most = mostSubsteps(island, solver);
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    boolean jointed = j[island] < j[island + 1];
    float contacts = effort.ofContacts(c[island], c[island + 1], b1 - b0, step);
    contacts = Math.min(contacts, 2 * Math.max(held, least));
    float swing = jointed ? effort.ofJoints(j[island], j[island + 1], most, step) : 0f;
    float now = Math.min(most, Math.max(least, Math.max(contacts, swing)));
    int lasting = jointed ? SWING_HELD : PILE_HELD;
    int young = c[island] < c[island + 1] ? lasting - PILE_HELD : 0;
    if (now > held || held > most) {
      held = (int) Math.ceil(now);
      age = young;
    } else if (now >= EFFORT_FALL * held) {
      age = young;
    } else if (++age > lasting) {
      held = (int) Math.ceil(Math.max(now, Math.min(EFFORT_FALL * held, held - 1f)));
      age = lasting - PILE_HELD;
    }
    keepEffort(island, held, age);
    return held;
  }

  /**
   * The bound of the substeps of an island: that of the solver, and for a large one what keeps its
   * cost in bounds. In a pile of thousands it is no matter if some small body gives way to its
   * load.
   */
  private int mostSubsteps(int island, Solver solver) {
    int rows =
        islands.contactStart[island + 1]
            - islands.contactStart[island]
            + islands.jointStart[island + 1]
            - islands.jointStart[island];
    int effort = isRow(island) ? MOST_ROW_EFFORT : MOST_EFFORT;
    int affordable = Math.max(Solver.DEFAULT_SUBSTEPS, effort / rows);
    return Math.max(solver.getLeastSubsteps(), Math.min(solver.getMostSubsteps(), affordable));
  }

  /** Up to how many substeps an island gets more where its joints are out of tolerance. */
  private int residualSubsteps(int island) {
    int links = islands.jointStart[island + 1] - islands.jointStart[island];
    return RESIDUAL_SUBSTEPS + (isRow(island) ? links / LINKS_A_SUBSTEP : 0);
  }

  /**
   * Whether an island touches nothing and has hardly more joints than bodies: a chain, a bridge, a
   * tree. In a net the ways are short; and against contacts joints may be out of tolerance however
   * many substeps there are.
   */
  private boolean isRow(int island) {
    int[] c = islands.contactStart;
    int[] j = islands.jointStart;
    int[] b = islands.bodyStart;
    return c[island] == c[island + 1] && j[island + 1] - j[island] <= b[island + 1] - b[island] + 1;
  }

  /** Notes how many substeps an island has, and for how long it has needed less. */
  private void keepEffort(int island, int substeps, int age) {
    for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
      Body b = world.awake.bodies[islands.bodies[i]];
      b.effort = substeps;
      b.effortAge = age;
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
