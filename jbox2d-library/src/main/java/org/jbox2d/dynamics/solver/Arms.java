package org.jbox2d.dynamics.solver;

/**
 * What constraints between a point of one body and a point of another have in common: the first
 * {@link #SIZE} floats of their rows, the arms from the centres of mass to the points.
 *
 * <p>With {@code d = xB + rB - xA - rA} from one point to the other,
 *
 * <pre>
 *   ddot = vB + wB x rB - vA - wA x rA
 *   K    = J M^-1 J^T = (mA + mB) 1 + iA rA' rA'^T + iB rB' rB'^T,   r' = (-ry, rx)
 *   det K = (mA + mB)^2 + (mA + mB) (iA rA^2 + iB rB^2) + iA iB (rA x rB)^2
 * </pre>
 *
 * (m, i: inverse mass and inertia; Catto, "Modeling and solving constraints", GDC 2009.) The
 * determinant is written as a sum of terms that are not negative, so that nothing cancels however
 * long an arm is.
 *
 * <p><b>The bend of the path.</b> A step moves bodies along straight lines and turns them, so a
 * constraint whose velocity {@code J v} vanishes at the start of a step is violated at its end by
 * {@code h^2/2 Jdot v}: a pendulum leaves its circle along the tangent. Pulling it back by position
 * correction alone turns the path without turning the velocity, which then loses the share {@code 1
 * - cos(w h)} in each step, 69 % of a swing's energy in 20 s at 60 Hz. Hard constraints here ask
 * for {@code J v + h/2 Jdot v = 0} instead: impulses along {@code J} of the start that make {@code
 * C} vanish at the end. That is the SHAKE method (Ryckaert, Ciccotti, Berendsen 1977), which is
 * symplectic (Leimkuhler, Skeel 1994), so energy does not drift. The term depends on the velocity
 * and is computed anew in each iteration: from the velocities before the impulses it would be off
 * by one order, and a swing would lose 5 % in 20 s.
 */
public final class Arms {
  /** Length of the block. */
  public static final int SIZE = 8;

  // In: points relative to the centre of mass, in the body's frame.
  private static final int LOCAL_AX = 0;
  private static final int LOCAL_AY = 1;
  private static final int LOCAL_BX = 2;
  private static final int LOCAL_BY = 3;
  // Own: the same in world directions.
  static final int RAX = 4;
  static final int RAY = 5;
  static final int RBX = 6;
  static final int RBY = 7;

  /** Turn up to which {@link SolverBodies#turn} serves for a correction, rad: error 4e-5 rad. */
  private static final float SMALL_TURN = 0.05f;

  /** A quarter turn in a step, the most that a body turns unless the settings are changed, rad. */
  private static final float LARGEST_TURN = 0.5f * (float) Math.PI;

  /**
   * Turn in a step up to which Coriolis forces are followed, rad: 24 rad/s at 60 steps a second.
   * They couple the directions along and across an axis, and with larger turns the iterations would
   * run away.
   */
  private static final float LARGEST_SWING = 0.4f;

  /**
   * Gap of two points up to which the bend of their path is followed, in linear slops. Followed, it
   * leaves gaps far below one slop. Where gaps grow all the same, the constraints contradict each
   * other: planks of a bridge that is pulled straight between its piers cannot go on turning, and
   * impulses that ask for it would grow from step to step and throw them about. There the points
   * are led along the tangent and drawn together by position correction, which only takes energy.
   */
  private static final float BENT_SLOPS = 3f;

  /**
   * By what factor, and then by how many linear slops, the bend of a path in a step may come to
   * exceed that of the velocities at its start. The way is far more than forces bring about in a
   * step, and what a motor does that turns a body up in one; the factor leaves a pinned rod that
   * turns by more than a radian in a step the path to the post it strikes. With twice of either,
   * two small bodies that are hinged far outside of both gain energy.
   */
  private static final float BEND_RISE = 1.25f;

  /** See {@link #BEND_RISE}. */
  private static final float NEW_BEND_SLOPS = 0.5f;

  /**
   * By what factor the stretch of a length may come to exceed that of the velocities at its start,
   * which belong to the middle of the step before: less than for a bend, since small bodies far
   * inside of it gain energy.
   */
  private static final float STRETCH_RISE = 1.1f;

  private Arms() {}

