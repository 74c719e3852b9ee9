package org.jbox2d.dynamics.solver;

/**
 * Pins two points together; the bodies turn about them, within limits and driven by a motor if
 * wanted.
 *
 * <pre>
 *   point:  C = xB + rB - xA - rA = 0        2 x 2 block, solved at once (see {@link Arms})
 *   angle:  theta = aB - aA - reference,  thetadot = wB - wA,  K = iA + iB
 *   motor:  thetadot = speed,             |sum of impulses| &lt;= maxTorque h
 *   lower:  theta - lower >= 0,           sum >= 0
 *   upper:  upper - theta >= 0,           sum >= 0
 * </pre>
 *
 * A limit lets the angle come as near as it is within the step, {@code thetadot + (theta - lower) /
 * h >= 0}, so it is reached and not overshot; a violated one (bodies placed by hand) is mended by
 * position correction. The point is solved last in each iteration, so that of what does not
 * converge it has least. Source: Catto, "Modeling and solving constraints", GDC 2009.
 *
 * <p>An angular impulse T alone would tear the point apart, and where the arm is long (a bob of
 * radius r pinned 16 r away: inertia about the pin 500 times that about the centre) point and limit
 * would take hundreds of iterations to agree. So each T goes with the point impulse that leaves the
 * point's speed as it is, by elimination of the point from the system of both, c their speeds:
 *
 * <pre>
 *   ( Kpp  Kpt ) (P)     (cp)     T = -(ct - E . cp) / S,   E = Kpp^-1 Kpt
 *   ( Ktp  Ktt ) (T) = - (ct)     P = -Kpp^-1 cp - E T,     S = Ktt - Ktp E   (Schur complement)
 *   Kpt = iA rA' + iB rB',  r' = (-ry, rx),  Ktt = iA + iB
 * </pre>
 *
 * {@code E . cp} is by how much the pin, solved next, will turn the bodies back; it is 0 unless
 * loads or other joints of theirs have moved the points. Without it, T would follow from one row
 * and act along another: in the metric of the kinetic energy no orthogonal projection, which never
 * adds to it, but an oblique one, which makes velocities up to {@code sqrt(Ktt / S)} times as
 * large, 44 for a bob of half a metre 9 m from its pin. Then a second joint of the bob and this one
 * drive each other up in each iteration.
 *
 * <p>With {@code Kpp^-1 = (m 1 + iA rA rA^T + iB rB rB^T) / det Kpp}, {@code m = mA + mB}, and S
 * the determinant of the whole system (see {@link WeldKernel}) over that of Kpp (see {@link Arms}),
 *
 * <pre>
 *   E = (m Kpt + iA iB (rA x rB) (rB - rA)) / det Kpp
 *   S = m (m (iA + iB) + iA iB (rB - rA)^2) / det Kpp
 * </pre>
 *
 * where nothing cancels. Of the differences above floats have no digit left at arms of some 30
 * times the radius of gyration; an S of less than half its value has T overshoot further each time.
 */
