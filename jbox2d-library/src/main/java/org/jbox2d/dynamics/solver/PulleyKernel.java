package org.jbox2d.dynamics.solver;

/**
 * Two bodies hang from two fixed points by one rope over pulleys.
 *
 * <pre>
 *   C    = constant - lA - ratio lB,    l = |x + r - ground|,  u = (x + r - ground) / l
 *   Cdot = -uA . (vA + wA x rA) - ratio uB . (vB + wB x rB)
 *   K    = mA + iA (rA x uA)^2 + ratio^2 (mB + iB (rB x uB)^2)
 * </pre>
 *
 * C is kept at 0 both ways, as in JBox2D: the rope is always taut. A side that is shorter than the
 * linear slop has no direction and takes no part; if neither side does, K is 0 and the joint rests
 * (the original divided by it). The bend of the path is that of each side's length, as in {@link
 * Arms#stretch}.
 */
public final class PulleyKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 15;

  private static final int GROUND_AX = 8;
  private static final int GROUND_AY = 9;
  private static final int GROUND_BX = 10;
  private static final int GROUND_BY = 11;
  private static final int RATIO = 12;
  private static final int CONSTANT = 13;
  // In and out.
  private static final int IMPULSE = 14;
  // Own: direction from ground to body (0 for a side that takes no part) and 1 / length.
  private static final int UAX = 15;
  private static final int UAY = 16;
  private static final int UBX = 17;
  private static final int UBY = 18;
  private static final int INV_LENGTH_A = 19;
  private static final int INV_LENGTH_B = 20;
  private static final int MASS = 21;
  private static final int MOST_STRETCH = 22;

  PulleyKernel(int order) {
    super(order, IMPULSE, 1);
  }

  /** Fills in the fixed points, m. */
  public static void writeGround(float[] f, int o, float ax, float ay, float bx, float by) {
    f[o + GROUND_AX] = ax;
    f[o + GROUND_AY] = ay;
    f[o + GROUND_BX] = bx;
    f[o + GROUND_BY] = by;
  }

  /** Fills in ratio, rope length lA + ratio lB (m) and the impulse kept from the last step. */
  public static void writeRope(float[] f, int o, float ratio, float constant, float impulse) {
    f[o + RATIO] = ratio;
    f[o + CONSTANT] = constant;
    f[o + IMPULSE] = impulse;
  }

  /** Returns the rope's tension over the step on side A, N s. */
  public static float impulse(float[] f, int o) {
    return f[o + IMPULSE];
  }

  /** Returns the direction from ground B to body B along x. */
  public static float directionX(float[] f, int o) {
    return f[o + UBX];
  }

  /** Returns the direction from ground B to body B along y. */
  public static float directionY(float[] f, int o) {
    return f[o + UBY];
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float c = place(f, o, bodies, a, b, step.linearSlop);
      f[o + MOST_STRETCH] = Arms.mostStretch(stretch(f, o, bodies.vel, a, b, step), c, step);
      f[o + IMPULSE] *= keep;
      push(f, o, bodies, a, b, f[o + IMPULSE]);
    }
  }

  /** Computes directions and mass; returns C. */
  private static float place(float[] f, int o, SolverBodies bodies, int a, int b, float slop) {
    float[] x = bodies.pos;
    float[] m = bodies.mass;
    Arms.turn(f, o, x, a, b);
    float ax = x[a] + f[o + Arms.RAX] - f[o + GROUND_AX];
    float ay = x[a + 1] + f[o + Arms.RAY] - f[o + GROUND_AY];
    float bx = x[b] + f[o + Arms.RBX] - f[o + GROUND_BX];
    float by = x[b + 1] + f[o + Arms.RBY] - f[o + GROUND_BY];
    float lengthA = (float) Math.sqrt(ax * ax + ay * ay);
    float lengthB = (float) Math.sqrt(bx * bx + by * by);
    float invA = lengthA > slop ? 1f / lengthA : 0f;
    float invB = lengthB > slop ? 1f / lengthB : 0f;
    f[o + INV_LENGTH_A] = invA;
    f[o + INV_LENGTH_B] = invB;
    f[o + UAX] = invA * ax;
    f[o + UAY] = invA * ay;
    f[o + UBX] = invB * bx;
    f[o + UBY] = invB * by;
    float crossA = f[o + Arms.RAX] * f[o + UAY] - f[o + Arms.RAY] * f[o + UAX];
    float crossB = f[o + Arms.RBX] * f[o + UBY] - f[o + Arms.RBY] * f[o + UBX];
    float ratio = f[o + RATIO];
    float k = invA > 0f ? m[a] + m[a + 1] * crossA * crossA : 0f;
    k += invB > 0f ? ratio * ratio * (m[b] + m[b + 1] * crossB * crossB) : 0f;
    f[o + MASS] = k > 0f ? 1f / k : 0f;
    return f[o + CONSTANT] - lengthA - ratio * lengthB;
  }

  private static void push(float[] f, int o, SolverBodies bodies, int a, int b, float p) {
    float[] v = bodies.vel;
    float[] m = bodies.mass;
    float pax = -p * f[o + UAX];
    float pay = -p * f[o + UAY];
    float pbx = -p * f[o + RATIO] * f[o + UBX];
    float pby = -p * f[o + RATIO] * f[o + UBY];
    v[a] += m[a] * pax;
    v[a + 1] += m[a] * pay;
    v[a + 2] += m[a + 1] * (f[o + Arms.RAX] * pay - f[o + Arms.RAY] * pax);
    v[b] += m[b] * pbx;
    v[b + 1] += m[b] * pby;
    v[b + 2] += m[b + 1] * (f[o + Arms.RBX] * pby - f[o + Arms.RBY] * pbx);
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float lengthening =
          speed(f, o, v, a, b) + Arms.bounded(stretch(f, o, v, a, b, step), f[o + MOST_STRETCH]);
      float p = f[o + MASS] * lengthening;
      f[o + IMPULSE] += p;
      push(f, o, bodies, a, b, p);
    }
  }

  /** How fast both sides get longer by the velocities, that of B times the ratio, m/s. */
  private static float speed(float[] f, int o, float[] v, int a, int b) {
    float ax = v[a] - v[a + 2] * f[o + Arms.RAY];
    float ay = v[a + 1] + v[a + 2] * f[o + Arms.RAX];
    float bx = v[b] - v[b + 2] * f[o + Arms.RBY];
    float by = v[b + 1] + v[b + 2] * f[o + Arms.RBX];
    return f[o + UAX] * ax + f[o + UAY] * ay + f[o + RATIO] * (f[o + UBX] * bx + f[o + UBY] * by);
  }

  /** What both sides gain in a step above {@link #speed}; see {@link Arms#stretch}. */
  private static float stretch(float[] f, int o, float[] v, int a, int b, StepConfig step) {
    float ofA = stretch(f, o + Arms.RAX, o + UAX, f[o + INV_LENGTH_A], v, a, step);
    float ofB = stretch(f, o + Arms.RBX, o + UBX, f[o + INV_LENGTH_B], v, b, step);
    return ofA + f[o + RATIO] * ofB;
  }

  /** The same of one side: arm at {@code r}, direction at {@code u}. */
  private static float stretch(
      float[] f, int r, int u, float invLength, float[] v, int b, StepConfig step) {
    float rx = f[r];
    float ry = f[r + 1];
    float ux = f[u];
    float uy = f[u + 1];
    float vx = v[b] - v[b + 2] * ry;
    float vy = v[b + 1] + v[b + 2] * rx;
    float turn = v[b + 2] * step.dt;
    return Arms.bow(ux * vx + uy * vy, ux * vy - uy * vx, invLength, step.dt)
        - step.invDt * Arms.bendOne(turn, ux * rx + uy * ry, ux * ry - uy * rx);
  }

  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] m = bodies.mass;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      int a = SolverBodies.STRIDE * slotA;
      int b = SolverBodies.STRIDE * slotB;
      float c = place(f, o, bodies, a, b, step.linearSlop);
      float p = -f[o + MASS] * c * Arms.share(Math.abs(c), step.maxLinearCorrection);
      float pax = -p * f[o + UAX];
      float pay = -p * f[o + UAY];
      float pbx = -p * f[o + RATIO] * f[o + UBX];
      float pby = -p * f[o + RATIO] * f[o + UBY];
      float turnA = f[o + Arms.RAX] * pay - f[o + Arms.RAY] * pax;
      float turnB = f[o + Arms.RBX] * pby - f[o + Arms.RBY] * pbx;
      Arms.move(bodies, slotA, m[a] * pax, m[a] * pay, m[a + 1] * turnA);
      Arms.move(bodies, slotB, m[b] * pbx, m[b] * pby, m[b + 1] * turnB);
      done &= Math.abs(c) <= step.linearSlop;
    }
    return done;
  }
}
