package org.jbox2d.dynamics.solver;

/**
 * Lets body B slide along an axis of body A without turning, within limits and driven by a motor if
 * wanted.
 *
 * <p>a is the axis, n = (-ay, ax) is normal to it, both turning with A; {@code d = xB + rB - xA -
 * rA}:
 *
 * <pre>
 *   across: C1 = n . d,  C1dot = n . (vB - vA) + s2 wB - s1 wA,   s1 = (d + rA) x n,  s2 = rB x n
 *   angle:  C2 = aB - aA - reference,                             C2dot = wB - wA
 *   along:  s  = a . d,  sdot  = a . (vB - vA) + a2 wB - a1 wA,   a1 = (d + rA) x a,  a2 = rB x a
 *
 *   K11 = mA + mB + iA s1^2 + iB s2^2,   K12 = iA s1 + iB s2,   K22 = iA + iB
 *   K11 - K12^2 / K22 = mA + mB + iA iB / (iA + iB) (s1 - s2)^2
 * </pre>
 *
 * Across and angle are solved at once by elimination of the angle; its Schur complement is written
 * as a sum of terms that are not negative. Motor {@code sdot = speed} with its impulse within
 * {@code maxForce h}; limits {@code s >= lower}, {@code s <= upper}, each with an accumulated
 * impulse that is not negative and may close what room is left within the step (see {@link
 * RevoluteKernel}).
 *
 * <p>The bend (see {@link Arms#bendAlong}) is that of d seen in A's turning frame: across the axis
 * {@code n . q - h wA a . ddot - h/2 wA^2 n . d} to second order, q the turning of the arms, the
 * Coriolis and centrifugal terms; along it likewise with {@code + h wA n . ddot}. Either is
 * bounded, see {@link Arms#mostBend}. Source of the model: Catto, "Modeling and solving
 * constraints", GDC 2009.
 */
