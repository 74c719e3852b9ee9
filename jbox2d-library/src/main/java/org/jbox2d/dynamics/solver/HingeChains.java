package org.jbox2d.dynamics.solver;

import java.util.Arrays;

/**
 * Solves rows of hinges at once where one pass over them would leave too much. What it leaves grows
 * with the ratio of the masses, see {@link Effort}: with four substeps a weight of a hundred links
 * stretched ten of them by a sixtieth, one of a thousand by a fifth, and a flail lost nearly half
 * of its energy in ten seconds. And it grows as chains turn, see {@link #FAST_TURN}.
 *
 * <p>A chain is a row of hinges without limits and motors, each next two of which share a body that
 * has no other hinges; at one end at least it ends in a body without other joints. Its hinges are
 * independent of each other, so that the matrix {@code A = J M^-1 J^T} of all its points is
 * symmetric, positive definite, and tridiagonal in blocks, see {@link BlockTridiagonal}:
 *
 * <pre>
 *   A(i, i)     = K of Arms
 *   A(i, i - 1) = +-(m 1 + I r(i)' r(i - 1)'^T),   r' = (-ry, rx)
 * </pre>
 *
 * with the inverse masses m, I and the arms r of the body that both share; minus where it is body A
 * of the one and B of the other (Baraff, "Linear-time dynamics using Lagrange multipliers",
 * SIGGRAPH 1996). Contacts and other joints of the bodies are iterated with the chain as one block.
 *
 * <p>Where both ends are held there may be more constraints than the bodies can move, as in a
 * bridge that is pulled straight: it is left to iterations, which do not drive contradictions up.
 */
final class HingeChains {
  /** Ratio of the masses in an island from which on all of its chains are solved at once. */
  private static final float UNEVEN = 3f;

  /**
   * Turn of a link in a substep from which on a chain that touches nothing is solved at once
   * whatever its masses, rad. Forces that turn with the links change by {@code r w^2 t} in a
   * substep, t = w h; kept impulses lag behind by that, a pass leaves a share of it, and its energy
   * is lost: {@code (r w t^2)^2} of {@code (r w)^2} in each substep, so {@code c w t^3} of the
   * energy in a second. Flails of 2 to 30 links of 0.4 m that turned at 2.5 to 10 rad/s lost it
   * with c of two to four times the square of their number, one of three links an eighth of it in
   * ten seconds at 10 rad/s. Below this bound that one loses less than a thousandth in a turn.
   *
   * <p>What touches something loses more than that anyway, and costs more: heaps of hinged links a
   * quarter, at the same errors.
   */
  private static final float FAST_TURN = 0.015f;

  /** How often a chain is solved: the bend of its path follows from the velocity. */
  private static final int PASSES = 2;

  /**
   * Turn of a body in a substep up to which the bend of a link's path is followed, rad, and turn of
   * two links against each other. Light links that crack like a whip turn further, and their bends
   * change faster than passes can follow: followed, it brought energy in. Above it they are led
   * along the tangent, which takes some.
   */
  private static final float MOST_TURN = 0.1f;

  /** See {@link #MOST_TURN}. */
  private static final float MOST_TWIST = 0.03f;

  /**
   * The same for either where masses are alike, rad. Chains of 2 to 10 links that were given spins
   * at random, up to 40 rad/s, gain hardly more than a hundredth of their energy in ten seconds
   * with four substeps; with half a radian four hundredths. With the bounds above a double pendulum
   * of rods of a metre that is let go level loses a fifth of that of its fall, with this one
   * nothing.
   */
  private static final float MOST_LIKE_TURN = 0.3f;

  private final SolverBodies bodies;
  private final JointRows rows;
  private final BlockTridiagonal system = new BlockTridiagonal();

  /** Chain k has the links {@code [chainStart[k], chainStart[k + 1])}. */
  private int[] chainStart = new int[8];

  private int chains;

  /** The row of each link, and the body that it shares with the link before it. */
  private int[] row = new int[16];

  private int[] shared = new int[16];
  private int links;

  /** Joints of each slot, plain hinges of each slot, and the first two of those. */
  private int[] joints = new int[0];

  private int[] degree = new int[0];

  private int[] hinges = new int[0];

  /** Rows that are in a chain, by {@link #mark}, which is another for each island. */
  private int[] marks = new int[0];

  private int mark;

