package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Substeps with soft contacts: instead of many iterations over a long step, one over each of many
 * short ones, whose errors fall with the square of their length (Macklin, Storey, Lu, Terdiman,
 * Chentanez, Jeschke, Mueller, "Small steps in physics simulation", SCA 2019). Contacts are found
 * once a step, their normals and arms are those of its start; joints are placed anew in each
 * substep.
 *
 * <p>Stages of an island: impacts ({@link BounceKernel}); then in each substep forces, kept
 * impulses, joints, contacts pushed ({@link SoftContactKernel}), bodies moved, joints and contacts
 * relaxed, energy that kept impulses brought in taken back ({@link SoftGain}), positions of the
 * joints corrected (mostly in the last alone). Impulses are kept from one substep to the next. Each
 * pass over joints ends with the chains that are solved at once ({@link HingeChains}).
 *
 * <p>Joints follow their curved paths within a substep (see {@link Arms}) rather than leave them
 * along the tangent and be drawn back by a spring: that loses no energy, needs no stiffness to be
 * chosen, and costs one position pass.
 */
public final class SoftStep {
  /**
   * Frequency of contacts, as a share of the rate of substeps. A spring is followed well up to
   * about an eighth of the rate; being strongly damped, a quarter will do. The more substeps, the
   * stiffer: a heavy body sinks into a light one by a way that falls with their number.
   */
  private static final float CONTACT_SHARE = 0.25f;

  /** Far above critical: overlap creeps away and does not spring. */
  private static final float CONTACT_DAMPING = 10f;

  /**
   * Largest share of overlap that is removed in a second, 1/s: what four substeps at 60 steps a
   * second and the damping above come to. Removed faster, a pile that was made with overlap jumps.
   */
  private static final float MOST_RATE = 20f;

  /** Largest speed at which overlap is removed, m/s. */
  private static final float MOST_PUSH = 3f;

  /** Bound of the passes over contacts and joints that hinder each other, in a substep. */
  private static final int MOST_PUSHES = 16;

  /** Depth, in slops, from which contacts alone are relaxed more than once. */
  private static final float DEEP_SLOPS = 8f;

  /**
   * Speed that neighbours pushed at {@link #MOST_PUSH} do not reach together, m/s: what takes away
   * more is a blow. Its bodies move so far in a step that the arms of a contact no longer meet, and
   * each pass would cost angular momentum.
   */
  private static final float BLOW_SPEED = 8f;

  /** Bound of such passes, and of their number times that of the island's contacts. */
  private static final int MOST_RELAXES = 6;

  private static final int MOST_ROWS = 256;

  /** What such a pass may take away without there being another, m/s. */
  private static final float HARMLESS_SPEED = 0.1f;

  /** Way by which a point may close in a substep before there is another pass, in slops. */
  private static final float HARMLESS_SLOPS = 0.5f;

  /** The same where there are contacts alone: a blow that would press bodies through others. */
  private static final float VIOLENT_SLOPS = 10f;

  /**
   * By which share of itself the speed that relaxing takes away must change from pass to pass, if
   * another one is to be of use.
   */
  private static final float STALLED = 1e-3f;

  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private final SoftJoints joints;
  private final SoftContactKernel contactKernel = new SoftContactKernel();
  private final SoftGain gain;
  private final SpinBooks spin;
  private final StepConfig sub = new StepConfig();

  private boolean jointsSettled;

  /** Whether the last push met contacts and joints that hinder each other. */
  private boolean blow;

  private int capped;

  /** Places where bodies were when the step began: x, y, angle, unused. */
  private float[] start = new float[0];

  /** Velocities in a substep before contacts acted: x, y, angular, unused. */
  private float[] free = new float[0];

  /**
   * Marks the bodies that have joints in an island by {@link #mark}, which is another each time.
   */
  private int[] marks = new int[0];

  private int mark;

  /** Whether somebody asks for the impulses of all substeps. */
  private boolean summed;