  /**
   * Bound of what {@link #bendX} and {@link #bendY} may come to in the iterations of a step, m/s; 0
   * where the bend is not to be followed. The bend grows with the square of a spin: on a light body
   * that is wedged between others, the impulse that a bend asks for may bring about a spin whose
   * bend is greater than the last, and each iteration would ask for more. Within a bound they
   * cannot run away; see {@link #mostStretch}. The arms must be turned.
   */
  static float mostBend(float[] f, int o, SolverBodies bodies, int a, int b, StepConfig step) {
    float gx = gapX(f, o, bodies.pos, a, b);
    float gy = gapY(f, o, bodies.pos, a, b);
    float most = BENT_SLOPS * step.linearSlop;
    if (gx * gx + gy * gy > most * most) {
      return 0f;
    }
    float bx = bendX(f, o, bodies.vel, a, b, step.dt, step.invDt);
    float by = bendY(f, o, bodies.vel, a, b, step.dt, step.invDt);
    float atStart = (float) Math.sqrt(bx * bx + by * by);
    return mostBend(atStart, step);
  }

  /** The same for one direction, of the size of its bend at the start of the step. */
  static float mostBend(float atStart, StepConfig step) {
    return BEND_RISE * atStart + NEW_BEND_SLOPS * step.linearSlop * step.invDt;
  }

  /** Whether the bend of a path is followed across a gap; see {@link #BENT_SLOPS}. */
  static boolean isBent(float gap, StepConfig step) {
    return Math.abs(gap) <= BENT_SLOPS * step.linearSlop;
  }

  /** Fills in the block: points relative to the centres of mass, in the bodies' frames, m. */
  public static void write(float[] f, int o, float ax, float ay, float bx, float by) {
    f[o + LOCAL_AX] = ax;
    f[o + LOCAL_AY] = ay;
    f[o + LOCAL_BX] = bx;
    f[o + LOCAL_BY] = by;
  }

  /** Returns {@code r w^2} of the arm at {@code o}: A's, or two further B's. */
  static float bend(float[] f, int o, float w) {
    float x = f[o + LOCAL_AX];
    float y = f[o + LOCAL_AY];
    return w * w * (float) Math.sqrt(x * x + y * y);
  }

  /** Turns the arms to the bodies' angles. */
  static void turn(float[] f, int o, float[] x, int a, int b) {
    f[o + RAX] = x[a + 3] * f[o + LOCAL_AX] - x[a + 2] * f[o + LOCAL_AY];
    f[o + RAY] = x[a + 2] * f[o + LOCAL_AX] + x[a + 3] * f[o + LOCAL_AY];
    f[o + RBX] = x[b + 3] * f[o + LOCAL_BX] - x[b + 2] * f[o + LOCAL_BY];
    f[o + RBY] = x[b + 2] * f[o + LOCAL_BX] + x[b + 3] * f[o + LOCAL_BY];
  }

  /** From point A to point B along x; arms must be turned. */
  static float gapX(float[] f, int o, float[] x, int a, int b) {
    return x[b] + f[o + RBX] - x[a] - f[o + RAX];
  }

  /** See {@link #gapX}. */
  static float gapY(float[] f, int o, float[] x, int a, int b) {
    return x[b + 1] + f[o + RBY] - x[a + 1] - f[o + RAY];
  }

  /** Velocity of point B seen from point A, along x. */
  static float speedX(float[] f, int o, float[] v, int a, int b) {
    return v[b] - v[b + 2] * f[o + RBY] - v[a] + v[a + 2] * f[o + RAY];
  }

  /** See {@link #speedX}. */
  static float speedY(float[] f, int o, float[] v, int a, int b) {
    return v[b + 1] + v[b + 2] * f[o + RBX] - v[a + 1] - v[a + 2] * f[o + RAX];
  }

  /**
   * What the gap gains in a step above {@code h ddot} because the arms turn by t = w h, over h,
   * along x: {@code (R(t) - 1) r - t r' = -(1 - cos t) r - (t - sin t) r'} of B less that of A.
   *
   * @param h step length, s
   * @param invH 1 / h
   */
  static float bendX(float[] f, int o, float[] v, int a, int b, float h, float invH) {
    float ta = turn(v[a + 2] * h);
    float tb = turn(v[b + 2] * h);
    return invH
        * (versine(ta) * f[o + RAX]
            - lag(ta) * f[o + RAY]
            - versine(tb) * f[o + RBX]
            + lag(tb) * f[o + RBY]);
  }

  /** See {@link #bendX}. */
  static float bendY(float[] f, int o, float[] v, int a, int b, float h, float invH) {
    float ta = turn(v[a + 2] * h);
    float tb = turn(v[b + 2] * h);
    return invH
        * (versine(ta) * f[o + RAY]
            + lag(ta) * f[o + RAX]
            - versine(tb) * f[o + RBY]
            - lag(tb) * f[o + RBX]);
  }

