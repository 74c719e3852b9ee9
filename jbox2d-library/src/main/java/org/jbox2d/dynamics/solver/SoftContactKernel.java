package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * One pass of a substep over the contacts, in two kinds. The <i>push</i> makes overlap go away by a
 * soft constraint ({@link Softness}) of bounded speed; the bodies then move; the <i>relax</i> pass
 * asks for no more than rest, and so takes back the speed that pushing gave, before it becomes
 * energy (Catto, "Solver2D", 2024: soft step; the split of velocities for motion and for momentum
 * is Guendelman, Bridson and Fedkiw's, SIGGRAPH 2003).
 *
 * <p>Points may approach each other until they are where they rest, one slop deep: a point that is
 * not there yet is held back by no more than would take it further, {@code vn + s / h >= 0}. So
 * what slides over the seam between two tiles is not stopped by the next one's end, which it only
 * comes near to.
 *
 * <p>Normals and arms are those of the start of the step; the separation of a point follows the
 * bodies' ways since then,
 *
 * <pre>  s = s0 + n . (dB - dA) + tB (rB x n) - tA (rA x n) - (tB^2 rB . n - tA^2 rA . n) / 2</pre>
 *
 * t the turns, to second order for the corners of polygons. A circle's lowest point stays below its
 * centre, so for it that of its centre is meant, and between circles turning changes nothing.
 *
 * <p>The two normals of a face are solved at once as in {@link ContactVelocityKernel}; softness
 * scales the inverse of the 2 x 2 matrix as it does a single effective mass. Friction of both
 * points acts along one line, so it is one row, bounded by the sum of the normal impulses; its
 * impulse is kept at the first point.
 */
final class SoftContactKernel {
  /** Of contacts between bodies that move, and with those that do not. */
  private final Softness dynamic = new Softness();

  private final Softness still = new Softness();
  private float mostPush;
  private float settledDepth;
  private float invH;

  /** What is this many slops deeper than at rest when the pass begins has not settled. */
  private static final float SETTLED_SLOPS = 2f;

  /** Least separation met in the last push, m. */
  private float least;

  /** Largest speed at which a point closed faster than it may, as the last push met it, m/s. */
  float closing;

  /** Largest normal speed that the last relax pass took away, m/s. */
  float changed;

  /**
   * Sets what the passes of a substep share.
   *
   * @param h substep, s
   * @param frequency of a contact between bodies that move, Hz; twice that with one that does not
   * @param mostRate largest share of overlap that is removed in a second, 1/s
   * @param mostPush largest speed at which overlap is removed, m/s
   */
  void set(
      float h, float frequency, float dampingRatio, float mostRate, float mostPush, float slop) {
    dynamic.set(frequency, dampingRatio, h, mostRate);
    still.set(2f * frequency, dampingRatio, h, mostRate);
    this.mostPush = mostPush;
    settledDepth = SETTLED_SLOPS * slop;
    invH = 1f / h;
  }

  /** Whether the last push met nothing deeper than is accepted at rest. */
  boolean settled() {
    return least >= -settledDepth;
  }

  /** Least separation that the last push met, m. */
  float least() {
    return least;
  }

  /**
   * Pushes constraints {@code [from, to)}: friction, then the normals.
   *
   * <p>While both points push, they hold the angle between the bodies; so friction comes with the
   * change of the normal impulses that leaves the normal speeds as they are. Alone it would turn
   * the bodies until its points stand still, and be taken for enough.
   *
   * <p>All of a contact is solved here, in one loop: calls of their own for one point and for two
   * would be too large for the JIT to inline, and cost a pyramid or a heap a twentieth of its step.
   */
  void push(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    float[] x = bodies.delta;
    float[] sub = cc.sub;
    float deepest = 0f;
    float fastest = 0f;
    for (int i = from; i < to; i++) {
      int n = cc.pointCount[i];
      if (n == 0) {
        continue;
      }
      // Stage 1: what one point and two have in common
      int c = V_STRIDE * i;
      int o1 = c + POINT;
      int so = S_STRIDE * i;
      int oA = SolverBodies.STRIDE * cc.bodyA[i];
      int oB = SolverBodies.STRIDE * cc.bodyB[i];
      float mA = d[c + INV_MASS_A];
      float iA = d[c + INV_I_A];
      float mB = d[c + INV_MASS_B];
      float iB = d[c + INV_I_B];
      Softness soft = mA == 0f || mB == 0f ? still : dynamic;
      float nx = d[c + NX];
      float ny = d[c + NY];
      float vAx = v[oA];
      float vAy = v[oA + 1];
      float wA = v[oA + 2];
      float vBx = v[oB];
      float vBy = v[oB + 1];
      float wB = v[oB + 2];
      float rn1A = d[o1 + RN_A];
      float rn1B = d[o1 + RN_B];
      float a1 = d[o1 + NORMAL_IMPULSE];

      // Stage 2: where the first point is now
      float turnA = x[oA + 2];
      float turnB = x[oB + 2];
      float way = (x[oB] - x[oA]) * nx + (x[oB + 1] - x[oA + 1]) * ny;
      float rtA = d[o1 + RT_A];
      float rtB = d[o1 + RT_B];
      float curveA = n == 2 ? 0.5f * rtA : sub[so + S_CURVE_A];
      float curveB = n == 2 ? 0.5f * rtB : sub[so + S_CURVE_B];
      float s1 = separation(d, o1, way, turnA, turnB, curveA, curveB);
      sub[so + S_SEPARATION] = s1;
      deepest = s1 < deepest ? s1 : deepest;

      // Stage 3: friction along t = (ny, -nx)
      float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
      float oldT = d[o1 + TANGENT_IMPULSE];
      if (n == 1) {
        float newT = clamp(oldT - d[o1 + TANGENT_MASS] * vt, d[c + FRICTION] * a1);
        d[o1 + TANGENT_IMPULSE] = newT;
        float jt = newT - oldT;
        vAx -= mA * jt * ny;
        vAy += mA * jt * nx;
        wA -= iA * jt * rtA;
        vBx += mB * jt * ny;
        vBy -= mB * jt * nx;
        wB += iB * jt * rtB;

        // Stage 4 of one point: the normal
        float vn = (vBx - vAx) * nx + (vBy - vAy) * ny + wB * rn1B - wA * rn1A;
        float e = vn + bias(s1, soft.rate);
        float newN = positive(a1 - soft.massScale * d[c + M11] * e - soft.impulseScale * a1);
        d[o1 + NORMAL_IMPULSE] = newN;
        float jn = newN - a1;
        put(v, oA, vAx - mA * jn * nx, vAy - mA * jn * ny, wA - iA * jn * rn1A);
        put(v, oB, vBx + mB * jn * nx, vBy + mB * jn * ny, wB + iB * jn * rn1B);
        fastest = e < fastest ? e : fastest;
        continue;
      }
      int o2 = o1 + POINT_STRIDE;
      float rn2A = d[o2 + RN_A];
      float rn2B = d[o2 + RN_B];
      float a2 = d[o2 + NORMAL_IMPULSE];
      float s2 = separation(d, o2, way, turnA, turnB, 0.5f * d[o2 + RT_A], 0.5f * d[o2 + RT_B]);
      sub[so + S_SEPARATION + 1] = s2;
      deepest = s2 < deepest ? s2 : deepest;
      float limit = d[c + FRICTION] * (a1 + a2);
      float newT = clamp(oldT - sub[so + S_HELD_TANGENT_MASS] * vt, limit);
      float jt = newT - oldT;
      float j1 = sub[so + S_HOLD] * jt;
      float j2 = sub[so + S_HOLD + 1] * jt;
      if (!(a1 + j1 >= 0f && a2 + j2 >= 0f)) {
        newT = clamp(oldT - d[o1 + TANGENT_MASS] * vt, limit);
        jt = newT - oldT;
        j1 = 0f;
        j2 = 0f;
      }
      d[o1 + TANGENT_IMPULSE] = newT;
      a1 += j1;
      a2 += j2;
      float px = jt * ny + (j1 + j2) * nx;
      float py = (j1 + j2) * ny - jt * nx;
      vAx -= mA * px;
      vAy -= mA * py;
      wA -= iA * (jt * rtA + j1 * rn1A + j2 * rn2A);
      vBx += mB * px;
      vBy += mB * py;
      wB += iB * (jt * rtB + j1 * rn1B + j2 * rn2B);

      // Stage 4 of two: e = vn + bias, x = (1 - impulseScale) a - massScale K^-1 e if both push
      float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
      float e1 = soft.massScale * (along + wB * rn1B - wA * rn1A + bias(s1, soft.rate));
      float e2 = soft.massScale * (along + wB * rn2B - wA * rn2A + bias(s2, soft.rate));
      float keep = 1f - soft.impulseScale;
      float x1 = keep * a1 - (d[c + M11] * e1 + d[c + M12] * e2);
      float x2 = keep * a2 - (d[c + M12] * e1 + d[c + M22] * e2);
      if (!(x1 >= 0f && x2 >= 0f)) {
        pushAtMostOne(cc, i, a1, a2, x1, x2);
        x1 = d[o1 + NORMAL_IMPULSE];
        x2 = d[o2 + NORMAL_IMPULSE];
      }
      d[o1 + NORMAL_IMPULSE] = x1;
      d[o2 + NORMAL_IMPULSE] = x2;
      j1 = x1 - a1;
      j2 = x2 - a2;
      float j = j1 + j2;
      put(v, oA, vAx - mA * j * nx, vAy - mA * j * ny, wA - iA * (j1 * rn1A + j2 * rn2A));
      put(v, oB, vBx + mB * j * nx, vBy + mB * j * ny, wB + iB * (j1 * rn1B + j2 * rn2B));
      float e = e1 < e2 ? e1 : e2;
      fastest = e < fastest ? e : fastest;
    }
    closing = -fastest;
    least = deepest;
  }

  /**
   * Finds the impulses where not both of two points push. If the inverse of the matrix K would have
   * them be (x1, x2), the problem is {@code w = K x - K (x1, x2)}.
   */
  private static void pushAtMostOne(
      ContactConstraints cc, int i, float a1, float a2, float x1, float x2) {
    float[] block = cc.block;
    int ko = K_STRIDE * i;
    int o1 = V_STRIDE * i + POINT;
    float k12 = block[ko + K12];
    float q1 = block[ko + K11] * x1 + k12 * x2;
    float q2 = k12 * x1 + block[ko + K22] * x2;
    ContactVelocityKernel.pushAtMostOne(cc.vel, o1, o1 + POINT_STRIDE, a1, a2, block, ko, q1, q2);
  }

  /** Speed that a push aims at where the separation is {@code s}, its sign turned. */
  private float bias(float s, float rate) {
    if (s > 0f) {
      return s * invH;
    }
    float bias = rate * s;
    return bias < -mostPush ? -mostPush : bias;
  }

  /**
   * Relaxes constraints {@code [from, to)} and adds their impulses up: as {@link #push}, but the
   * normals first, as friction is bounded by the normal impulse without what pushing added.
   *
   * @param summed whether to add them up
   * @param again whether this substep's impulses have been added up before, so that only what
   *     changes is added
   */
  void relax(
      ContactConstraints cc, SolverBodies bodies, int from, int to, boolean summed, boolean again) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    float[] sub = cc.sub;
    float fastest = 0f;
    for (int i = from; i < to; i++) {
      int n = cc.pointCount[i];
      if (n == 0) {
        continue;
      }
      // Stage 1: what one point and two have in common
      int c = V_STRIDE * i;
      int o1 = c + POINT;
      int so = S_STRIDE * i;
      int oA = SolverBodies.STRIDE * cc.bodyA[i];
      int oB = SolverBodies.STRIDE * cc.bodyB[i];
      float mA = d[c + INV_MASS_A];
      float iA = d[c + INV_I_A];
      float mB = d[c + INV_MASS_B];
      float iB = d[c + INV_I_B];
      float nx = d[c + NX];
      float ny = d[c + NY];
      float vAx = v[oA];
      float vAy = v[oA + 1];
      float wA = v[oA + 2];
      float vBx = v[oB];
      float vBy = v[oB + 1];
      float wB = v[oB + 2];
      float rn1A = d[o1 + RN_A];
      float rn1B = d[o1 + RN_B];
      float rtA = d[o1 + RT_A];
      float rtB = d[o1 + RT_B];
      float a1 = d[o1 + NORMAL_IMPULSE];
      float oldT = d[o1 + TANGENT_IMPULSE];
      float bias1 = sub[so + S_SEPARATION] > 0f ? room(cc, bodies, i, oA, oB, 0) : 0f;
      float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
      float e1 = along + wB * rn1B - wA * rn1A + bias1;
      if (n == 1) {
        // Stage 2 of one point: the normal
        float newN = positive(a1 - d[c + M11] * e1);
        d[o1 + NORMAL_IMPULSE] = newN;
        float jn = newN - a1;
        vAx -= mA * jn * nx;
        vAy -= mA * jn * ny;
        wA -= iA * jn * rn1A;
        vBx += mB * jn * nx;
        vBy += mB * jn * ny;
        wB += iB * jn * rn1B;

        // Stage 3: friction along t = (ny, -nx)
        float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
        float newT = clamp(oldT - d[o1 + TANGENT_MASS] * vt, d[c + FRICTION] * newN);
        d[o1 + TANGENT_IMPULSE] = newT;
        float jt = newT - oldT;
        put(v, oA, vAx - mA * jt * ny, vAy + mA * jt * nx, wA - iA * jt * rtA);
        put(v, oB, vBx + mB * jt * ny, vBy - mB * jt * nx, wB + iB * jt * rtB);
        if (summed) {
          sub[so + S_NORMAL_SUM] += newN - (again ? a1 : 0f);
          sub[so + S_TANGENT_SUM] += newT - (again ? oldT : 0f);
        }
        float e = newN == a1 ? 0f : Math.abs(e1);
        fastest = e > fastest ? e : fastest;
        continue;
      }
      // Stage 2 of two: the normals
      int o2 = o1 + POINT_STRIDE;
      float rn2A = d[o2 + RN_A];
      float rn2B = d[o2 + RN_B];
      float a2 = d[o2 + NORMAL_IMPULSE];
      float bias2 = sub[so + S_SEPARATION + 1] > 0f ? room(cc, bodies, i, oA, oB, 1) : 0f;
      float e2 = along + wB * rn2B - wA * rn2A + bias2;
      float x1 = a1 - (d[c + M11] * e1 + d[c + M12] * e2);
      float x2 = a2 - (d[c + M12] * e1 + d[c + M22] * e2);
      if (!(x1 >= 0f && x2 >= 0f)) {
        pushAtMostOne(cc, i, a1, a2, x1, x2);
        x1 = d[o1 + NORMAL_IMPULSE];
        x2 = d[o2 + NORMAL_IMPULSE];
      }
      float j1 = x1 - a1;
      float j2 = x2 - a2;
      float j = j1 + j2;
      vAx -= mA * j * nx;
      vAy -= mA * j * ny;
      wA -= iA * (j1 * rn1A + j2 * rn2A);
      vBx += mB * j * nx;
      vBy += mB * j * ny;
      wB += iB * (j1 * rn1B + j2 * rn2B);

      // Stage 3
      float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
      float limit = d[c + FRICTION] * (x1 + x2);
      float newT = clamp(oldT - sub[so + S_HELD_TANGENT_MASS] * vt, limit);
      float jt = newT - oldT;
      j1 = sub[so + S_HOLD] * jt;
      j2 = sub[so + S_HOLD + 1] * jt;
      if (!(x1 + j1 >= 0f && x2 + j2 >= 0f)) {
        newT = clamp(oldT - d[o1 + TANGENT_MASS] * vt, limit);
        jt = newT - oldT;
        j1 = 0f;
        j2 = 0f;
      }
      d[o1 + TANGENT_IMPULSE] = newT;
      d[o1 + NORMAL_IMPULSE] = x1 + j1;
      d[o2 + NORMAL_IMPULSE] = x2 + j2;
      float px = jt * ny + (j1 + j2) * nx;
      float py = (j1 + j2) * ny - jt * nx;
      put(v, oA, vAx - mA * px, vAy - mA * py, wA - iA * (jt * rtA + j1 * rn1A + j2 * rn2A));
      put(v, oB, vBx + mB * px, vBy + mB * py, wB + iB * (jt * rtB + j1 * rn1B + j2 * rn2B));
      if (summed) {
        sub[so + S_NORMAL_SUM] += x1 + j1 - (again ? a1 : 0f);
        sub[so + S_NORMAL_SUM + 1] += x2 + j2 - (again ? a2 : 0f);
        sub[so + S_TANGENT_SUM] += newT - (again ? oldT : 0f);
      }
      float e = x1 == a1 && x2 == a2 ? 0f : Math.max(Math.abs(e1), Math.abs(e2));
      fastest = e > fastest ? e : fastest;
    }
    changed = fastest;
  }

  /** Takes the impulses of a substep out of a constraint, and out of their sums. */
  void drop(ContactConstraints cc, int i) {
    float[] d = cc.vel;
    int s = S_STRIDE * i;
    int o = V_STRIDE * i + POINT;
    cc.sub[s + S_TANGENT_SUM] -= d[o + TANGENT_IMPULSE];
    d[o + TANGENT_IMPULSE] = 0f;
    for (int j = 0; j < cc.pointCount[i]; j++) {
      int p = o + POINT_STRIDE * j + NORMAL_IMPULSE;
      cc.sub[s + S_NORMAL_SUM + j] -= d[p];
      d[p] = 0f;
    }
  }

  /** Speed at which a point may come nearer: what is left of its separation, over the substep. */
  private float room(ContactConstraints cc, SolverBodies bodies, int i, int a, int b, int point) {
    float[] x = bodies.delta;
    float[] d = cc.vel;
    int c = V_STRIDE * i;
    float along = (x[b] - x[a]) * d[c + NX] + (x[b + 1] - x[a + 1]) * d[c + NY];
    int o = c + POINT + POINT_STRIDE * point;
    boolean two = cc.pointCount[i] == 2;
    float curveA = two ? 0.5f * d[o + RT_A] : cc.sub[S_STRIDE * i + S_CURVE_A];
    float curveB = two ? 0.5f * d[o + RT_B] : cc.sub[S_STRIDE * i + S_CURVE_B];
    float s = separation(d, o, along, x[a + 2], x[b + 2], curveA, curveB);
    return s > 0f ? s * invH : 0f;
  }

  private static float separation(
      float[] d, int o, float along, float turnA, float turnB, float curveA, float curveB) {
    return d[o + BIAS]
        + along
        + turnB * (d[o + RN_B] + turnB * curveB)
        - turnA * (d[o + RN_A] + turnA * curveA);
  }

  private static void put(float[] v, int o, float x, float y, float w) {
    v[o] = x;
    v[o + 1] = y;
    v[o + 2] = w;
  }

  private static float positive(float x) {
    return x < 0f ? 0f : x;
  }

  private static float clamp(float x, float limit) {
    if (x > limit) {
      return limit;
    }
    return x < -limit ? -limit : x;
  }
}
