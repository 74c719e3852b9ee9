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

  /** Pushes constraints {@code [from, to)}. */
  void push(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    float[] x = bodies.delta;
    float[] sub = cc.sub;
    float deepest = 0f;
    float fastest = 0f;
    for (int i = from; i < to; i++) {
      int c = V_STRIDE * i;
      int a = SolverBodies.STRIDE * cc.bodyA[i];
      int b = SolverBodies.STRIDE * cc.bodyB[i];
      float turnA = x[a + 2];
      float turnB = x[b + 2];
      float along = (x[b] - x[a]) * d[c + NX] + (x[b + 1] - x[a + 1]) * d[c + NY];
      Softness soft = d[c + INV_MASS_A] == 0f || d[c + INV_MASS_B] == 0f ? still : dynamic;
      int n = cc.pointCount[i];
      float bias1 = 0f;
      float bias2 = 0f;
      for (int j = 0; j < n; j++) {
        int o = c + POINT + POINT_STRIDE * j;
        float curveA = n == 2 ? 0.5f * d[o + RT_A] : sub[S_STRIDE * i + S_CURVE_A];
        float curveB = n == 2 ? 0.5f * d[o + RT_B] : sub[S_STRIDE * i + S_CURVE_B];
        float s = separation(d, o, along, turnA, turnB, curveA, curveB);
        sub[S_STRIDE * i + S_SEPARATION + j] = s;
        deepest = s < deepest ? s : deepest;
        float bias;
        if (s > 0f) {
          bias = s * invH;
        } else {
          bias = soft.rate * s;
          bias = bias < -mostPush ? -mostPush : bias;
        }
        if (j == 0) {
          bias1 = bias;
        } else {
          bias2 = bias;
        }
      }
      float e = 0f;
      if (n == 2) {
        e =
            pushTwo(
                d,
                c,
                v,
                a,
                b,
                sub,
                S_STRIDE * i,
                cc.block,
                K_STRIDE * i,
                bias1,
                bias2,
                soft.massScale,
                soft.impulseScale);
      } else if (n == 1) {
        e = pushOne(d, c, v, a, b, bias1, soft.massScale, soft.impulseScale);
      }
      fastest = e < fastest ? e : fastest;
    }
    closing = -fastest;
    least = deepest;
  }

  /**
   * Relaxes constraints {@code [from, to)} and adds their impulses up.
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
      int c = V_STRIDE * i;
      int u = S_STRIDE * i;
      int o1 = c + POINT;
      int a = SolverBodies.STRIDE * cc.bodyA[i];
      int b = SolverBodies.STRIDE * cc.bodyB[i];
      int n = cc.pointCount[i];
      float normal = again ? d[o1 + NORMAL_IMPULSE] : 0f;
      float tangent = again ? d[o1 + TANGENT_IMPULSE] : 0f;
      float e;
      if (n == 2) {
        int o2 = o1 + POINT_STRIDE;
        float normal2 = again ? d[o2 + NORMAL_IMPULSE] : 0f;
        float bias1 = sub[u + S_SEPARATION] > 0f ? room(cc, bodies, i, a, b, 0) : 0f;
        float bias2 = sub[u + S_SEPARATION + 1] > 0f ? room(cc, bodies, i, a, b, 1) : 0f;
        e = relaxTwo(d, c, v, a, b, sub, u, cc.block, K_STRIDE * i, bias1, bias2);
        if (summed) {
          sub[u + S_NORMAL_SUM + 1] += d[o2 + NORMAL_IMPULSE] - normal2;
        }
      } else if (n == 1) {
        float bias = sub[u + S_SEPARATION] > 0f ? room(cc, bodies, i, a, b, 0) : 0f;
        e = relaxOne(d, c, v, a, b, bias);
      } else {
        continue;
      }
      if (summed) {
        sub[u + S_NORMAL_SUM] += d[o1 + NORMAL_IMPULSE] - normal;
        sub[u + S_TANGENT_SUM] += d[o1 + TANGENT_IMPULSE] - tangent;
      }
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

  private static float clamp(float x, float limit) {
    if (x > limit) {
      return limit;
    }
    return x < -limit ? -limit : x;
  }

  private static float pushOne(
      float[] d,
      int c,
      float[] v,
      int oA,
      int oB,
      float bias,
      float massScale,
      float impulseScale) {
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
    int o = c + POINT;

    // Friction along t = (ny, -nx)
    float rtA = d[o + RT_A];
    float rtB = d[o + RT_B];
    float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
    float limit = d[c + FRICTION] * d[o + NORMAL_IMPULSE];
    float oldT = d[o + TANGENT_IMPULSE];
    float newT = clamp(oldT - d[o + TANGENT_MASS] * vt, limit);
    d[o + TANGENT_IMPULSE] = newT;
    float jt = newT - oldT;
    vAx -= mA * jt * ny;
    vAy += mA * jt * nx;
    wA -= iA * jt * rtA;
    vBx += mB * jt * ny;
    vBy -= mB * jt * nx;
    wB += iB * jt * rtB;

    // Normal
    float rnA = d[o + RN_A];
    float rnB = d[o + RN_B];
    float vn = (vBx - vAx) * nx + (vBy - vAy) * ny + wB * rnB - wA * rnA;
    float oldN = d[o + NORMAL_IMPULSE];
    float newN = oldN - massScale * d[c + M11] * (vn + bias) - impulseScale * oldN;
    if (newN < 0f) {
      newN = 0f;
    }
    d[o + NORMAL_IMPULSE] = newN;
    float jn = newN - oldN;
    v[oA] = vAx - mA * jn * nx;
    v[oA + 1] = vAy - mA * jn * ny;
    v[oA + 2] = wA - iA * jn * rnA;
    v[oB] = vBx + mB * jn * nx;
    v[oB + 1] = vBy + mB * jn * ny;
    v[oB + 2] = wB + iB * jn * rnB;
    return vn + bias;
  }

  /**
   * Friction, then the normals. {@code so}: substep record, {@code ko}: block record.
   *
   * <p>While both points push, they hold the angle between the bodies; so friction comes with the
   * change of the normal impulses that leaves the normal speeds as they are. Alone it would turn
   * the bodies until its points stand still, and be taken for enough.
   */
  private static float pushTwo(
      float[] d,
      int c,
      float[] v,
      int oA,
      int oB,
      float[] sub,
      int so,
      float[] block,
      int ko,
      float bias1,
      float bias2,
      float massScale,
      float impulseScale) {
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
    int o1 = c + POINT;
    int o2 = c + POINT + POINT_STRIDE;
    float rn1A = d[o1 + RN_A];
    float rn1B = d[o1 + RN_B];
    float rn2A = d[o2 + RN_A];
    float rn2B = d[o2 + RN_B];
    float a1 = d[o1 + NORMAL_IMPULSE];
    float a2 = d[o2 + NORMAL_IMPULSE];

    // Friction along t = (ny, -nx)
    float rtA = d[o1 + RT_A];
    float rtB = d[o1 + RT_B];
    float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
    float oldT = d[o1 + TANGENT_IMPULSE];
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

    // Normals: e = vn + bias, x = (1 - impulseScale) a - massScale K^-1 e if both push
    float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
    float e1 = massScale * (along + wB * rn1B - wA * rn1A + bias1);
    float e2 = massScale * (along + wB * rn2B - wA * rn2A + bias2);
    float keep = 1f - impulseScale;
    float x1 = keep * a1 - (d[c + M11] * e1 + d[c + M12] * e2);
    float x2 = keep * a2 - (d[c + M12] * e1 + d[c + M22] * e2);

    // Else the problem is w = K x - K (x1, x2).
    if (!(x1 >= 0f && x2 >= 0f)) {
      float k12 = block[ko + K12];
      float q1 = block[ko + K11] * x1 + k12 * x2;
      float q2 = k12 * x1 + block[ko + K22] * x2;
      ContactVelocityKernel.pushAtMostOne(d, o1, o2, a1, a2, block, ko, q1, q2);
      x1 = d[o1 + NORMAL_IMPULSE];
      x2 = d[o2 + NORMAL_IMPULSE];
    }
    d[o1 + NORMAL_IMPULSE] = x1;
    d[o2 + NORMAL_IMPULSE] = x2;
    j1 = x1 - a1;
    j2 = x2 - a2;
    float j = j1 + j2;
    v[oA] = vAx - mA * j * nx;
    v[oA + 1] = vAy - mA * j * ny;
    v[oA + 2] = wA - iA * (j1 * rn1A + j2 * rn2A);
    v[oB] = vBx + mB * j * nx;
    v[oB + 1] = vBy + mB * j * ny;
    v[oB + 2] = wB + iB * (j1 * rn1B + j2 * rn2B);
    return e1 < e2 ? e1 : e2;
  }

  /** Normal, then friction: it is bounded by the normal impulse without what pushing added. */
  private static float relaxOne(float[] d, int c, float[] v, int oA, int oB, float bias) {
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
    int o = c + POINT;

    float rnA = d[o + RN_A];
    float rnB = d[o + RN_B];
    float vn = (vBx - vAx) * nx + (vBy - vAy) * ny + wB * rnB - wA * rnA;
    float oldN = d[o + NORMAL_IMPULSE];
    float newN = oldN - d[c + M11] * (vn + bias);
    if (newN < 0f) {
      newN = 0f;
    }
    d[o + NORMAL_IMPULSE] = newN;
    float jn = newN - oldN;
    vAx -= mA * jn * nx;
    vAy -= mA * jn * ny;
    wA -= iA * jn * rnA;
    vBx += mB * jn * nx;
    vBy += mB * jn * ny;
    wB += iB * jn * rnB;

    float rtA = d[o + RT_A];
    float rtB = d[o + RT_B];
    float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
    float oldT = d[o + TANGENT_IMPULSE];
    float newT = clamp(oldT - d[o + TANGENT_MASS] * vt, d[c + FRICTION] * newN);
    d[o + TANGENT_IMPULSE] = newT;
    float jt = newT - oldT;
    v[oA] = vAx - mA * jt * ny;
    v[oA + 1] = vAy + mA * jt * nx;
    v[oA + 2] = wA - iA * jt * rtA;
    v[oB] = vBx + mB * jt * ny;
    v[oB + 1] = vBy - mB * jt * nx;
    v[oB + 2] = wB + iB * jt * rtB;
    return newN == oldN ? 0f : Math.abs(vn + bias);
  }

  /** As {@link #pushTwo}, the normals first, as in {@link #relaxOne}. */
  private static float relaxTwo(
      float[] d,
      int c,
      float[] v,
      int oA,
      int oB,
      float[] sub,
      int so,
      float[] block,
      int ko,
      float bias1,
      float bias2) {
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
    int o1 = c + POINT;
    int o2 = c + POINT + POINT_STRIDE;
    float rn1A = d[o1 + RN_A];
    float rn1B = d[o1 + RN_B];
    float rn2A = d[o2 + RN_A];
    float rn2B = d[o2 + RN_B];
    float a1 = d[o1 + NORMAL_IMPULSE];
    float a2 = d[o2 + NORMAL_IMPULSE];

    // Normals
    float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
    float e1 = along + wB * rn1B - wA * rn1A + bias1;
    float e2 = along + wB * rn2B - wA * rn2A + bias2;
    float x1 = a1 - (d[c + M11] * e1 + d[c + M12] * e2);
    float x2 = a2 - (d[c + M12] * e1 + d[c + M22] * e2);
    if (!(x1 >= 0f && x2 >= 0f)) {
      // As in pushTwo.
      float k12 = block[ko + K12];
      float q1 = block[ko + K11] * x1 + k12 * x2;
      float q2 = k12 * x1 + block[ko + K22] * x2;
      ContactVelocityKernel.pushAtMostOne(d, o1, o2, a1, a2, block, ko, q1, q2);
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

    // Friction
    float rtA = d[o1 + RT_A];
    float rtB = d[o1 + RT_B];
    float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - d[c + TANGENT_SPEED];
    float oldT = d[o1 + TANGENT_IMPULSE];
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
    v[oA] = vAx - mA * px;
    v[oA + 1] = vAy - mA * py;
    v[oA + 2] = wA - iA * (jt * rtA + j1 * rn1A + j2 * rn2A);
    v[oB] = vBx + mB * px;
    v[oB + 1] = vBy + mB * py;
    v[oB + 2] = wB + iB * (jt * rtB + j1 * rn1B + j2 * rn2B);
    return x1 == a1 && x2 == a2 ? 0f : Math.max(Math.abs(e1), Math.abs(e2));
  }
}
