package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Impacts as a sequence: each contact that closes faster than a threshold is given at once the
 * impulse that makes it part with the share e of that speed, and this goes on over all contacts
 * until none closes so fast. So a blow runs through a chain of touching bodies as it does through
 * Newton's cradle, which impulses sought for all contacts at once, or in a single pass, do not
 * (Brogliato, "Nonsmooth Mechanics", 3rd ed. 2016, section 5.2; Smith, Kaufman, Vouga, Tamstorf,
 * Grinspun, "Reflections on simultaneous impact", SIGGRAPH 2012: sequential or Gauss-Seidel
 * impacts).
 *
 * <p>The two points of a face are one impact: {@code w = vn + e vn0 >= 0, P >= 0, w P = 0} for
 * both, the 2 x 2 problem of {@link ContactVelocityKernel}. Friction at an impact is bounded by its
 * normal impulse.
 *
 * <p>It works on the velocities that bodies have when the step begins, to which neither forces nor
 * kept impulses have been added; so what rests does not close.
 */
final class BounceKernel {
  /**
   * Sweeps over an island's contacts after which what still closes is left to the solver, without
   * restitution: with e = 1 a body between two walls of others could go on for long.
   */
  private static final int MOST_SWEEPS = 32;

  private BounceKernel() {}

  /**
   * Resolves the impacts of constraints {@code [from, to)}: of points that close within the step.
   *
   * @param threshold of speed, m/s
   * @param dt of the step, s
   */
  static void solve(
      ContactConstraints cc, SolverBodies bodies, int from, int to, float threshold, float dt) {
    boolean any = true;
    for (int sweep = 0; any && sweep < MOST_SWEEPS; sweep++) {
      any = false;
      for (int i = from; i < to; i++) {
        if (cc.vel[V_STRIDE * i + RESTITUTION] > 0f && cc.pointCount[i] > 0) {
          any |= impact(cc, bodies, i, threshold, dt);
        }
      }
    }
  }

  private static boolean impact(
      ContactConstraints cc, SolverBodies bodies, int i, float threshold, float dt) {
    float[] d = cc.vel;
    int c = V_STRIDE * i;
    int o1 = c + POINT;
    int o2 = o1 + POINT_STRIDE;
    boolean two = cc.pointCount[i] == 2;
    float e = d[c + RESTITUTION];
    float v1 = normalSpeed(cc, bodies, i, o1);
    float v2 = two ? normalSpeed(cc, bodies, i, o2) : 0f;
    boolean closes1 = v1 < -threshold && d[o1 + BIAS] + dt * v1 < 0f;
    boolean closes2 = two && v2 < -threshold && d[o2 + BIAS] + dt * v2 < 0f;
    if (!(closes1 || closes2)) {
      return false;
    }
    float q1 = closes1 ? (1f + e) * v1 : v1;
    float p1;
    float p2 = 0f;
    if (two) {
      float q2 = closes2 ? (1f + e) * v2 : v2;
      p1 = -(d[c + M11] * q1 + d[c + M12] * q2);
      p2 = -(d[c + M12] * q1 + d[c + M22] * q2);
      if (!(p1 >= 0f && p2 >= 0f)) {
        int k = K_STRIDE * i;
        p1 = Math.max(0f, -q1 / cc.block[k + K11]);
        p2 = 0f;
        if (!(cc.block[k + K12] * p1 + q2 >= 0f)) {
          p1 = 0f;
          p2 = Math.max(0f, -q2 / cc.block[k + K22]);
        }
      }
    } else {
      p1 = -d[c + M11] * q1;
    }
    apply(cc, bodies, i, 0, p1);
    if (two) {
      apply(cc, bodies, i, 1, p2);
    }
    return p1 > 0f || p2 > 0f;
  }

  private static float normalSpeed(ContactConstraints cc, SolverBodies bodies, int i, int o) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    int c = V_STRIDE * i;
    int a = SolverBodies.STRIDE * cc.bodyA[i];
    int b = SolverBodies.STRIDE * cc.bodyB[i];
    return d[c + NX] * (v[b] - v[a])
        + d[c + NY] * (v[b + 1] - v[a + 1])
        + v[b + 2] * d[o + RN_B]
        - v[a + 2] * d[o + RN_A];
  }

  /** Applies a normal impulse to a point, then the friction that it allows. */
  private static void apply(
      ContactConstraints cc, SolverBodies bodies, int i, int point, float normal) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    int c = V_STRIDE * i;
    int o = c + POINT + POINT_STRIDE * point;
    int a = SolverBodies.STRIDE * cc.bodyA[i];
    int b = SolverBodies.STRIDE * cc.bodyB[i];
    push(d, c, v, a, b, normal * d[c + NX], normal * d[c + NY], d[o + RN_A], d[o + RN_B], normal);
    float tx = d[c + NY];
    float ty = -d[c + NX];
    float vt =
        tx * (v[b] - v[a])
            + ty * (v[b + 1] - v[a + 1])
            + v[b + 2] * d[o + RT_B]
            - v[a + 2] * d[o + RT_A]
            - d[c + TANGENT_SPEED];
    float most = d[c + FRICTION] * normal;
    float tangent = Math.max(-most, Math.min(most, -d[o + TANGENT_MASS] * vt));
    push(d, c, v, a, b, tangent * tx, tangent * ty, d[o + RT_A], d[o + RT_B], tangent);
    cc.sub[S_STRIDE * i + S_NORMAL_SUM + point] += normal;
    cc.sub[S_STRIDE * i + S_TANGENT_SUM] += tangent;
  }

  private static void push(
      float[] d,
      int c,
      float[] v,
      int a,
      int b,
      float px,
      float py,
      float crossA,
      float crossB,
      float size) {
    v[a] -= d[c + INV_MASS_A] * px;
    v[a + 1] -= d[c + INV_MASS_A] * py;
    v[a + 2] -= d[c + INV_I_A] * size * crossA;
    v[b] += d[c + INV_MASS_B] * px;
    v[b + 1] += d[c + INV_MASS_B] * py;
    v[b + 2] += d[c + INV_I_B] * size * crossB;
  }
}