  /**
   * The same along a direction u that turns with A by t = w h. With D the gap d at the end of the
   * step, where {@code u(t) = cos t u + sin t u'}, {@code u(t) . D} is above {@code u . (d + h
   * ddot) + t u' . d} by
   *
   * <pre>  h u . bend + sin t u' . (D - d) - (1 - cos t) u . D - (t - sin t) u' . d</pre>
   *
   * <p>To second order those are the Coriolis and centrifugal terms of d seen in A's frame; but an
   * energy that is to last needs the third as well.
   *
   * @param along u . d at the start of the step, m
   * @param across u' . d, {@code u' = (-uy, ux)}, m
   */
  static float bendAlong(
      float[] f,
      int o,
      float[] v,
      int a,
      int b,
      float ux,
      float uy,
      float along,
      float across,
      StepConfig step) {
    float h = step.dt;
    float invH = step.invDt;
    float t = Math.max(-LARGEST_SWING, Math.min(LARGEST_SWING, v[a + 2] * h));
    float bendX = bendX(f, o, v, a, b, h, invH);
    float bendY = bendY(f, o, v, a, b, h, invH);
    float wayX = speedX(f, o, v, a, b) + bendX;
    float wayY = speedY(f, o, v, a, b) + bendY;
    return ux * bendX
        + uy * bendY
        + (t - lag(t)) * (ux * wayY - uy * wayX)
        - versine(t) * (invH * along + ux * wayX + uy * wayY)
        - lag(t) * invH * across;
  }

  /**
   * The way of one arm above {@code h w x r} against a direction u, when it turns by t: {@code (1 -
   * cos t) u . r + (t - sin t) u . r'}.
   *
   * @param along u . r
   * @param across u x r, which is u . r' for r' = (-ry, rx) with the sign turned
   */
  static float bendOne(float t, float along, float across) {
    float bounded = turn(t);
    return versine(bounded) * along - lag(bounded) * across;
  }

  /** Turns above a quarter count as a quarter, so that no spin, however fast, makes it run away. */
  static float turn(float t) {
    if (t > LARGEST_TURN) {
      return LARGEST_TURN;
    }
    return t < -LARGEST_TURN ? -LARGEST_TURN : t;
  }

  /** {@code 1 - cos t} by its Taylor series; 2 % short at a quarter turn. */
  static float versine(float t) {
    return t * t * (0.5f - t * t * (1f / 24f));
  }

  /** {@code t - sin t} by its Taylor series; 1 % short at a quarter turn. */
  static float lag(float t) {
    return t * t * t * (1f / 6f - t * t * (1f / 120f));
  }

  /**
   * What the length {@code |d|} of the gap gains in a step above {@code h u . ddot}, over h: the
   * turning of the arms, and {@link #bow}.
   *
   * @param invLength 1 / |d|
   */
  static float stretch(
      float[] f, int o, float[] v, int a, int b, float ux, float uy, float invLength, float h) {
    float invH = 1f / h;
    float bendX = bendX(f, o, v, a, b, h, invH);
    float bendY = bendY(f, o, v, a, b, h, invH);
    float wayX = speedX(f, o, v, a, b) + bendX;
    float wayY = speedY(f, o, v, a, b) + bendY;
    return ux * bendX
        + uy * bendY
        + bow(ux * wayX + uy * wayY, ux * wayY - uy * wayX, invLength, h);
  }

  /**
   * Bound of what {@link #stretch} may come to in the iterations of a step. The impulse along a gap
   * may turn a light body so fast that the gap's stretch changes by more than the impulse took
   * away: then each iteration would ask for a greater one than the last. Within a bound they cannot
   * run away: a tenth more than what the velocities at the start of the step come to, and a slop in
   * the step for what it brings; position correction does the rest. Where the length is far off
   * already, see {@link #BENT_SLOPS}.
   *
   * @param atStart the stretch by the velocities at the start of the step, m/s
   * @param error by how much the length is off, m
   */
  static float mostStretch(float atStart, float error, StepConfig step) {
    return Math.abs(error) <= BENT_SLOPS * step.linearSlop
        ? STRETCH_RISE * Math.abs(atStart) + step.linearSlop * step.invDt
        : 0f;
  }

  /**
   * {@code x} within {@code [-most, most]}. It hardly ever is beyond, and a processor that guesses
   * so goes on with x at once, where minimum and maximum would make it wait.
   */
  static float bounded(float x, float most) {
    if (x > most) {
      return most;
    }
    return x < -most ? -most : x;
  }

  /**
   * A way {@code s = h v} across makes a length L, which the way along has made {@code L' = L + h
   * u}, longer by {@code sqrt(L'^2 + s^2) - L' = s^2 / (L' + sqrt(L'^2 + s^2))}; here never by more
   * than s / 2, so that the iterations of several such constraints do not drive each other up.
   *
   * @param along u, m/s
   * @param across v, m/s
   */
  static float bow(float along, float across, float invLength, float h) {
    float speed = Math.abs(across);
    float scale = h * invLength;
    float length = Math.max(0f, 1f + scale * along);
    float way = scale * speed;
    float end = length + (float) Math.sqrt(length * length + way * way);
    return speed * (way < 0.5f * end ? way / end : 0.5f);
  }