  public SoftStep(SolverBodies bodies, ContactConstraints contacts, JointRows joints) {
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = new SoftJoints(bodies, joints);
    gain = new SoftGain(bodies, contacts, contactKernel);
    spin = new SpinBooks(bodies);
  }

  /**
   * Begins a step: the bodies have been gathered.
   *
   * @param summed whether {@link #sumImpulses} will be called
   */
  public void begin(boolean summed) {
    this.summed = summed;
    capped = 0;
    int n = bodies.count;
    if (start.length < SolverBodies.STRIDE * n) {
      start = new float[bodies.pos.length];
      free = new float[bodies.pos.length];
    }
    for (int i = 0; i < n; i++) {
      int o = SolverBodies.STRIDE * i;
      start[o] = bodies.pos[o];
      start[o + 1] = bodies.pos[o + 1];
      start[o + 2] = bodies.angle[i];
      bodies.delta[o] = 0f;
      bodies.delta[o + 1] = 0f;
      bodies.delta[o + 2] = 0f;
    }
  }

  /**
   * Moves a body that nothing acts on but forces: its velocity by implicit damping, its place by
   * the mean of both velocities, which is exact for constant forces.
   */
  public void moveFree(int slot, float dt) {
    int o = SolverBodies.STRIDE * slot;
    float[] v = bodies.vel;
    float vx = v[o];
    float vy = v[o + 1];
    float w = v[o + 2];
    accelerate(slot, dt);
    bodies.delta[o] = 0.5f * dt * (vx + v[o]);
    bodies.delta[o + 1] = 0.5f * dt * (vy + v[o + 1]);
    bodies.delta[o + 2] = 0.5f * dt * (w + v[o + 2]);
    place(slot);
  }

  /**
   * Solves an island: bodies {@code slots[b0, b1)}, contacts {@code [c0, c1)}, joints {@code [j0,
   * j1)}.
   *
   * @return whether it ended within tolerance
   */
  public boolean solve(
      int[] slots, int b0, int b1, int c0, int c1, int j0, int j1, StepConfig step, int substeps) {
    if (j0 == j1) {
      gain.open(slots, b0, b1, step, substeps);
    }
    boolean alone =
        j0 == j1
            && spin.areAlone(slots, b0, b1, contacts, c0, c1)
            && spin.areDrivenAlike(slots, b0, b1);
    if (alone) {
      spin.open(slots, b0, b1);
    }
    boolean bounces = prepareContacts(c0, c1, step, substeps);
    joints.begin(j0, j1, slots, b0, b1, c0 < c1, sub);
    int cappedFirst = capped;
    int cappedBefore = capped;
    for (int n = 0; n < substeps; n++) {
      if (j0 < j1) {
        if (n > 0 && blow) {
          forgetImpulses(c0, c1, j0, j1);
        }
        prepareJoints(j0, j1, slots, b0, b1, c0 < c1);
        ContactVelocityKernel.warmStart(contacts, bodies, c0, c1);
      } else if (n == 0 || capped > cappedBefore) {
        cappedBefore = capped;
        accelerateFirst(slots, b0, b1);
        ContactVelocityKernel.warmStart(contacts, bodies, c0, c1);
      } else {
        accelerateOn(slots, b0, b1);
      }
      push(c0, c1, j0, j1);
      if (c0 < c1) {
        capSpins(slots, b0, b1, c0, c1, step);
      }
      move(slots, b0, b1, j0 < j1);
      relax(c0, c1, j0, j1);
      if (j0 == j1) {
        gain.take(slots, b0, b1, c0, c1, free, summed);
      }
      correctJoints(j0, j1, slots, b0, b1, n == substeps - 1);
      sub.next();
    }
    end(slots, b0, b1, c0, c1, j0, j1, substeps);
    if (alone) {
      spin.close(slots, b0, b1, bounces, capped > cappedFirst ? SpinBooks.SMALL : SpinBooks.LARGE);
    }
    return jointsSettled && contactKernel.settled();
  }

