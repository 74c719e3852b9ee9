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
 * centre, so between circles turning changes nothing.
 *
 * <p>Friction first, then the two normals of a face at once as in {@link ContactVelocityKernel}:
 * softness scales the inverse of the 2 x 2 matrix as it does a single effective mass.
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
  float least;

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

  /** Pushes constraints {@code [from, to)}. */
  void push(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    float[] x = bodies.delta;
    float[] sub = cc.sub;
    float deepest = 0f;
    for (int i = from; i < to; i++) {
      int c = V_STRIDE * i;
      int a = SolverBodies.STRIDE * cc.bodyA[i];
      int b = SolverBodies.STRIDE * cc.bodyB[i];
      float square = cc.kind[i] == CIRCLES ? 0f : 0.5f;
      float turnA = x[a + 2];
      float turnB = x[b + 2];
      float along = (x[b] - x[a]) * d[c + NX] + (x[b + 1] - x[a + 1]) * d[c + NY];
      Softness soft = d[c + INV_MASS_A] == 0f || d[c + INV_MASS_B] == 0f ? still : dynamic;
      int n = cc.pointCount[i];
      float bias1 = 0f;
      float bias2 = 0f;
      for (int j = 0; j < n; j++) {
        int o = c + POINT + POINT_STRIDE * j;
        float s =
            d[o + BIAS]
                + along
                + turnB * (d[o + RN_B] + square * turnB * d[o + RT_B])
                - turnA * (d[o + RN_A] + square * turnA * d[o + RT_A]);
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
      if (n == 2) {
        solveTwo(
            d, c, v, a, b, cc.block, K_STRIDE * i, bias1, bias2, soft.massScale, soft.impulseScale);
      } else if (n == 1) {
        solveOne(d, c, v, a, b, bias1, soft.massScale, soft.impulseScale);
      }
    }
    least = deepest;
  }

  /** Relaxes constraints {@code [from, to)} and adds their impulses up. */
  void relax(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    float[] sub = cc.sub;
    for (int i = from; i < to; i++) {
      int c = V_STRIDE * i;
      int u = S_STRIDE * i;
      int a = SolverBodies.STRIDE * cc.bodyA[i];
      int b = SolverBodies.STRIDE * cc.bodyB[i];
      float s1 = sub[u + S_SEPARATION];
      float bias1 = s1 > 0f ? s1 * invH : 0f;
      if (cc.pointCount[i] == 2) {
        float s2 = sub[u + S_SEPARATION + 1];
        float bias2 = s2 > 0f ? s2 * invH : 0f;
        solveTwo(d, c, v, a, b, cc.block, K_STRIDE * i, bias1, bias2, 1f, 0f);
        sub[u + S_NORMAL_SUM + 1] += d[c + POINT + POINT_STRIDE + NORMAL_IMPULSE];
        sub[u + S_TANGENT_SUM + 1] += d[c + POINT + POINT_STRIDE + TANGENT_IMPULSE];
      } else if (cc.pointCount[i] == 1) {
        solveOne(d, c, v, a, b, bias1, 1f, 0f);
      } else {
        continue;
      }
      sub[u + S_NORMAL_SUM] += d[c + POINT + NORMAL_IMPULSE];
      sub[u + S_TANGENT_SUM] += d[c + POINT + TANGENT_IMPULSE];
    }
  }

  private static float clamp(float x, float limit) {
    if (x > limit) {
      return limit;
    }
    return x < -limit ? -limit : x;
  }

  private static void solveOne(
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
  }

  private static void solveTwo(
      float[] d,
      int c,
      float[] v,
      int oA,
      int oB,
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
    float a1 = d[o1 + NORMAL_IMPULSE];
    float a2 = d[o2 + NORMAL_IMPULSE];
    float friction = d[c + FRICTION];
    float speed = d[c + TANGENT_SPEED];

    // Friction at point 1, then at point 2
    float rtA = d[o1 + RT_A];
    float rtB = d[o1 + RT_B];
    float vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - speed;
    float oldT = d[o1 + TANGENT_IMPULSE];
    float newT = clamp(oldT - d[o1 + TANGENT_MASS] * vt, friction * a1);
    d[o1 + TANGENT_IMPULSE] = newT;
    float jt = newT - oldT;
    vAx -= mA * jt * ny;
    vAy += mA * jt * nx;
    wA -= iA * jt * rtA;
    vBx += mB * jt * ny;
    vBy -= mB * jt * nx;
    wB += iB * jt * rtB;

    rtA = d[o2 + RT_A];
    rtB = d[o2 + RT_B];
    vt = (vBx - vAx) * ny - (vBy - vAy) * nx + wB * rtB - wA * rtA - speed;
    oldT = d[o2 + TANGENT_IMPULSE];
    newT = clamp(oldT - d[o2 + TANGENT_MASS] * vt, friction * a2);
    d[o2 + TANGENT_IMPULSE] = newT;
    jt = newT - oldT;
    vAx -= mA * jt * ny;
    vAy += mA * jt * nx;
    wA -= iA * jt * rtA;
    vBx += mB * jt * ny;
    vBy -= mB * jt * nx;
    wB += iB * jt * rtB;

    // Normals: e = vn + bias, x = (1 - impulseScale) a - massScale K^-1 e if both push
    float rn1A = d[o1 + RN_A];
    float rn1B = d[o1 + RN_B];
    float rn2A = d[o2 + RN_A];
    float rn2B = d[o2 + RN_B];
    float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
    float e1 = massScale * (along + wB * rn1B - wA * rn1A + bias1);
    float e2 = massScale * (along + wB * rn2B - wA * rn2A + bias2);
    float keep = 1f - impulseScale;
    float x1 = keep * a1 - (d[c + M11] * e1 + d[c + M12] * e2);
    float x2 = keep * a2 - (d[c + M12] * e1 + d[c + M22] * e2);

    // The other index sets in turn, of the problem w = K x - K (x1, x2): only 1 pushes, only 2,
    // none.
    if (!(x1 >= 0f && x2 >= 0f)) {
      float k11 = block[ko + K11];
      float k12 = block[ko + K12];
      float k22 = block[ko + K22];
      float q1 = k11 * x1 + k12 * x2;
      float q2 = k12 * x1 + k22 * x2;
      x1 = q1 / k11;
      x2 = 0f;
      if (!(x1 >= 0f && k12 * x1 >= q2)) {
        x1 = 0f;
        x2 = q2 / k22;
        if (!(x2 >= 0f && k12 * x2 >= q1)) {
          boolean separating = q1 <= 0f && q2 <= 0f;
          x1 = separating ? 0f : a1;
          x2 = separating ? 0f : a2;
        }
      }
    }
    d[o1 + NORMAL_IMPULSE] = x1;
    d[o2 + NORMAL_IMPULSE] = x2;
    float j1 = x1 - a1;
    float j2 = x2 - a2;
    float j = j1 + j2;
    v[oA] = vAx - mA * j * nx;
    v[oA + 1] = vAy - mA * j * ny;
    v[oA + 2] = wA - iA * (j1 * rn1A + j2 * rn2A);
    v[oB] = vBx + mB * j * nx;
    v[oB + 1] = vBy + mB * j * ny;
    v[oB + 2] = wB + iB * (j1 * rn1B + j2 * rn2B);
  }
}
