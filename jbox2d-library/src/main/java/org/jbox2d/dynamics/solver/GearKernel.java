package org.jbox2d.dynamics.solver;

/**
 * Couples the coordinates of two joints: {@code C = q1 + ratio q2 - constant = 0}.
 *
 * <p>The coordinate of a revolute joint between a base and a moving body is the angle {@code aM -
 * aB - reference}; that of a prismatic joint is {@code q = u . d, d = xM + rM - xB - rB}, u turning
 * with the base. Their gradients by (x, y, angle) of the two bodies:
 *
 * <pre>
 *   revolute:   moving (0, 0, 1)            base (0, 0, -1)
 *   prismatic:  moving (ux, uy, rM x u)     base (-ux, -uy, -(d + rB) x u)
 * </pre>
 *
 * The row has four bodies: moving 1, moving 2, base 1, base 2, those of joint 2 with the ratio in
 * the gradient. Where one body takes two of these parts, its gradients are added before {@code K =
 * sum J_i M_i^-1 J_i^T}. One equality row, nothing clamped; what limits the coordinates is in the
 * coupled joints (model: Catto, "Modeling and solving constraints", GDC 2009).
 */
public final class GearKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = 32;

  /** Where the two halves of a row start that {@link #writeHalf} fills in. */
  public static final int FIRST = 0;

  /** See {@link #FIRST}. */
  public static final int SECOND = 8;

  // In each half: kind (0 revolute, 1 prismatic), reference angle, arms relative to the centres,
  // axis in the base's frame.
  private static final int PRISMATIC = 0;
  private static final int REFERENCE = 1;
  private static final int BASE_X = 2;
  private static final int BASE_Y = 3;
  private static final int MOVING_X = 4;
  private static final int MOVING_Y = 5;
  private static final int AXIS_X = 6;
  private static final int AXIS_Y = 7;

  private static final int RATIO = 16;
  private static final int CONSTANT = 17;
  // In and out.
  private static final int IMPULSE = 18;
  // Own: gradients of the four bodies, three floats each.
  private static final int MASS = 19;
  private static final int J = 20;

  /** Bodies of a row. */
  public static final int BODIES = 4;

  GearKernel(int order) {
    super(order, IMPULSE, 1);
  }

  /**
   * Fills in what one of the coupled joints is.
   *
   * @param half start of the row plus {@link #FIRST} or {@link #SECOND}
   * @param axisX unit axis in the base's frame; of no meaning for a revolute joint
   */
  public static void writeHalf(
      float[] f,
      int half,
      boolean prismatic,
      float reference,
      float baseX,
      float baseY,
      float movingX,
      float movingY,
      float axisX,
      float axisY) {
    f[half + PRISMATIC] = prismatic ? 1f : 0f;
    f[half + REFERENCE] = reference;
    f[half + BASE_X] = baseX;
    f[half + BASE_Y] = baseY;
    f[half + MOVING_X] = movingX;
    f[half + MOVING_Y] = movingY;
    f[half + AXIS_X] = axisX;
    f[half + AXIS_Y] = axisY;
  }

  /** Fills in the coupling and the impulse kept from the last step. */
  public static void writeCoupling(float[] f, int o, float ratio, float constant, float impulse) {
    f[o + RATIO] = ratio;
    f[o + CONSTANT] = constant;
    f[o + IMPULSE] = impulse;
  }

  /** Returns the impulse on coordinate 1, N s or N m s. */
  public static float impulse(float[] f, int o) {
    return f[o + IMPULSE];
  }

  /** Returns the gradient of C by the place of the second moving body along x. */
  public static float gradientX(float[] f, int o) {
    return f[o + J + 3];
  }

  /** Returns the gradient of C by the place of the second moving body along y. */
  public static float gradientY(float[] f, int o) {
    return f[o + J + 4];
  }

  /** Returns the gradient of C by the angle of the second moving body. */
  public static float gradientTurn(float[] f, int o) {
    return f[o + J + 5];
  }

  @Override
  float bend(JointRows rows, int row, SolverBodies bodies) {
    return 0f;
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      place(rows, r, bodies);
      f[o + IMPULSE] *= keep;
      push(rows, r, bodies, f[o + IMPULSE]);
    }
  }

  /** Computes gradients and mass; returns C. */
  private static float place(JointRows rows, int r, SolverBodies bodies) {
    float[] f = rows.f;
    int o = rows.floatAt[r];
    int[] slots = rows.bodies;
    int s = rows.bodyAt[r];
    float ratio = f[o + RATIO];
    float q1 = half(f, o + FIRST, o + J, o + J + 6, bodies, slots[s], slots[s + 2], 1f);
    float q2 = half(f, o + SECOND, o + J + 3, o + J + 9, bodies, slots[s + 1], slots[s + 3], ratio);
    for (int i = 1; i < BODIES; i++) {
      for (int k = 0; k < i; k++) {
        if (slots[s + i] == slots[s + k]) {
          merge(f, o + J + 3 * k, o + J + 3 * i);
        }
      }
    }
    float sum = 0f;
    for (int i = 0; i < BODIES; i++) {
      int b = SolverBodies.STRIDE * slots[s + i];
      int j = o + J + 3 * i;
      sum += bodies.mass[b] * (f[j] * f[j] + f[j + 1] * f[j + 1]);
      sum += bodies.mass[b + 1] * f[j + 2] * f[j + 2];
    }
    f[o + MASS] = sum > 0f ? 1f / sum : 0f;
    return q1 + ratio * q2 - f[o + CONSTANT];
  }

  /** Writes the gradients of one coordinate, times scale; returns the coordinate. */
  private static float half(
      float[] f,
      int in,
      int jMoving,
      int jBase,
      SolverBodies bodies,
      int moving,
      int base,
      float scale) {
    if (f[in + PRISMATIC] == 0f) {
      set(f, jMoving, 0f, 0f, scale);
      set(f, jBase, 0f, 0f, -scale);
      return bodies.angle[moving] - bodies.angle[base] - f[in + REFERENCE];
    }
    float[] x = bodies.pos;
    int m = SolverBodies.STRIDE * moving;
    int b = SolverBodies.STRIDE * base;
    float ux = x[b + 3] * f[in + AXIS_X] - x[b + 2] * f[in + AXIS_Y];
    float uy = x[b + 2] * f[in + AXIS_X] + x[b + 3] * f[in + AXIS_Y];
    float rbx = x[b + 3] * f[in + BASE_X] - x[b + 2] * f[in + BASE_Y];
    float rby = x[b + 2] * f[in + BASE_X] + x[b + 3] * f[in + BASE_Y];
    float rmx = x[m + 3] * f[in + MOVING_X] - x[m + 2] * f[in + MOVING_Y];
    float rmy = x[m + 2] * f[in + MOVING_X] + x[m + 3] * f[in + MOVING_Y];
    float armX = x[m] + rmx - x[b];
    float armY = x[m + 1] + rmy - x[b + 1];
    set(f, jMoving, scale * ux, scale * uy, scale * (rmx * uy - rmy * ux));
    set(f, jBase, -scale * ux, -scale * uy, -scale * (armX * uy - armY * ux));
    return ux * (armX - rbx) + uy * (armY - rby);
  }

  private static void set(float[] f, int j, float x, float y, float turn) {
    f[j] = x;
    f[j + 1] = y;
    f[j + 2] = turn;
  }

  private static void merge(float[] f, int to, int from) {
    f[to] += f[from];
    f[to + 1] += f[from + 1];
    f[to + 2] += f[from + 2];
    set(f, from, 0f, 0f, 0f);
  }

  private static void push(JointRows rows, int r, SolverBodies bodies, float p) {
    float[] f = rows.f;
    int s = rows.bodyAt[r];
    for (int i = 0; i < BODIES; i++) {
      int b = SolverBodies.STRIDE * rows.bodies[s + i];
      int j = rows.floatAt[r] + J + 3 * i;
      float m = bodies.mass[b] * p;
      bodies.vel[b] += m * f[j];
      bodies.vel[b + 1] += m * f[j + 1];
      bodies.vel[b + 2] += bodies.mass[b + 1] * p * f[j + 2];
    }
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int s = rows.bodyAt[r];
      float speed = 0f;
      for (int i = 0; i < BODIES; i++) {
        int b = SolverBodies.STRIDE * rows.bodies[s + i];
        int j = o + J + 3 * i;
        speed += f[j] * v[b] + f[j + 1] * v[b + 1] + f[j + 2] * v[b + 2];
      }
      float p = -f[o + MASS] * speed;
      f[o + IMPULSE] += p;
      push(rows, r, bodies, p);
    }
  }

  /** C may be a length or an angle; the linear slop, the smaller number, is asked of both. */
  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int s = rows.bodyAt[r];
      float c = place(rows, r, bodies);
      float p = -f[o + MASS] * c;
      for (int i = 0; i < BODIES; i++) {
        int slot = rows.bodies[s + i];
        int b = SolverBodies.STRIDE * slot;
        int j = o + J + 3 * i;
        float m = bodies.mass[b] * p;
        Arms.move(bodies, slot, m * f[j], m * f[j + 1], bodies.mass[b + 1] * p * f[j + 2]);
      }
      done &= Math.abs(c) <= step.linearSlop;
    }
    return done;
  }
}