  /** How many velocities were capped in this step's substeps. */
  public int capped() {
    return capped;
  }

  /** Whether the joints of the last island ended within tolerance. */
  public boolean jointsSettled() {
    return jointsSettled;
  }

  // --- Contacts ---

  /** Returns whether one of the contacts bounces. */
  private boolean prepareContacts(int c0, int c1, StepConfig step, int substeps) {
    sub.divide(step, substeps);
    float frequency = CONTACT_SHARE * sub.invDt;
    contactKernel.set(sub.dt, frequency, CONTACT_DAMPING, MOST_RATE, MOST_PUSH, sub.linearSlop);
    boolean bounces = ContactPreparation.prepareSubsteps(contacts, bodies, c0, c1);
    if (bounces) {
      BounceKernel.solve(contacts, bodies, c0, c1, sub.velocityThreshold, step.dt);
    }
    float[] d = contacts.vel;
    float share = 1f / substeps;
    for (int i = c0; i < c1; i++) {
      scaleImpulses(d, V_STRIDE * i + POINT, share);
      scaleImpulses(d, V_STRIDE * i + POINT + POINT_STRIDE, share);
    }
    return bounces;
  }

  private static void scaleImpulses(float[] d, int o, float factor) {
    d[o + NORMAL_IMPULSE] *= factor;
    d[o + TANGENT_IMPULSE] *= factor;
  }

  /**
   * Solves joints and pushes contacts: once, or where contacts and joints hinder each other until
   * no point closes by more than is harmless in the substep. A blow on a body that a joint holds is
   * passed to and fro between the two; what is left of it would carry the body into what it hit.
   */
  private void push(int c0, int c1, int j0, int j1) {
    joints.solve(j0, j1, sub);
    contactKernel.push(contacts, bodies, c0, c1);
    float slops = j0 < j1 ? HARMLESS_SLOPS : VIOLENT_SLOPS;
    float harmless = slops * sub.linearSlop * sub.invDt;
    blow = contactKernel.closing > harmless;
    for (int n = 1; n < MOST_PUSHES && contactKernel.closing > harmless; n++) {
      joints.solve(j0, j1, sub);
      contactKernel.push(contacts, bodies, c0, c1);
    }
  }

  /**
   * Lets a substep start without the impulses that the last one gave bodies with joints, which were
   * those of a blow. The bodies have what it gave them; given once more, it would have to be taken
   * back by joints and contacts together, and one pass over them leaves much of it: dolls that fell
   * on the corner of a step were torn apart. Contacts of other bodies keep theirs: a heap in which
   * two hinges lay trembled without them.
   */
  private void forgetImpulses(int c0, int c1, int j0, int j1) {
    sub.warmStarting = false;
    markJointed(j0, j1);
    for (int i = c0; i < c1; i++) {
      if (marks[contacts.bodyA[i]] == mark || marks[contacts.bodyB[i]] == mark) {
        scaleImpulses(contacts.vel, V_STRIDE * i + POINT, 0f);
        scaleImpulses(contacts.vel, V_STRIDE * i + POINT + POINT_STRIDE, 0f);
      }
    }
  }

  private void markJointed(int j0, int j1) {
    if (marks.length < bodies.count) {
      marks = new int[bodies.angle.length];
    }
    joints.mark(j0, j1, marks, ++mark);
  }

