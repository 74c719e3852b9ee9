package org.jbox2d.dynamics.solver;

/**
 * A wheel on a suspension: a point of body B stays on an axis of body A, held along it by a spring;
 * body B turns freely or is driven.
 *
 * <p>With axis a, normal n and the arms s and a as in {@link PrismaticKernel}:
 *
 * <pre>
 *   across: C1 = n . d = 0,   K = mA + mB + iA s1^2 + iB s2^2
 *   spring: C  = a . d,       K = mA + mB + iA a1^2 + iB a2^2,   see {@link Spring}
 *   motor:  wB - wA = speed,  K = iA + iB,  |sum of impulses| &lt;= maxTorque h
 * </pre>
 *
 * A frequency of 0 means no spring: the wheel slides freely along the axis. The bend of the path
 * across the axis is as in {@link PrismaticKernel}, and bounded as in {@link Arms#mostBend}: a
 * splinter that keeps a joint far outside of it was thrown off at 10^9 m/s.
 */
public final class WheelKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 28;

  private static final int AXIS_X = 8;
  private static final int AXIS_Y = 9;
  private static final int FREQUENCY = 10;
  private static final int DAMPING = 11;
  private static final int DRIVEN = 12;
  private static final int SPEED = 13;
  private static final int MAX_TORQUE = 14;

  /** Place of six floats: velocities of A and B before the step's forces (x, y, angular). */
  public static final int BEFORE = 15;

  // In and out.
  private static final int ACROSS_IMPULSE = 21;
  private static final int SPRING_IMPULSE = 22;
  private static final int MOTOR_IMPULSE = 23;
  // Own; the first six as in Rail.
  private static final int AX = 24;
  private static final int AY = 25;
  private static final int S1 = 26;
  private static final int S2 = 27;
  private static final int A1 = 28;
  private static final int A2 = 29;
  private static final int ACROSS_MASS = 30;
  private static final int SPRING_MASS = 31;
  private static final int GAMMA = 32;
  private static final int BIAS = 33;
  private static final int MOTOR_MASS = 34;
  private static final int MOST_BEND = 35;

  WheelKernel(int order) {
    super(order, ACROSS_IMPULSE, 3);
  }

  /** Fills in the axis, a unit vector in A's frame, and the spring along it. */
  public static void writeSpring(
      float[] f, int o, float x, float y, float frequency, float damping) {
    f[o + AXIS_X] = x;
    f[o + AXIS_Y] = y;
    f[o + FREQUENCY] = frequency;
    f[o + DAMPING] = damping;
  }

  /** Fills in the motor: rad/s, N m. */
  public static void writeMotor(float[] f, int o, boolean driven, float speed, float maxTorque) {
    f[o + DRIVEN] = driven ? 1f : 0f;
    f[o + SPEED] = speed;
    f[o + MAX_TORQUE] = maxTorque;
  }

  /** Fills in the impulses kept from the last step. */
  public static void writeImpulses(float[] f, int o, float across, float spring, float motor) {
    f[o + ACROSS_IMPULSE] = across;
    f[o + SPRING_IMPULSE] = spring;
    f[o + MOTOR_IMPULSE] = motor;
  }

  /** Returns the impulse on body B across the axis, along (-ay, ax), N s. */
  public static float acrossImpulse(float[] f, int o) {
    return f[o + ACROSS_IMPULSE];
  }

  /** Returns the impulse on body B along the axis, N s. */
  public static float springImpulse(float[] f, int o) {
    return f[o + SPRING_IMPULSE];
  }

  /** Returns the motor's angular impulse on body B, N m s. */
  public static float motorImpulse(float[] f, int o) {
    return f[o + MOTOR_IMPULSE];
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
  void keepVelocities(JointRows rows, int from, int to, SolverBodies bodies) {
    for (int r = from; r < to; r++) {
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      System.arraycopy(bodies.vel, a, rows.f, rows.floatAt[r] + BEFORE, 3);
      System.arraycopy(bodies.vel, b, rows.f, rows.floatAt[r] + BEFORE + 3, 3);
    }
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] m = bodies.mass;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float translation = place(f, o, bodies, a, b);
      float k = m[a] + m[b] + m[a + 1] * square(f[o + A1]) + m[b + 1] * square(f[o + A2]);
      if (f[o + FREQUENCY] > 0f && k > 0f) {
        float before = along(f, o, f, o + BEFORE, o + BEFORE + 3);
        float frequency = f[o + FREQUENCY];
        Spring.soften(f, o + GAMMA, k, frequency, f[o + DAMPING], step.dt, translation, before);
        f[o + SPRING_MASS] = 1f / (k + f[o + GAMMA]);
      } else {
        f[o + SPRING_MASS] = 0f;
        f[o + SPRING_IMPULSE] = 0f;
      }
      float turning = m[a + 1] + m[b + 1];
      f[o + MOTOR_MASS] = turning > 0f ? 1f / turning : 0f;
      float bend = Rail.bendAcross(f, o, o + AX, bodies.vel, a, b, step);
      boolean bent = Arms.isBent(Rail.gapAcross(f, o, o + AX), step);
      f[o + MOST_BEND] = bent ? Arms.mostBend(Math.abs(bend), step) : 0f;

      f[o + ACROSS_IMPULSE] *= keep;
      f[o + SPRING_IMPULSE] *= keep;
      f[o + MOTOR_IMPULSE] *= keep * f[o + DRIVEN];
      push(f, o, bodies, a, b, f[o + SPRING_IMPULSE], f[o + ACROSS_IMPULSE], f[o + MOTOR_IMPULSE]);
    }
  }

  private static float square(float value) {
    return value * value;
  }

  /** Computes axis, arms and the mass across; returns the translation. */
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
    f[o + AX] = ax;
    f[o + AY] = ay;
    f[o + S1] = armX * ax + armY * ay;
    f[o + S2] = f[o + Arms.RBX] * ax + f[o + Arms.RBY] * ay;
    f[o + A1] = armX * ay - armY * ax;
    f[o + A2] = f[o + Arms.RBX] * ay - f[o + Arms.RBY] * ax;
    float k = m[a] + m[b] + m[a + 1] * square(f[o + S1]) + m[b + 1] * square(f[o + S2]);
    f[o + ACROSS_MASS] = k > 0f ? 1f / k : 0f;
    return ax * dx + ay * dy;
  }

  /** Speed along the axis, of velocities that start at {@code a} and {@code b} of {@code v}. */
  private static float along(float[] f, int o, float[] v, int a, int b) {
    return f[o + AX] * (v[b] - v[a])
        + f[o + AY] * (v[b + 1] - v[a + 1])
        + f[o + A2] * v[b + 2]
        - f[o + A1] * v[a + 2];
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
      if (f[o + SPRING_MASS] > 0f) {
        float speed = along(f, o, v, a, b) + f[o + BIAS] + f[o + GAMMA] * f[o + SPRING_IMPULSE];
        float p = -f[o + SPRING_MASS] * speed;
        f[o + SPRING_IMPULSE] += p;
        push(f, o, bodies, a, b, p, 0f, 0f);
      }
      if (f[o + DRIVEN] > 0f) {
        float most = f[o + MAX_TORQUE] * step.dt;
        float old = f[o + MOTOR_IMPULSE];
        float sum = old - f[o + MOTOR_MASS] * (v[b + 2] - v[a + 2] - f[o + SPEED]);
        f[o + MOTOR_IMPULSE] = Math.max(-most, Math.min(most, sum));
        push(f, o, bodies, a, b, 0f, 0f, f[o + MOTOR_IMPULSE] - old);
      }
      float ax = f[o + AX];
      float ay = f[o + AY];
      float speed =
          ax * (v[b + 1] - v[a + 1])
              - ay * (v[b] - v[a])
              + f[o + S2] * v[b + 2]
              - f[o + S1] * v[a + 2];
      float bend = Rail.bendAcross(f, o, o + AX, v, a, b, step);
      float p = -f[o + ACROSS_MASS] * (speed + Arms.bounded(bend, f[o + MOST_BEND]));
      f[o + ACROSS_IMPULSE] += p;
      push(f, o, bodies, a, b, 0f, p, 0f);
    }
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
      place(f, o, bodies, a, b);
      float nx = -f[o + AY];
      float ny = f[o + AX];
      float c = nx * Arms.gapX(f, o, bodies.pos, a, b) + ny * Arms.gapY(f, o, bodies.pos, a, b);
      float p = -f[o + ACROSS_MASS] * c * Arms.share(Math.abs(c), step.maxLinearCorrection);
      Arms.move(bodies, slotA, -m[a] * p * nx, -m[a] * p * ny, -m[a + 1] * p * f[o + S1]);
      Arms.move(bodies, slotB, m[b] * p * nx, m[b] * p * ny, m[b + 1] * p * f[o + S2]);
      done &= Math.abs(c) <= step.linearSlop;
    }
    return done;
  }
}