  /** Whether the masses of the island differ by more than {@link #UNEVEN}. */
  private boolean uneven;

  HingeChains(SolverBodies bodies, JointRows rows) {
    this.bodies = bodies;
    this.rows = rows;
  }

  // --- Find ---

  /**
   * Looks for the chains of an island: bodies {@code slots[b0, b1)}, rows {@code [j0, j1)}.
   *
   * @param touching whether it has contacts
   */
  void find(int j0, int j1, int[] slots, int b0, int b1, boolean touching, StepConfig sub) {
    findUneven(j0, j1, slots, b0, b1);
    float least = FAST_TURN * sub.invDt;
    boolean even = j1 - j0 > 1 && !uneven && !touching;
    if (even && fastest(slots, b0, b1) > least) {
      addChains(j0, j1, slots, b0, b1, least);
    }
  }

  /** Looks for those alone that are solved at once for their masses. */
  void findUneven(int j0, int j1, int[] slots, int b0, int b1) {
    chains = 0;
    links = 0;
    uneven = j1 - j0 > 1 && isUneven(slots, b0, b1);
    if (uneven) {
      addChains(j0, j1, slots, b0, b1, 0f);
    }
  }

  private void addChains(int j0, int j1, int[] slots, int b0, int b1, float least) {
    countHinges(j0, j1, slots, b0, b1);
    for (int k = b0; k < b1; k++) {
      int slot = slots[k];
      if (joints[slot] == 1 && degree[slot] == 1 && marks[hinges[2 * slot]] != mark) {
        addChain(slot, least);
      }
    }
  }

  /** Returns the largest angular speed of bodies {@code slots[from, to)}, rad/s. */
  private float fastest(int[] slots, int from, int to) {
    float fastest = 0f;
    for (int k = from; k < to; k++) {
      fastest = Math.max(fastest, Math.abs(bodies.vel[SolverBodies.STRIDE * slots[k] + 2]));
    }
    return fastest;
  }

  private boolean isUneven(int[] slots, int b0, int b1) {
    float light = 0f;
    float heavy = Float.MAX_VALUE;
    for (int k = b0; k < b1; k++) {
      float inverse = bodies.mass[SolverBodies.STRIDE * slots[k]];
      light = Math.max(light, inverse);
      heavy = inverse > 0f ? Math.min(heavy, inverse) : heavy;
    }
    return light > UNEVEN * heavy;
  }

  private void countHinges(int j0, int j1, int[] slots, int b0, int b1) {
    if (degree.length < bodies.count) {
      joints = new int[bodies.angle.length];
      degree = new int[joints.length];
      hinges = new int[2 * degree.length];
    }
    if (marks.length < rows.count) {
      marks = new int[rows.floatAt.length];
    }
    mark++;
    for (int k = b0; k < b1; k++) {
      joints[slots[k]] = 0;
      degree[slots[k]] = 0;
    }
    for (int r = j0; r < j1; r++) {
      for (int i = rows.bodyAt[r]; i < rows.bodyAt[r] + rows.bodyCount[r]; i++) {
        joints[rows.bodies[i]]++;
      }
      if (rows.kernel[r] == JointKernels.REVOLUTE
          && RevoluteKernel.isPlain(rows.f, rows.floatAt[r])) {
        count(bodyA(r), r);
        count(bodyB(r), r);
      }
    }
  }

  private void count(int slot, int hinge) {
    if (!isHeld(slot)) {
      int n = degree[slot]++;
      if (n < 2) {
        hinges[2 * slot + n] = hinge;
      }
    }
  }

  private boolean isHeld(int slot) {
    return bodies.mass[SolverBodies.STRIDE * slot] == 0f;
  }

  /**
   * Adds the chain that ends freely at a body, if it has two links or more.
   *
   * @param least angular speed that one of its bodies must reach, rad/s
   */
  private void addChain(int end, float least) {
    int start = links;
    int slot = end;
    int hinge = hinges[2 * slot];
    while (marks[hinge] != mark) {
      addLink(hinge, slot);
      slot = bodyA(hinge) == slot ? bodyB(hinge) : bodyA(hinge);
      if (isHeld(slot) || degree[slot] != 2) {
        break;
      }
      int at = 2 * slot;
      hinge = hinges[at] == hinge ? hinges[at + 1] : hinges[at];
    }
    if (links - start < 2 || fastest(shared, start, links) < least) {
      dropFrom(start);
      return;
    }
    if (chains + 2 > chainStart.length) {
      chainStart = Arrays.copyOf(chainStart, 2 * chainStart.length);
    }
    chainStart[chains++] = start;
    chainStart[chains] = links;
  }