public final class PrismaticKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 28;

  private static final int AXIS_X = 8;
  private static final int AXIS_Y = 9;
  private static final int REFERENCE = 10;
  private static final int LIMITED = 11;
  private static final int LOWER = 12;
  private static final int UPPER = 13;
  private static final int DRIVEN = 14;
  private static final int SPEED = 15;
  private static final int MAX_FORCE = 16;
  // In and out.
  private static final int ACROSS_IMPULSE = 17;
  private static final int ANGLE_IMPULSE = 18;
  private static final int MOTOR_IMPULSE = 19;
  private static final int LOWER_IMPULSE = 20;
  private static final int UPPER_IMPULSE = 21;
  // Own; the first six as in Rail.
  private static final int AX = 22;
  private static final int AY = 23;
  private static final int S1 = 24;
  private static final int S2 = 25;
  private static final int A1 = 26;
  private static final int A2 = 27;
  private static final int ACROSS_MASS = 28;
  private static final int COUPLING = 29;
  private static final int ANGLE_MASS = 30;
  private static final int ALONG_MASS = 31;
  private static final int LOWER_ROOM = 32;
  private static final int UPPER_ROOM = 33;
  private static final int MOST_BEND_ACROSS = 34;
  private static final int MOST_BEND_ALONG = 35;

  /** Turn of B against A in a step from which no bend is followed, rad. */
  private static final float MOST_TWIST = 0.02f;

  /**
   * Turn in a step from which on nothing is kept of the last one's impulses where bodies are far
   * beyond a limit, rad: arms are long there and have turned by as much, so that along them the old
   * impulses would be blows. Small discs that were thrown with a slider far outside of both gained
   * eight powers of ten.
   */
  private static final float WILD_TURN = 0.1f;

  PrismaticKernel(int order) {
    super(order, ACROSS_IMPULSE, 5);
  }

  /** Fills in the axis, a unit vector in A's frame, and the reference angle, rad. */
  public static void writeAxis(float[] f, int o, float x, float y, float reference) {
    f[o + AXIS_X] = x;
    f[o + AXIS_Y] = y;
    f[o + REFERENCE] = reference;
  }

  /** Fills in the limits, m. */
  public static void writeLimit(float[] f, int o, boolean limited, float lower, float upper) {
    f[o + LIMITED] = limited ? 1f : 0f;
    f[o + LOWER] = lower;
    f[o + UPPER] = upper;
  }

  /** Fills in the motor: m/s, N. */
  public static void writeMotor(float[] f, int o, boolean driven, float speed, float maxForce) {
    f[o + DRIVEN] = driven ? 1f : 0f;
    f[o + SPEED] = speed;
    f[o + MAX_FORCE] = maxForce;
  }

  /** Fills in the impulses kept from the last step. */
  public static void writeImpulses(
      float[] f, int o, float across, float angle, float motor, float lower, float upper) {
    f[o + ACROSS_IMPULSE] = across;
    f[o + ANGLE_IMPULSE] = angle;
    f[o + MOTOR_IMPULSE] = motor;
    f[o + LOWER_IMPULSE] = lower;
    f[o + UPPER_IMPULSE] = upper;
  }

  /** Returns the impulse on body B across the axis, along (-ay, ax), N s. */
  public static float acrossImpulse(float[] f, int o) {
    return f[o + ACROSS_IMPULSE];
  }

  /** Returns the angular impulse on body B, N m s. */
  public static float angleImpulse(float[] f, int o) {
    return f[o + ANGLE_IMPULSE];
  }

  /** Returns the motor's impulse on body B along the axis, N s. */
  public static float motorImpulse(float[] f, int o) {
    return f[o + MOTOR_IMPULSE];
  }

  /** Returns the lower limit's impulse, N s, not negative. */
  public static float lowerImpulse(float[] f, int o) {
    return f[o + LOWER_IMPULSE];
  }

  /** Returns the upper limit's impulse, N s, not negative; it acts backwards. */
  public static float upperImpulse(float[] f, int o) {
    return f[o + UPPER_IMPULSE];
  }

  /** Returns the axis along x in the last step. */
  public static float axisX(float[] f, int o) {
    return f[o + AX];
  }

  /** Returns the axis along y in the last step. */
  public static float axisY(float[] f, int o) {
    return f[o + AY];
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float kept = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float translation = place(f, o, bodies, a, b);
      f[o + LOWER_ROOM] = Math.max(0f, translation - f[o + LOWER]) * step.invDt;
      f[o + UPPER_ROOM] = Math.max(0f, f[o + UPPER] - translation) * step.invDt;
      boundBends(f, o, bodies.vel, a, b, step);

      boolean wild = isFarBeyond(f, o, step) && Math.abs(bodies.vel[a + 2]) * step.dt > WILD_TURN;
      float keep = wild ? 0f : kept;
      f[o + ACROSS_IMPULSE] *= keep;
      f[o + ANGLE_IMPULSE] *= keep;
      f[o + MOTOR_IMPULSE] *= keep * f[o + DRIVEN];
      f[o + LOWER_IMPULSE] *= keep * f[o + LIMITED];
      f[o + UPPER_IMPULSE] *= keep * f[o + LIMITED];
      float along = f[o + MOTOR_IMPULSE] + f[o + LOWER_IMPULSE] - f[o + UPPER_IMPULSE];
      push(f, o, bodies, a, b, along, f[o + ACROSS_IMPULSE], f[o + ANGLE_IMPULSE]);
    }
  }

  /**
   * Writes what the bends may come to. Their size together counts: turned by a step, one may grow
   * from nothing. Bodies that a blow has set spinning against each other, or that are far beyond a
   * limit, have no path to follow.
   */
  private static void boundBends(float[] f, int o, float[] v, int a, int b, StepConfig step) {
    f[o + MOST_BEND_ACROSS] = 0f;
    f[o + MOST_BEND_ALONG] = 0f;
    float twist = Math.abs(v[b + 2] - v[a + 2]) * step.dt;
    if (twist <= MOST_TWIST && !isFarBeyond(f, o, step)) {
      float across = Rail.bendAcross(f, o, o + AX, v, a, b, step);
      float along = f[o + LIMITED] > 0f ? Rail.bendAlong(f, o, o + AX, v, a, b, step) : 0f;
      float most = Arms.mostBend((float) Math.sqrt(across * across + along * along), step);
      f[o + MOST_BEND_ACROSS] = Arms.isBent(Rail.gapAcross(f, o, o + AX), step) ? most : 0f;
      f[o + MOST_BEND_ALONG] = most;
    }
  }

  private static boolean isFarBeyond(float[] f, int o, StepConfig step) {
    float translation = Rail.gapAlong(f, o, o + AX);
    float beyond = Math.max(f[o + LOWER] - translation, translation - f[o + UPPER]);
    return f[o + LIMITED] > 0f && beyond > 0f && !Arms.isBent(beyond, step);
  }

  /** Computes axis, arms and masses at the bodies' positions; returns the translation. */
  private static float place(float[] f, int o, SolverBodies bodies, int a, int b) {
    float[] x = bodies.pos;
    float[] m = bodies.mass;
    Arms.turn(f, o, x, a, b);
    float ax = x[a + 3] * f[o + AXIS_X] - x[a + 2] * f[o + AXIS_Y];
    float ay = x[a + 2] * f[o + AXIS_X] + x[a + 3] * f[o + AXIS_Y];
    float dx = Arms.gapX(f, o, x, a, b);
    float dy = Arms.gapY(f, o, x, a, b);
    float armX = dx + f[o + Arms.RAX];
    float armY = dy + f[o + Arms.RAY];
    float s1 = armX * ax + armY * ay;
    float s2 = f[o + Arms.RBX] * ax + f[o + Arms.RBY] * ay;
    float a1 = armX * ay - armY * ax;
    float a2 = f[o + Arms.RBX] * ay - f[o + Arms.RBY] * ax;
    f[o + AX] = ax;
    f[o + AY] = ay;
    f[o + S1] = s1;
    f[o + S2] = s2;
    f[o + A1] = a1;
    f[o + A2] = a2;

    float mass = m[a] + m[b];
    float ia = m[a + 1];
    float ib = m[b + 1];
    float angleMass = ia + ib > 0f ? 1f / (ia + ib) : 0f;
    float across = mass + ia * ib * angleMass * (s1 - s2) * (s1 - s2);
    float along = mass + ia * a1 * a1 + ib * a2 * a2;
    f[o + ANGLE_MASS] = angleMass;
    f[o + COUPLING] = (ia * s1 + ib * s2) * angleMass;
    f[o + ACROSS_MASS] = across > 0f ? 1f / across : 0f;
    f[o + ALONG_MASS] = along > 0f ? 1f / along : 0f;
    return ax * dx + ay * dy;
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
      if (f[o + DRIVEN] > 0f) {
        drive(f, o, bodies, a, b, step.dt);
      }
      if (f[o + LIMITED] > 0f) {
        limit(f, o, bodies, a, b, step);
      }
      float ax = f[o + AX];
      float ay = f[o + AY];
      float c1 =
          ax * (v[b + 1] - v[a + 1])
              - ay * (v[b] - v[a])
              + f[o + S2] * v[b + 2]
              - f[o + S1] * v[a + 2]
              + Arms.bounded(Rail.bendAcross(f, o, o + AX, v, a, b, step), f[o + MOST_BEND_ACROSS]);
      float c2 = v[b + 2] - v[a + 2];
      float p1 = -f[o + ACROSS_MASS] * (c1 - f[o + COUPLING] * c2);
      float p2 = -f[o + ANGLE_MASS] * c2 - f[o + COUPLING] * p1;
      f[o + ACROSS_IMPULSE] += p1;
      f[o + ANGLE_IMPULSE] += p2;
      push(f, o, bodies, a, b, 0f, p1, p2);
    }
  }

  private static void drive(float[] f, int o, SolverBodies bodies, int a, int b, float h) {
    float most = f[o + MAX_FORCE] * h;
    float old = f[o + MOTOR_IMPULSE];
    float sum = old - f[o + ALONG_MASS] * (along(f, o, bodies.vel, a, b) - f[o + SPEED]);
    f[o + MOTOR_IMPULSE] = Math.max(-most, Math.min(most, sum));
    push(f, o, bodies, a, b, f[o + MOTOR_IMPULSE] - old, 0f, 0f);
  }

  private static void limit(float[] f, int o, SolverBodies bodies, int a, int b, StepConfig step) {
    float mass = f[o + ALONG_MASS];
    float speed =
        along(f, o, bodies.vel, a, b)
            + Arms.bounded(
                Rail.bendAlong(f, o, o + AX, bodies.vel, a, b, step), f[o + MOST_BEND_ALONG]);
    float old = f[o + LOWER_IMPULSE];
    f[o + LOWER_IMPULSE] = Math.max(0f, old - mass * (speed + f[o + LOWER_ROOM]));
    float p = f[o + LOWER_IMPULSE] - old;
    // What the lower limit has given is seen by the upper one.
    float gained = mass > 0f ? p / mass : 0f;
    old = f[o + UPPER_IMPULSE];
    f[o + UPPER_IMPULSE] = Math.max(0f, old - mass * (f[o + UPPER_ROOM] - speed - gained));
    p -= f[o + UPPER_IMPULSE] - old;
    push(f, o, bodies, a, b, p, 0f, 0f);
  }

  private static float along(float[] f, int o, float[] v, int a, int b) {
    return f[o + AX] * (v[b] - v[a])
        + f[o + AY] * (v[b + 1] - v[a + 1])
        + f[o + A2] * v[b + 2]
        - f[o + A1] * v[a + 2];
  }

  private static void push(
      float[] f, int o, SolverBodies bodies, int a, int b, float along, float across, float turn) {
    float[] v = bodies.vel;
    float[] m = bodies.mass;
    float px = along * f[o + AX] - across * f[o + AY];
    float py = along * f[o + AY] + across * f[o + AX];
    v[a] -= m[a] * px;
    v[a + 1] -= m[a] * py;
    v[a + 2] -= m[a + 1] * (along * f[o + A1] + across * f[o + S1] + turn);
    v[b] += m[b] * px;
    v[b + 1] += m[b] * py;
    v[b + 2] += m[b + 1] * (along * f[o + A2] + across * f[o + S2] + turn);
  }

  /**
   * A limit that is violated is solved together with across and angle: one after the other they
   * undo each other's turning and get nowhere when bodies were put far apart. With the angle
   * eliminated, what is left for (across, along) is {@code (mA + mB) 1 + iA iB / (iA + iB) e e^T, e
   * = (s1 - s2, a1 - a2)}.
   */
  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      int a = SolverBodies.STRIDE * slotA;
      int b = SolverBodies.STRIDE * slotB;
      float translation = place(f, o, bodies, a, b);
      float across =
          f[o + AX] * Arms.gapY(f, o, bodies.pos, a, b)
              - f[o + AY] * Arms.gapX(f, o, bodies.pos, a, b);
      float angle = bodies.angle[slotB] - bodies.angle[slotA] - f[o + REFERENCE];
      float along = 0f;
      if (f[o + LIMITED] > 0f) {
        along = translation - Math.max(f[o + LOWER], Math.min(f[o + UPPER], translation));
      }
      done &= Math.max(Math.abs(across), Math.abs(along)) <= step.linearSlop;
      done &= Math.abs(angle) <= step.angularSlop;
      across *= Arms.share(Math.abs(across), step.maxLinearCorrection);
      along *= Arms.share(Math.abs(along), step.maxLinearCorrection);
      angle *= Arms.share(Math.abs(angle), step.maxAngularCorrection);
      if (along == 0f) {
        float p1 = -f[o + ACROSS_MASS] * (across - f[o + COUPLING] * angle);
        float p2 = -f[o + ANGLE_MASS] * angle - f[o + COUPLING] * p1;
        shift(f, o, bodies, slotA, slotB, 0f, p1, p2);
      } else {
        mend(f, o, bodies, slotA, slotB, along, across, angle);
      }
    }
    return done;
  }

  private static void mend(
      float[] f,
      int o,
      SolverBodies bodies,
      int slotA,
      int slotB,
      float along,
      float across,
      float angle) {
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    float mass = bodies.mass[a] + bodies.mass[b];
    float ia = bodies.mass[a + 1];
    float ib = bodies.mass[b + 1];
    float both = ia * ib * f[o + ANGLE_MASS];
    float es = f[o + S1] - f[o + S2];
    float ea = f[o + A1] - f[o + A2];
    float det = mass * (mass + both * (es * es + ea * ea));
    float inv = det > 0f ? 1f / det : 0f;
    float alongCoupling = (ia * f[o + A1] + ib * f[o + A2]) * f[o + ANGLE_MASS];
    float c1 = across - f[o + COUPLING] * angle;
    float c2 = along - alongCoupling * angle;
    float p1 = -inv * ((mass + both * ea * ea) * c1 - both * es * ea * c2);
    float p2 = -inv * ((mass + both * es * es) * c2 - both * es * ea * c1);
    float turn = -f[o + ANGLE_MASS] * angle - f[o + COUPLING] * p1 - alongCoupling * p2;
    shift(f, o, bodies, slotA, slotB, p2, p1, turn);
  }

  private static void shift(
      float[] f,
      int o,
      SolverBodies bodies,
      int slotA,
      int slotB,
      float along,
      float across,
      float turn) {
    float[] m = bodies.mass;
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    float px = along * f[o + AX] - across * f[o + AY];
    float py = along * f[o + AY] + across * f[o + AX];
    float turnA = along * f[o + A1] + across * f[o + S1] + turn;
    float turnB = along * f[o + A2] + across * f[o + S2] + turn;
    Arms.move(bodies, slotA, -m[a] * px, -m[a] * py, -m[a + 1] * turnA);
    Arms.move(bodies, slotB, m[b] * px, m[b] * py, m[b + 1] * turnB);
  }
}