  /** Applies an impulse to point B and its opposite to point A. */
  static void push(
      float[] f, int o, float[] v, float[] m, int a, int b, float px, float py, float turn) {
    v[a] -= m[a] * px;
    v[a + 1] -= m[a] * py;
    v[a + 2] -= m[a + 1] * (f[o + RAX] * py - f[o + RAY] * px + turn);
    v[b] += m[b] * px;
    v[b + 1] += m[b] * py;
    v[b + 2] += m[b + 1] * (f[o + RBX] * py - f[o + RBY] * px + turn);
  }

  /** Inverse mass of the gap's length: {@code u^T K u}. */
  static float along(float[] f, int o, float[] m, int a, int b, float ux, float uy) {
    float ca = f[o + RAX] * uy - f[o + RAY] * ux;
    float cb = f[o + RBX] * uy - f[o + RBY] * ux;
    return m[a] + m[b] + m[a + 1] * ca * ca + m[b + 1] * cb * cb;
  }

  /** Writes {@code K^-1} as three floats, 11, 12, 22, to {@code at}; zeros if nothing can move. */
  static void invert(float[] f, int o, int at, float[] m, int a, int b) {
    float rax = f[o + RAX];
    float ray = f[o + RAY];
    float rbx = f[o + RBX];
    float rby = f[o + RBY];
    float mass = m[a] + m[b];
    float ia = m[a + 1];
    float ib = m[b + 1];
    float cross = rax * rby - ray * rbx;
    float arms = ia * (rax * rax + ray * ray) + ib * (rbx * rbx + rby * rby);
    float det = mass * (mass + arms) + ia * ib * cross * cross;
    float inv = det > 0f ? 1f / det : 0f;
    f[at] = inv * (mass + ia * rax * rax + ib * rbx * rbx);
    f[at + 1] = inv * (ia * rax * ray + ib * rbx * rby);
    f[at + 2] = inv * (mass + ia * ray * ray + ib * rby * rby);
  }

  /** Share of an error of the given size that one correction may remove. */
  static float share(float error, float most) {
    return error > most ? most / error : 1f;
  }

  /** Moves and turns a body by a correction. */
  static void move(SolverBodies bodies, int slot, float dx, float dy, float da) {
    int o = SolverBodies.STRIDE * slot;
    bodies.pos[o] += dx;
    bodies.pos[o + 1] += dy;
    if (Math.abs(da) > SMALL_TURN) {
      bodies.setAngle(slot, bodies.angle[slot] + da);
    } else if (da != 0f) {
      bodies.turn(slot, da);
    }
  }

  /** {@link #push} for positions. */
  static void shift(
      float[] f, int o, SolverBodies bodies, int slotA, int slotB, float px, float py, float turn) {
    float[] m = bodies.mass;
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    float turnA = f[o + RAX] * py - f[o + RAY] * px + turn;
    float turnB = f[o + RBX] * py - f[o + RBY] * px + turn;
    move(bodies, slotA, -m[a] * px, -m[a] * py, -m[a + 1] * turnA);
    move(bodies, slotB, m[b] * px, m[b] * py, m[b + 1] * turnB);
  }

  /**
   * Share of a correction that turns neither body by more than {@code most}. Newton's step is exact
   * in the places and first order in the angles: the turn is what must be kept small, not the way.
   */
  static float turnShare(
      float[] f, int o, float[] m, int a, int b, float px, float py, float turn, float most) {
    float turnA = m[a + 1] * (f[o + RAX] * py - f[o + RAY] * px + turn);
    float turnB = m[b + 1] * (f[o + RBX] * py - f[o + RBY] * px + turn);
    return share(Math.max(Math.abs(turnA), Math.abs(turnB)), most);
  }

  /**
   * One Newton step towards a gap of a given length.
   *
   * @param slack whether a shorter gap is no error
   * @return the error before it, m
   */
  static float reach(
      float[] f,
      int o,
      SolverBodies bodies,
      int slotA,
      int slotB,
      float length,
      boolean slack,
      float most) {
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    turn(f, o, bodies.pos, a, b);
    float dx = gapX(f, o, bodies.pos, a, b);
    float dy = gapY(f, o, bodies.pos, a, b);
    float now = (float) Math.sqrt(dx * dx + dy * dy);
    float c = now - length;
    if (slack && c <= 0f) {
      return 0f;
    }
    float ux = now > 0f ? dx / now : 1f;
    float uy = now > 0f ? dy / now : 0f;
    float k = along(f, o, bodies.mass, a, b, ux, uy);
    float p = k > 0f ? -share(Math.abs(c), most) * c / k : 0f;
    shift(f, o, bodies, slotA, slotB, p * ux, p * uy, 0f);
    return Math.abs(c);
  }
}