  /**
   * Solves joints and relaxes contacts, as often as {@link #push} for the same reason, but no
   * longer than that changes anything; what is left stays for the next step. Contacts alone are
   * relaxed again, too, where they overlap deeply: one pass takes back but a part of the speeds at
   * which a heap of overlapping bodies is pushed apart, and what is left bursts it.
   */
  private void relax(int c0, int c1, int j0, int j1) {
    joints.solve(j0, j1, sub);
    contactKernel.relax(contacts, bodies, c0, c1, summed, false);
    int most = MOST_PUSHES;
    float harmless = HARMLESS_SLOPS * sub.linearSlop * sub.invStep;
    if (j0 == j1) {
      boolean pushed = contactKernel.least() < -DEEP_SLOPS * sub.linearSlop;
      most =
          pushed && contactKernel.changed < BLOW_SPEED
              ? Math.min(MOST_RELAXES, MOST_ROWS / (c1 - c0))
              : 1;
      harmless = HARMLESS_SPEED;
    }
    float before = 0f;
    for (int n = 1; n < most && contactKernel.changed > harmless; n++) {
      if (j0 < j1 && Math.abs(contactKernel.changed - before) <= STALLED * before) {
        break;
      }
      before = contactKernel.changed;
      joints.solve(j0, j1, sub);
      contactKernel.relax(contacts, bodies, c0, c1, summed, true);
    }
  }

  // --- Bodies ---

  private void accelerate(int[] slots, int b0, int b1) {
    for (int k = b0; k < b1; k++) {
      accelerate(slots[k], sub.dt);
    }
  }

  /** Notes the velocities that contacts find; see {@link #accelerateOn}. */
  private void accelerateFirst(int[] slots, int b0, int b1) {
    float[] v = bodies.vel;
    for (int k = b0; k < b1; k++) {
      accelerate(slots[k], sub.dt);
      int o = SolverBodies.STRIDE * slots[k];
      free[o] = v[o];
      free[o + 1] = v[o + 1];
      free[o + 2] = v[o + 2];
    }
  }