  private void dropFrom(int start) {
    for (int i = start; i < links; i++) {
      marks[row[i]] = mark - 1;
    }
    links = start;
  }

  private void addLink(int hinge, int slot) {
    if (links == row.length) {
      row = Arrays.copyOf(row, 2 * links);
      shared = Arrays.copyOf(shared, 2 * links);
    }
    system.ensureCapacity(links + 1);
    marks[hinge] = mark;
    row[links] = hinge;
    shared[links++] = slot;
  }

  /** Whether the island has chains. */
  boolean areThere() {
    return chains > 0;
  }

  /** How many hinges they have in all. */
  int linkCount() {
    return links;
  }

  /** Whether a row of the island is in one of its chains. */
  boolean has(int r) {
    return chains > 0 && marks[r] == mark;
  }

  /** How many chains there are. */
  int count() {
    return chains;
  }

  /** The first link of a chain, from its free end; of the number of chains where the last ends. */
  int start(int chain) {
    return chainStart[chain];
  }

  /** The row of a link. */
  int row(int i) {
    return row[i];
  }

  /** The body of a link that is nearer to the free end: the link before has it, too. */
  int nearBody(int i) {
    return shared[i];
  }

  /** The other one. */
  int farBody(int i) {
    return bodyA(row[i]) == shared[i] ? bodyB(row[i]) : bodyA(row[i]);
  }

  private int bodyA(int r) {
    return rows.bodies[rows.bodyAt[r]];
  }

  private int bodyB(int r) {
    return rows.bodies[rows.bodyAt[r] + 1];
  }

  // --- Factor ---

  /** Factors the chains' matrices; the arms of the rows have been turned. */
  void factor() {
    for (int k = 0; k < chains; k++) {
      factor(chainStart[k], chainStart[k + 1]);
    }
  }

  private void factor(int from, int to) {
    float[] f = rows.f;
    float[] m = bodies.mass;
    for (int i = from; i < to; i++) {
      int o = rows.floatAt[row[i]];
      int a = SolverBodies.STRIDE * bodyA(row[i]);
      int b = SolverBodies.STRIDE * bodyB(row[i]);
      double rax = f[o + Arms.RAX];
      double ray = f[o + Arms.RAY];
      double rbx = f[o + Arms.RBX];
      double rby = f[o + Arms.RBY];
      double mass = (double) m[a] + m[b];
      double ia = m[a + 1];
      double ib = m[b + 1];
      double k11 = mass + ia * ray * ray + ib * rby * rby;
      double k12 = -(ia * rax * ray + ib * rbx * rby);
      double k22 = mass + ia * rax * rax + ib * rbx * rbx;
      if (i == from) {
        system.factorFirst(i, k11, k12, k22);
      } else {
        factorNext(i, k11, k12, k22);
      }
    }
  }

  private void factorNext(int i, double k11, double k12, double k22) {
    float[] f = rows.f;
    int slot = shared[i];
    boolean isB = bodyB(row[i]) == slot;
    boolean wasB = bodyB(row[i - 1]) == slot;
    int p = rows.floatAt[row[i - 1]] + (wasB ? Arms.RBX : Arms.RAX);
    int q = rows.floatAt[row[i]] + (isB ? Arms.RBX : Arms.RAX);
    double sign = isB == wasB ? 1 : -1;
    double m = sign * bodies.mass[SolverBodies.STRIDE * slot];
    double turn = sign * bodies.mass[SolverBodies.STRIDE * slot + 1];
    double c11 = m + turn * f[q + 1] * f[p + 1];
    double c12 = -turn * f[q + 1] * f[p];
    double c21 = -turn * f[q] * f[p + 1];
    double c22 = m + turn * f[q] * f[p];
    system.factorNext(i, k11, k12, k22, c11, c12, c21, c22);
  }

  // --- Solve ---

  /** Brings the points of all chains to the same velocity. */
  void solve(StepConfig step) {
    for (int k = 0; k < chains; k++) {
      for (int n = 0; n < PASSES; n++) {
        solve(chainStart[k], chainStart[k + 1], step);
      }
    }
  }

