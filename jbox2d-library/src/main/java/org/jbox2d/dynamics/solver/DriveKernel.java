package org.jbox2d.dynamics.solver;

/**
 * Drives one body towards a place relative to another, with bounded force and torque. It serves the
 * motor joint and, with no correction, the friction joint, which is a motor that wants to stand
 * still.
 *
 * <pre>
 *   point:  ddot - wA x d + correction d / h = 0,     |sum of impulses| &lt;= maxForce h
 *   angle:  wB - wA + correction C / h = 0,           |sum of impulses| &lt;= maxTorque h
 *   d = xB + rB - xA - rA,   C = aB - aA - offset
 * </pre>
 *
 * The first is the velocity of point B seen from the frame of body A; in the arms it means that A
 * is taken hold of where point B is, {@code rA + d} from its centre. So force and counterforce lie
 * on one line however far the points are apart, and angular momentum is kept.
 *
 * <p>The angle is solved first, then the point as a 2 x 2 block (see {@link Arms}), its impulse
 * drawn back to the circle of its bound, as Coulomb friction in the plane asks. Warm starting keeps
 * the impulses, so that a load within the bound is carried without creep. There is nothing to
 * correct in position.
 */
public final class DriveKernel extends JointKernel {
  /** Length of a row's block. */
  public static final int FLOATS = Arms.SIZE + 14;

  private static final int OFFSET = 8;
  private static final int MAX_FORCE = 9;
  private static final int MAX_TORQUE = 10;
  private static final int CORRECTION = 11;
  // In and out.
  private static final int IMPULSE_X = 12;
  private static final int IMPULSE_Y = 13;
  private static final int TURN_IMPULSE = 14;
  // Own.
  private static final int M11 = 15;
  private static final int M12 = 16;
  private static final int M22 = 17;
  private static final int ANGLE_MASS = 18;
  private static final int BIAS_X = 19;
  private static final int BIAS_Y = 20;
  private static final int BIAS_TURN = 21;

  /** Enough for shares up to 0.999; each beyond the first few doubles the digits. */
  private static final int ROOT_ITERATIONS = 8;

  DriveKernel(int order) {
    super(order, IMPULSE_X, 3);
  }

  /**
   * Fills in what is wanted and how hard it is tried.
   *
   * @param offset angle of B minus that of A, rad
   * @param correction share of the error to be removed in a step, 0 to 1
   */
  public static void writeDrive(
      float[] f, int o, float offset, float maxForce, float maxTorque, float correction) {
    f[o + OFFSET] = offset;
    f[o + MAX_FORCE] = maxForce;
    f[o + MAX_TORQUE] = maxTorque;
    f[o + CORRECTION] = correction;
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
      float dx = Arms.gapX(f, o, bodies.pos, a, b);
      float dy = Arms.gapY(f, o, bodies.pos, a, b);
      f[o + Arms.RAX] += dx;
      f[o + Arms.RAY] += dy;
      Arms.invert(f, o, o + M11, m, a, b);
      float k = m[a + 1] + m[b + 1];
      f[o + ANGLE_MASS] = k > 0f ? 1f / k : 0f;
      float rate = share(f[o + CORRECTION], step) * step.invDt;
      f[o + BIAS_X] = rate * dx;
      f[o + BIAS_Y] = rate * dy;
      f[o + BIAS_TURN] = rate * (bodies.angle[slotB] - bodies.angle[slotA] - f[o + OFFSET]);
      f[o + IMPULSE_X] *= keep;
      f[o + IMPULSE_Y] *= keep;
      f[o + TURN_IMPULSE] *= keep;
      Arms.push(f, o, bodies.vel, m, a, b, f[o + IMPULSE_X], f[o + IMPULSE_Y], f[o + TURN_IMPULSE]);
    }
  }

  /**
   * Share of the error to be removed in this step, which may be one of n substeps: {@code 1 - (1 -
   * c)^(1/n)}, the root by Newton's iteration from above, where it converges monotonically.
   */
  private static float share(float ofStep, StepConfig step) {
    int n = Math.round(step.invDt / step.invStep);
    if (n == 1 || ofStep == 0f || ofStep == 1f) {
      return ofStep;
    }
    float left = 1f - ofStep;
    float root = 1f;
    for (int i = 0; i < ROOT_ITERATIONS; i++) {
      float power = 1f;
      for (int k = 1; k < n; k++) {
        power *= root;
      }
      root -= (power * root - left) / (n * power);
    }
    return 1f - root;
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
      float mostTurn = f[o + MAX_TORQUE] * step.dt;
      float oldTurn = f[o + TURN_IMPULSE];
      float turn = oldTurn - f[o + ANGLE_MASS] * (v[b + 2] - v[a + 2] + f[o + BIAS_TURN]);
      turn = Math.max(-mostTurn, Math.min(mostTurn, turn));
      f[o + TURN_IMPULSE] = turn;
      Arms.push(f, o, v, bodies.mass, a, b, 0f, 0f, turn - oldTurn);

      float cx = Arms.speedX(f, o, v, a, b) + f[o + BIAS_X];
      float cy = Arms.speedY(f, o, v, a, b) + f[o + BIAS_Y];
      float oldX = f[o + IMPULSE_X];
      float oldY = f[o + IMPULSE_Y];
      float px = oldX - (f[o + M11] * cx + f[o + M12] * cy);
      float py = oldY - (f[o + M12] * cx + f[o + M22] * cy);
      float most = f[o + MAX_FORCE] * step.dt;
      float size = (float) Math.sqrt(px * px + py * py);
      if (size > most) {
        px *= most / size;
        py *= most / size;
      }
      f[o + IMPULSE_X] = px;
      f[o + IMPULSE_Y] = py;
      Arms.push(f, o, v, bodies.mass, a, b, px - oldX, py - oldY, 0f);
    }
  }

  /** There is no error to correct: what is left is for the next step's force. */
  @Override
  public boolean solvePosition(
      JointRows rows, int from, int to, SolverBodies bodies, StepConfig step) {
    return true;
  }
}
