package org.jbox2d.dynamics.solver;

/**
 * Holds two bodies together: points coincide and the angle between the bodies is kept, hard or by a
 * spring.
 *
 * <pre>
 *   point:  C = xB + rB - xA - rA,        K (2 x 2) as in {@link Arms}
 *   angle:  C = aB - aA - reference,      K33 = iA + iB + gamma
 *   coupling: k = iA rA' + iB rB',        r' = (-ry, rx)
 * </pre>
 *
 * The 3 x 3 system is solved by elimination of the angle. Its Schur complement
 *
 * <pre>
 *   K - k k^T / K33 = (mA + mB) 1
 *       + (iA iB (rA - rB)' (rA - rB)'^T + gamma (iA rA' rA'^T + iB rB' rB'^T)) / K33
 * </pre>
 *
 * is again a sum of terms that are not negative. gamma is 0 for a hard angle and comes from {@link
 * Spring} for a soft one, whose effective mass is {@code 1 / (iA + iB)}. If neither body can turn,
 * the point alone is solved.
 */
public final class WeldKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 17;

  private static final int REFERENCE = 8;
  private static final int FREQUENCY = 9;
  private static final int DAMPING = 10;
  private static final int SPIN_BEFORE = 11;
  // In and out.
  private static final int IMPULSE_X = 12;
  private static final int IMPULSE_Y = 13;
  private static final int TURN_IMPULSE = 14;
  // Own: inverse of the Schur complement, coupling, 1 / K33, softness and bias of the angle.
  private static final int M11 = 15;
  private static final int M12 = 16;
  private static final int M22 = 17;
  private static final int KX = 18;
  private static final int KY = 19;
  private static final int ANGLE_MASS = 20;
  private static final int GAMMA = 21;
  private static final int BIAS = 22;
  private static final int MOST_BEND = 23;

  WeldKernel(int order) {
    super(order, IMPULSE_X, 3);
  }

  /**
   * Fills in the angle of a row.
   *
   * @param frequency Hz; 0 for a hard angle
   * @param spinBefore wB - wA before the step's forces, rad/s; needed for a spring alone
   */
  public static void writeAngle(
      float[] f, int o, float reference, float frequency, float damping, float spinBefore) {
    f[o + REFERENCE] = reference;
    f[o + FREQUENCY] = frequency;
    f[o + DAMPING] = damping;
    f[o + SPIN_BEFORE] = spinBefore;
  }

  /** Fills in the impulses kept from the last step. */
  public static void writeImpulses(float[] f, int o, float x, float y, float turn) {
    f[o + IMPULSE_X] = x;
    f[o + IMPULSE_Y] = y;
    f[o + TURN_IMPULSE] = turn;
  }

  /** Returns the impulse on body B along x, N s. */
  public static float impulseX(float[] f, int o) {
    return f[o + IMPULSE_X];
  }

  /** Returns the impulse on body B along y, N s. */
  public static float impulseY(float[] f, int o) {
    return f[o + IMPULSE_Y];
  }

  /** Returns the angular impulse on body B, N m s. */
  public static float turnImpulse(float[] f, int o) {
    return f[o + TURN_IMPULSE];
  }

  @Override
  void keepVelocities(JointRows rows, int from, int to, SolverBodies bodies) {
    for (int r = from; r < to; r++) {
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      rows.f[rows.floatAt[r] + SPIN_BEFORE] = bodies.vel[b + 2] - bodies.vel[a + 2];
    }
  }

  @Override
  float twist(JointRows rows, int row, SolverBodies bodies) {
    int o = rows.floatAt[row];
    int at = rows.bodyAt[row];
    float ia = bodies.mass[SolverBodies.STRIDE * rows.bodies[at] + 1];
    float ib = bodies.mass[SolverBodies.STRIDE * rows.bodies[at + 1] + 1];
    return rows.f[o + FREQUENCY] > 0f ? 0f : Math.abs(rows.f[o + TURN_IMPULSE]) * Math.max(ia, ib);
  }

  /** A beam of welds sags by what is left of each. */
  @Override
  boolean isCorrectedOften() {
    return true;
  }

  @Override
  public void prepare(JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] m = bodies.mass;
    float keep = step.warmStarting ? step.dtRatio : 0f;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      int a = SolverBodies.STRIDE * slotA;
      int b = SolverBodies.STRIDE * slotB;
      Arms.turn(f, o, bodies.pos, a, b);
      f[o + MOST_BEND] = Arms.mostBend(f, o, bodies, a, b, step);
      float k = m[a + 1] + m[b + 1];
      f[o + GAMMA] = 0f;
      f[o + BIAS] = 0f;
      if (f[o + FREQUENCY] > 0f && k > 0f) {
        float c = bodies.angle[slotB] - bodies.angle[slotA] - f[o + REFERENCE];
        float before = f[o + SPIN_BEFORE];
        Spring.soften(f, o + GAMMA, k, f[o + FREQUENCY], f[o + DAMPING], step.dt, c, before);
      }
      factorise(f, o, m, a, b);
      f[o + IMPULSE_X] *= keep;
      f[o + IMPULSE_Y] *= keep;
      f[o + TURN_IMPULSE] *= keep;
      Arms.push(f, o, bodies.vel, m, a, b, f[o + IMPULSE_X], f[o + IMPULSE_Y], f[o + TURN_IMPULSE]);
    }
  }

  /** Computes what {@link #solveVelocity} and {@link #solvePosition} need to solve the system. */
  private static void factorise(float[] f, int o, float[] m, int a, int b) {
    float rax = f[o + Arms.RAX];
    float ray = f[o + Arms.RAY];
    float rbx = f[o + Arms.RBX];
    float rby = f[o + Arms.RBY];
    float mass = m[a] + m[b];
    float ia = m[a + 1];
    float ib = m[b + 1];
    float gamma = f[o + GAMMA];
    float k33 = ia + ib + gamma;
    float inv33 = k33 > 0f ? 1f / k33 : 0f;
    float both = ia * ib * inv33;
    float softA = ia * gamma * inv33;
    float softB = ib * gamma * inv33;
    float ex = rax - rbx;
    float ey = ray - rby;
    // Of the form mass 1 + sum w r' r'^T: the determinant is a sum of non-negative terms, see Arms.
    float crossAB = rax * rby - ray * rbx;
    float crossEA = ex * ray - ey * rax;
    float crossEB = ex * rby - ey * rbx;
    float xx = both * ex * ex + softA * rax * rax + softB * rbx * rbx;
    float yy = both * ey * ey + softA * ray * ray + softB * rby * rby;
    float xy = both * ex * ey + softA * rax * ray + softB * rbx * rby;
    float det =
        mass * (mass + xx + yy)
            + softA * softB * crossAB * crossAB
            + both * softA * crossEA * crossEA
            + both * softB * crossEB * crossEB;
    float inv = det > 0f ? 1f / det : 0f;
    f[o + M11] = inv * (mass + xx);
    f[o + M12] = inv * xy;
    f[o + M22] = inv * (mass + yy);
    f[o + KX] = -ia * ray - ib * rby;
    f[o + KY] = ia * rax + ib * rbx;
    f[o + ANGLE_MASS] = inv33;
  }

  @Override
  public void solveVelocity(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    float[] v = bodies.vel;
    float h = step.dt;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float cx = Arms.speedX(f, o, v, a, b);
      float cy = Arms.speedY(f, o, v, a, b);
      float most = f[o + MOST_BEND];
      if (most > 0f) {
        cx += Arms.bounded(Arms.bendX(f, o, v, a, b, h, step.invDt), most);
        cy += Arms.bounded(Arms.bendY(f, o, v, a, b, h, step.invDt), most);
      }
      float cw = v[b + 2] - v[a + 2] + f[o + BIAS] + f[o + GAMMA] * f[o + TURN_IMPULSE];
      float angle = f[o + ANGLE_MASS];
      float sx = cx - f[o + KX] * angle * cw;
      float sy = cy - f[o + KY] * angle * cw;
      float px = -(f[o + M11] * sx + f[o + M12] * sy);
      float py = -(f[o + M12] * sx + f[o + M22] * sy);
      float turn = -angle * (cw + f[o + KX] * px + f[o + KY] * py);
      f[o + IMPULSE_X] += px;
      f[o + IMPULSE_Y] += py;
      f[o + TURN_IMPULSE] += turn;
      Arms.push(f, o, v, bodies.mass, a, b, px, py, turn);
    }
  }

  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    float[] f = rows.f;
    boolean done = true;
    for (int r = from; r < to; r++) {
      int o = rows.floatAt[r];
      int slotA = rows.bodies[rows.bodyAt[r]];
      int slotB = rows.bodies[rows.bodyAt[r] + 1];
      float most = step.maxAngularCorrection;
      if (f[o + FREQUENCY] > 0f) {
        float gap2 = PinKernel.join(f, o, bodies, slotA, slotB, most);
        done &= gap2 <= step.linearSlop * step.linearSlop;
      } else {
        done &= mend(f, o, bodies, slotA, slotB, step);
      }
    }
    return done;
  }

  /** One Newton step of the hard weld; returns whether it was within tolerance before. */
  private static boolean mend(
      float[] f, int o, SolverBodies bodies, int slotA, int slotB, StepConfig step) {
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    Arms.turn(f, o, bodies.pos, a, b);
    factorise(f, o, bodies.mass, a, b);
    float cx = Arms.gapX(f, o, bodies.pos, a, b);
    float cy = Arms.gapY(f, o, bodies.pos, a, b);
    float cw = bodies.angle[slotB] - bodies.angle[slotA] - f[o + REFERENCE];
    float error = (float) Math.sqrt(cx * cx + cy * cy);
    boolean done = error <= step.linearSlop && Math.abs(cw) <= step.angularSlop;
    float angle = f[o + ANGLE_MASS];
    float sx = cx - f[o + KX] * angle * cw;
    float sy = cy - f[o + KY] * angle * cw;
    float px = -(f[o + M11] * sx + f[o + M12] * sy);
    float py = -(f[o + M12] * sx + f[o + M22] * sy);
    float turn = -angle * (cw + f[o + KX] * px + f[o + KY] * py);
    float most = step.maxAngularCorrection;
    float share = Arms.turnShare(f, o, bodies.mass, a, b, px, py, turn, most);
    Arms.shift(f, o, bodies, slotA, slotB, share * px, share * py, share * turn);
    return done;
  }
}