public final class RevoluteKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 21;

  private static final int REFERENCE = 8;
  private static final int LIMITED = 9;
  private static final int LOWER = 10;
  private static final int UPPER = 11;
  private static final int DRIVEN = 12;
  private static final int SPEED = 13;
  private static final int MAX_TORQUE = 14;
  // In and out.
  private static final int IMPULSE_X = 15;
  private static final int IMPULSE_Y = 16;
  private static final int MOTOR_IMPULSE = 17;
  private static final int LOWER_IMPULSE = 18;
  private static final int UPPER_IMPULSE = 19;
  // Own.
  private static final int M11 = 20;
  private static final int M12 = 21;
  private static final int M22 = 22;
  private static final int AXIAL_MASS = 23;
  private static final int LOWER_ROOM = 24;
  private static final int UPPER_ROOM = 25;
  private static final int EX = 26;
  private static final int EY = 27;
  private static final int MOST_BEND = 28;

  /**
   * Share of {@code Ktt} below which S is not used: T and the moment of {@code -E T}, some 1 /
   * share times what they leave together, would leave rounding. The pin does not let the bodies
   * turn.
   */
  private static final float LEAST_TURN = 1e-5f;

  RevoluteKernel(int order) {
    super(order, IMPULSE_X, 5);
  }

  /** Fills in the angle of a row: rad, rad. */
  public static void writeLimit(
      float[] f, int o, float reference, boolean limited, float lower, float upper) {
    f[o + REFERENCE] = reference;
    f[o + LIMITED] = limited ? 1f : 0f;
    f[o + LOWER] = lower;
    f[o + UPPER] = upper;
  }

  /** Fills in the motor of a row: rad/s, N m. */
  public static void writeMotor(float[] f, int o, boolean driven, float speed, float maxTorque) {
    f[o + DRIVEN] = driven ? 1f : 0f;
    f[o + SPEED] = speed;
    f[o + MAX_TORQUE] = maxTorque;
  }

  /**
   * Fills in the impulses kept from the last step, once limit and motor have been; of one that is
   * off none is kept.
   */
  public static void writeImpulses(
      float[] f, int o, float x, float y, float motor, float lower, float upper) {
    f[o + IMPULSE_X] = x;
    f[o + IMPULSE_Y] = y;
    f[o + MOTOR_IMPULSE] = f[o + DRIVEN] * motor;
    f[o + LOWER_IMPULSE] = f[o + LIMITED] * lower;
    f[o + UPPER_IMPULSE] = f[o + LIMITED] * upper;
  }

  /** Returns the impulse on body B along x, N s. */
  public static float impulseX(float[] f, int o) {
    return f[o + IMPULSE_X];
  }

  /** Returns the impulse on body B along y, N s. */
  public static float impulseY(float[] f, int o) {
    return f[o + IMPULSE_Y];
  }

  /** Returns the motor's angular impulse on body B, N m s. */
  public static float motorImpulse(float[] f, int o) {
    return f[o + MOTOR_IMPULSE];
  }

  /** Returns the lower limit's angular impulse, N m s, not negative. */
  public static float lowerImpulse(float[] f, int o) {
    return f[o + LOWER_IMPULSE];
  }

  /** Returns the upper limit's angular impulse, N m s, not negative; it acts backwards. */
  public static float upperImpulse(float[] f, int o) {
    return f[o + UPPER_IMPULSE];
  }

  /** Whether a row has neither limit nor motor. */
  static boolean isPlain(float[] f, int o) {
    return f[o + DRIVEN] + f[o + LIMITED] == 0f;
  }

  /** Returns {@link Arms#mostBend} of a row that has been prepared, m/s. */
  static float mostBend(float[] f, int o) {
    return f[o + MOST_BEND];
  }

  /** Adds to the impulse on body B, N s. */
  static void addImpulse(float[] f, int o, float x, float y) {
    f[o + IMPULSE_X] += x;
    f[o + IMPULSE_Y] += y;
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    float[] m = bodies.mass;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      int a = SolverBodies.STRIDE * slotA;
      int b = SolverBodies.STRIDE * slotB;
      Arms.turn(f, o, bodies.pos, a, b);
      Arms.invert(f, o, o + M11, m, a, b);
      f[o + MOST_BEND] = Arms.mostBend(f, o, bodies, a, b, step);
      float axial = 0f;
      if (f[o + DRIVEN] + f[o + LIMITED] > 0f) {
        eliminatePoint(f, o, m[a] + m[b], m[a + 1], m[b + 1]);
        float angle = bodies.angle[slotB] - bodies.angle[slotA] - f[o + REFERENCE];
        axial = prepareAngle(f, o, angle, keep, step.invDt);
      }
      f[o + IMPULSE_X] *= keep;
      f[o + IMPULSE_Y] *= keep;
      Arms.push(f, o, v, m, a, b, f[o + IMPULSE_X], f[o + IMPULSE_Y], axial);
    }
  }

  /** Returns the angular impulse that motor and limits keep. */
  private static float prepareAngle(float[] f, int o, float angle, float keep, float invH) {
    float keepLimit = f[o + LIMITED] * keep;
    f[o + LOWER_ROOM] = Math.max(0f, angle - f[o + LOWER]) * invH;
    f[o + UPPER_ROOM] = Math.max(0f, f[o + UPPER] - angle) * invH;
    f[o + MOTOR_IMPULSE] *= f[o + DRIVEN] * keep;
    f[o + LOWER_IMPULSE] *= keepLimit;
    f[o + UPPER_IMPULSE] *= keepLimit;
    return f[o + MOTOR_IMPULSE] + f[o + LOWER_IMPULSE] - f[o + UPPER_IMPULSE];
  }

  /** Computes E and 1 / S; where the point cannot be held at all, the angle is solved alone. */
  private static void eliminatePoint(float[] f, int o, float mass, float iA, float iB) {
    float rAx = f[o + Arms.RAX];
    float rAy = f[o + Arms.RAY];
    float rBx = f[o + Arms.RBX];
    float rBy = f[o + Arms.RBY];
    float ex = rBx - rAx;
    float ey = rBy - rAy;
    float both = iA * iB;
    float cross = rAx * rBy - rAy * rBx;
    float arms = iA * (rAx * rAx + rAy * rAy) + iB * (rBx * rBx + rBy * rBy);
    float det = mass * (mass + arms) + both * cross * cross;
    float inv = det > 0f ? 1f / det : 0f;
    f[o + EX] = inv * (both * cross * ex - mass * (iA * rAy + iB * rBy));
    f[o + EY] = inv * (both * cross * ey + mass * (iA * rAx + iB * rBx));
    float turn = iA + iB;
    float s = det > 0f ? inv * mass * (mass * turn + both * (ex * ex + ey * ey)) : turn;
    f[o + AXIAL_MASS] = s > LEAST_TURN * turn ? 1f / s : 0f;
  }

  /**
   * {@inheritDoc}
   *
   * <p>The point is solved here and not in a method of its own, which would be too large for the
   * JIT to inline; with all that it reads held in local variables, see {@link PinKernel}.
   */
  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    float[] m = bodies.mass;
    float h = step.dt;
    float invH = step.invDt;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      if (f[o + DRIVEN] + f[o + LIMITED] > 0f && !isBetweenLimits(f, o, v, a, b)) {
        float turn = axialImpulse(f, o, pinnedSpeed(f, o, v, a, b, step), h);
        if (turn != 0f) {
          float alongX = -f[o + EX] * turn;
          float alongY = -f[o + EY] * turn;
          f[o + IMPULSE_X] += alongX;
          f[o + IMPULSE_Y] += alongY;
          Arms.push(f, o, v, m, a, b, alongX, alongY, turn);
        }
      }

      // The point
      float rAx = f[o + Arms.RAX];
      float rAy = f[o + Arms.RAY];
      float rBx = f[o + Arms.RBX];
      float rBy = f[o + Arms.RBY];
      float vAx = v[a];
      float vAy = v[a + 1];
      float wA = v[a + 2];
      float vBx = v[b];
      float vBy = v[b + 1];
      float wB = v[b + 2];
      float cx = vBx - wB * rBy - vAx + wA * rAy;
      float cy = vBy + wB * rBx - vAy - wA * rAx;
      float mostBend = f[o + MOST_BEND];
      if (mostBend > 0f) {
        float tA = Arms.turn(wA * h);
        float tB = Arms.turn(wB * h);
        float versineA = Arms.versine(tA);
        float versineB = Arms.versine(tB);
        float lagA = Arms.lag(tA);
        float lagB = Arms.lag(tB);
        float bendX = invH * (versineA * rAx - lagA * rAy - versineB * rBx + lagB * rBy);
        float bendY = invH * (versineA * rAy + lagA * rAx - versineB * rBy - lagB * rBx);
        cx += Arms.bounded(bendX, mostBend);
        cy += Arms.bounded(bendY, mostBend);
      }
      float px = -(f[o + M11] * cx + f[o + M12] * cy);
      float py = -(f[o + M12] * cx + f[o + M22] * cy);
      f[o + IMPULSE_X] += px;
      f[o + IMPULSE_Y] += py;
      float mA = m[a];
      float iA = m[a + 1];
      float mB = m[b];
      float iB = m[b + 1];
      v[a] = vAx - mA * px;
      v[a + 1] = vAy - mA * py;
      v[a + 2] = wA - iA * (rAx * py - rAy * px);
      v[b] = vBx + mB * px;
      v[b + 1] = vBy + mB * py;
      v[b + 2] = wB + iB * (rBx * py - rBy * px);
    }
  }

  /**
   * Whether the row turns freely between its limits, whatever the bend comes to: limits of most
   * limbs and doors hardly ever act.
   */
  private static boolean isBetweenLimits(float[] f, int o, float[] v, int a, int b) {
    if (f[o + DRIVEN] + f[o + LOWER_IMPULSE] + f[o + UPPER_IMPULSE] > 0f) {
      return false;
    }
    float ex = f[o + EX];
    float ey = f[o + EY];
    float speed = v[b + 2] - v[a + 2];
    speed -= ex * Arms.speedX(f, o, v, a, b) + ey * Arms.speedY(f, o, v, a, b);
    float bend = (Math.abs(ex) + Math.abs(ey)) * f[o + MOST_BEND];
    return f[o + LOWER_ROOM] + speed > bend && f[o + UPPER_ROOM] - speed > bend;
  }

  /** {@code ct - E . cp}: at what speed the bodies will turn once the pin is solved. */
  private static float pinnedSpeed(float[] f, int o, float[] v, int a, int b, StepConfig step) {
    float cx = Arms.speedX(f, o, v, a, b);
    float cy = Arms.speedY(f, o, v, a, b);
    float most = f[o + MOST_BEND];
    if (most > 0f) {
      cx += Arms.bounded(Arms.bendX(f, o, v, a, b, step.dt, step.invDt), most);
      cy += Arms.bounded(Arms.bendY(f, o, v, a, b, step.dt, step.invDt), most);
    }
    return v[b + 2] - v[a + 2] - f[o + EX] * cx - f[o + EY] * cy;
  }

  /** Motor, lower and upper limit in turn; each sees the speed the one before it has left. */
  private static float axialImpulse(float[] f, int o, float speed, float h) {
    float mass = f[o + AXIAL_MASS];
    float k = mass > 0f ? 1f / mass : 0f;
    float turn = 0f;
    if (f[o + DRIVEN] > 0f) {
      float most = f[o + MAX_TORQUE] * h;
      float old = f[o + MOTOR_IMPULSE];
      float sum = old - mass * (speed - f[o + SPEED]);
      f[o + MOTOR_IMPULSE] = Math.max(-most, Math.min(most, sum));
      turn = f[o + MOTOR_IMPULSE] - old;
    }
    if (f[o + LIMITED] > 0f) {
      float old = f[o + LOWER_IMPULSE];
      float sum = old - mass * (speed + k * turn + f[o + LOWER_ROOM]);
      f[o + LOWER_IMPULSE] = Math.max(0f, sum);
      turn += f[o + LOWER_IMPULSE] - old;
      old = f[o + UPPER_IMPULSE];
      sum = old - mass * (f[o + UPPER_ROOM] - speed - k * turn);
      f[o + UPPER_IMPULSE] = Math.max(0f, sum);
      turn -= f[o + UPPER_IMPULSE] - old;
    }
    return turn;
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
      if (f[o + LIMITED] > 0f) {
        float angle = bodies.angle[slotB] - bodies.angle[slotA] - f[o + REFERENCE];
        float c = angle - Math.max(f[o + LOWER], Math.min(f[o + UPPER], angle));
        float k = m[SolverBodies.STRIDE * slotA + 1] + m[SolverBodies.STRIDE * slotB + 1];
        float p = (k > 0f ? -c / k : 0f) * Arms.share(Math.abs(c), step.maxAngularCorrection);
        Arms.move(bodies, slotA, 0f, 0f, -m[SolverBodies.STRIDE * slotA + 1] * p);
        Arms.move(bodies, slotB, 0f, 0f, m[SolverBodies.STRIDE * slotB + 1] * p);
        done &= Math.abs(c) <= step.angularSlop;
      }
      float gap2 = PinKernel.join(f, o, bodies, slotA, slotB, step.maxAngularCorrection);
      done &= gap2 <= step.linearSlop * step.linearSlop;
    }
    return done;
  }
}