  /**
   * Begins a further substep of an island without joints with the impulses of the last one. Masses,
   * normals and arms are the same, so all of them together change the velocity of a body by what
   * they did then: by its velocity now less that which the contacts found. That is one pass over
   * the bodies instead of one over the contacts.
   */
  private void accelerateOn(int[] slots, int b0, int b1) {
    float[] v = bodies.vel;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      float x = v[o] - free[o];
      float y = v[o + 1] - free[o + 1];
      float w = v[o + 2] - free[o + 2];
      accelerate(slots[k], sub.dt);
      free[o] = v[o];
      free[o + 1] = v[o + 1];
      free[o + 2] = v[o + 2];
      v[o] += x;
      v[o + 1] += y;
      v[o + 2] += w;
    }
  }

  private void accelerate(int slot, float h) {
    float[] v = bodies.vel;
    float[] a = bodies.accel;
    int o = SolverBodies.STRIDE * slot;
    float linear = bodies.damping[2 * slot];
    float angular = bodies.damping[2 * slot + 1];
    v[o] += h * a[o];
    v[o + 1] += h * a[o + 1];
    v[o + 2] += h * a[o + 2];
    if (linear != 0f) {
      float share = 1f / (1f + h * linear);
      v[o] *= share;
      v[o + 1] *= share;
    }
    if (angular != 0f) {
      v[o + 2] /= 1f + h * angular;
    }
  }

  /**
   * Keeps bodies that touch others from turning further in a step than the arms of their contacts,
   * which are those of its start, have a meaning for. A wheel's arm stays where it is.
   */
  private void capSpins(int[] slots, int b0, int b1, int c0, int c1, StepConfig step) {
    float most = step.maxRotation * step.invDt;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k] + 2;
      float w = bodies.vel[o];
      if (Math.abs(w) > most && !isWheel(slots[k], c0, c1)) {
        bodies.vel[o] = w > 0f ? most : -most;
        capped++;
      }
    }
  }

  /** Whether a body touches others with discs about its centre alone. */
  private boolean isWheel(int slot, int c0, int c1) {
    for (int i = c0; i < c1; i++) {
      boolean its = contacts.bodyA[i] == slot || contacts.bodyB[i] == slot;
      if (its && !contacts.isRoundAt(i, slot)) {
        return false;
      }
    }
    return true;
  }

  private void move(int[] slots, int b0, int b1, boolean jointed) {
    float[] v = bodies.vel;
    float[] x = bodies.delta;
    float h = sub.dt;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      x[o] += h * v[o];
      x[o + 1] += h * v[o + 1];
      x[o + 2] += h * v[o + 2];
      if (jointed) {
        bodies.pos[o] = start[o] + x[o];
        bodies.pos[o + 1] = start[o + 1] + x[o + 1];
        bodies.swing(slots[k], h * v[o + 2]);
      }
    }
  }

  /** Places a body where its way has led; sine and cosine are taken when it is scattered. */
  private void place(int slot) {
    int o = SolverBodies.STRIDE * slot;
    bodies.pos[o] = start[o] + bodies.delta[o];
    bodies.pos[o + 1] = start[o + 1] + bodies.delta[o + 1];
    bodies.angle[slot] = start[o + 2] + bodies.delta[o + 2];
  }

  // --- Joints ---

  private void prepareJoints(int j0, int j1, int[] slots, int b0, int b1, boolean touching) {
    joints.keepVelocities(j0, j1);
    accelerate(slots, b0, b1);
    joints.prepare(j0, j1, sub);
    if (!touching) {
      joints.findFast(j0, j1, slots, b0, b1, sub);
    }
  }

  private void correctJoints(int j0, int j1, int[] slots, int b0, int b1, boolean last) {
    jointsSettled = joints.correct(j0, j1, last, sub);
    if (joints.areCorrected(j0, j1, last)) {
      for (int k = b0; k < b1; k++) {
        int o = SolverBodies.STRIDE * slots[k];
        bodies.delta[o] = bodies.pos[o] - start[o];
        bodies.delta[o + 1] = bodies.pos[o + 1] - start[o + 1];
        bodies.delta[o + 2] = bodies.angle[slots[k]] - start[o + 2];
      }
    }
  }

  // --- End ---

  private void end(int[] slots, int b0, int b1, int c0, int c1, int j0, int j1, int substeps) {
    if (j0 == j1) {
      for (int k = b0; k < b1; k++) {
        place(slots[k]);
      }
    }
    joints.scaleImpulses(j0, j1, substeps);
    float[] d = contacts.vel;
    for (int i = c0; i < c1; i++) {
      scaleImpulses(d, V_STRIDE * i + POINT, substeps);
      scaleImpulses(d, V_STRIDE * i + POINT + POINT_STRIDE, substeps);
      shareFriction(i);
    }
  }

  /**
   * Replaces the impulses of contacts {@code [0, n)}, which are those of the last substep as if all
   * were like it, by what was given in all of the step.
   */
  public void sumImpulses(int n) {
    for (int i = 0; i < n; i++) {
      int s = S_STRIDE * i;
      for (int j = 0; j < contacts.pointCount[i]; j++) {
        contacts.vel[V_STRIDE * i + POINT + POINT_STRIDE * j + NORMAL_IMPULSE] =
            contacts.sub[s + S_NORMAL_SUM + j];
      }
      contacts.vel[V_STRIDE * i + POINT + TANGENT_IMPULSE] = contacts.sub[s + S_TANGENT_SUM];
      shareFriction(i);
    }
  }

  /** Gives each point of a contact its share of the friction, as its normal impulse is. */
  private void shareFriction(int i) {
    if (contacts.pointCount[i] == 2) {
      float[] d = contacts.vel;
      int o1 = V_STRIDE * i + POINT;
      int o2 = o1 + POINT_STRIDE;
      float sum = d[o1 + NORMAL_IMPULSE] + d[o2 + NORMAL_IMPULSE];
      float both = d[o1 + TANGENT_IMPULSE];
      d[o2 + TANGENT_IMPULSE] = sum > 0f ? both * d[o2 + NORMAL_IMPULSE] / sum : 0f;
      d[o1 + TANGENT_IMPULSE] = both - d[o2 + TANGENT_IMPULSE];
    }
  }
}