  private void solve(int from, int to, StepConfig step) {
    for (int i = from; i < to; i++) {
      writeSpeed(i, step);
    }
    system.solve(from, to);
    for (int i = from; i < to; i++) {
      int o = rows.floatAt[row[i]];
      int a = SolverBodies.STRIDE * bodyA(row[i]);
      int b = SolverBodies.STRIDE * bodyB(row[i]);
      float x = (float) system.x(i);
      float y = (float) system.y(i);
      RevoluteKernel.addImpulse(rows.f, o, x, y);
      Arms.push(rows.f, o, bodies.vel, bodies.mass, a, b, x, y, 0f);
    }
  }

  /** Writes the speed at which a link's points come together, with the bend of their path. */
  private void writeSpeed(int i, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    int o = rows.floatAt[row[i]];
    int a = SolverBodies.STRIDE * bodyA(row[i]);
    int b = SolverBodies.STRIDE * bodyB(row[i]);
    float x = Arms.speedX(f, o, v, a, b);
    float y = Arms.speedY(f, o, v, a, b);
    float most = RevoluteKernel.mostBend(f, o);
    if (most > 0f && isFollowed(a, b, step.dt)) {
      x += Arms.bounded(Arms.bendX(f, o, v, a, b, step.dt, step.invDt), most);
      y += Arms.bounded(Arms.bendY(f, o, v, a, b, step.dt, step.invDt), most);
    }
    system.write(i, -x, -y);
  }

  private boolean isFollowed(int a, int b, float h) {
    float turnA = bodies.vel[a + 2] * h;
    float turnB = bodies.vel[b + 2] * h;
    boolean held = bodies.mass[a] == 0f || bodies.mass[b] == 0f;
    float bend = held ? 0f : Math.abs(turnB - turnA);
    float mostBend = uneven ? MOST_TWIST : MOST_LIKE_TURN;
    float mostTurn = uneven ? MOST_TURN : MOST_LIKE_TURN;
    return bend <= mostBend && Math.max(Math.abs(turnA), Math.abs(turnB)) <= mostTurn;
  }

  // --- Correct ---

  /** One Newton step of all chains towards coincident points; turns the rows' arms. */
  void correct(StepConfig step) {
    for (int k = 0; k < chains; k++) {
      correct(chainStart[k], chainStart[k + 1], step);
    }
  }

  private void correct(int from, int to, StepConfig step) {
    float[] f = rows.f;
    float[] x = bodies.pos;
    for (int i = from; i < to; i++) {
      int o = rows.floatAt[row[i]];
      int a = SolverBodies.STRIDE * bodyA(row[i]);
      int b = SolverBodies.STRIDE * bodyB(row[i]);
      Arms.turn(f, o, x, a, b);
      system.write(i, -Arms.gapX(f, o, x, a, b), -Arms.gapY(f, o, x, a, b));
    }
    factor(from, to);
    system.solve(from, to);
    // Where bodies would turn far, they would overshoot: that is left to iterations.
    if (largestTurn(from, to) > step.maxAngularCorrection) {
      return;
    }
    for (int i = from; i < to; i++) {
      int o = rows.floatAt[row[i]];
      float px = (float) system.x(i);
      float py = (float) system.y(i);
      Arms.shift(f, o, bodies, bodyA(row[i]), bodyB(row[i]), px, py, 0f);
    }
  }

  /** Returns how far the solution turns a body, rad. */
  private double largestTurn(int from, int to) {
    double most = 0;
    for (int i = from; i < to; i++) {
      // The body that a link shares with the one before, at the free end that which hangs there.
      double turn = momentOn(shared[i], i) + (i > from ? momentOn(shared[i], i - 1) : 0);
      most = Math.max(most, Math.abs(turn * bodies.mass[SolverBodies.STRIDE * shared[i] + 1]));
    }
    int last = farBody(to - 1);
    double turn = momentOn(last, to - 1) * bodies.mass[SolverBodies.STRIDE * last + 1];
    return Math.max(most, Math.abs(turn));
  }

  /** Returns the moment of a link's impulse on one of its bodies. */
  private double momentOn(int slot, int i) {
    boolean isB = bodyB(row[i]) == slot;
    int r = rows.floatAt[row[i]] + (isB ? Arms.RBX : Arms.RAX);
    double moment = rows.f[r] * system.y(i) - rows.f[r + 1] * system.x(i);
    return isB ? moment : -moment;
  }
}
