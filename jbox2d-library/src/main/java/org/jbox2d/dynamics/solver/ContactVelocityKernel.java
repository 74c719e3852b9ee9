package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Sequential impulses on the velocities of contacts: friction first, then the normals, two points
 * at once.
 *
 * <p>For each point the accumulated normal impulse P obeys the complementarity {@code P >= 0, vn -
 * bias >= 0, P (vn - bias) = 0} and the friction impulse {@code |Pt| <= mu P} (Catto, GDC 2005 and
 * 2006; projected Gauss-Seidel). The two normals of a box face are coupled, so they are solved as
 * one 2 x 2 complementarity problem by trying its four index sets (Cottle, Pang and Stone, "The
 * Linear Complementarity Problem", 1992, section 3.1, direct enumeration):
 *
 * <pre>  w = K P + q,   w >= 0, P >= 0, w . P = 0,   q = vn - bias - K P_old</pre>
 *
 * Nearly always both push, where {@code P = -K^-1 q = P_old - K^-1 (vn - bias)}: K itself is not
 * needed.
 */
public final class ContactVelocityKernel {
  private ContactVelocityKernel() {}

  /** Applies the impulses kept from the last step to constraints {@code [from, to)}. */
  public static void warmStart(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    for (int i = from; i < to; i++) {
      int c = V_STRIDE * i;
      int oA = SolverBodies.STRIDE * cc.bodyA[i];
      int oB = SolverBodies.STRIDE * cc.bodyB[i];
      float pn = 0f;
      float pt = 0f;
      float lA = 0f;
      float lB = 0f;
      int end = c + POINT + POINT_STRIDE * cc.pointCount[i];
      for (int o = c + POINT; o < end; o += POINT_STRIDE) {
        float jn = d[o + NORMAL_IMPULSE];
        float jt = d[o + TANGENT_IMPULSE];
        pn += jn;
        pt += jt;
        lA += jn * d[o + RN_A] + jt * d[o + RT_A];
        lB += jn * d[o + RN_B] + jt * d[o + RT_B];
      }
      float px = pn * d[c + NX] + pt * d[c + NY];
      float py = pn * d[c + NY] - pt * d[c + NX];
      float mA = d[c + INV_MASS_A];
      float mB = d[c + INV_MASS_B];
      v[oA] -= mA * px;
      v[oA + 1] -= mA * py;
      v[oA + 2] -= d[c + INV_I_A] * lA;
      v[oB] += mB * px;
      v[oB + 1] += mB * py;
      v[oB + 2] += d[c + INV_I_B] * lB;
    }
  }

  /**
   * One iteration over constraints {@code [from, to)}. All of a contact is solved here, in one
   * loop, as in {@link SoftContactKernel#push}.
   */
  public static void solve(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    for (int i = from; i < to; i++) {
      // Stage 1: what one point and two have in common
      int c = V_STRIDE * i;
      int o1 = c + POINT;
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
      float a1 = d[o1 + NORMAL_IMPULSE];
      float friction = d[c + FRICTION];
      float speed = d[c + TANGENT_SPEED];

      // Stage 2: friction along t = (ny, -nx), at point 1, then at point 2
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
      if (cc.pointCount[i] != 2) {
        // Stage 3 of one point: the normal
        float vn = (vBx - vAx) * nx + (vBy - vAy) * ny + wB * rn1B - wA * rn1A;
        float newN = a1 - d[c + M11] * (vn - d[o1 + BIAS]);
        if (newN < 0f) {
          newN = 0f;
        }
        d[o1 + NORMAL_IMPULSE] = newN;
        float jn = newN - a1;
        v[oA] = vAx - mA * jn * nx;
        v[oA + 1] = vAy - mA * jn * ny;
        v[oA + 2] = wA - iA * jn * rn1A;
        v[oB] = vBx + mB * jn * nx;
        v[oB + 1] = vBy + mB * jn * ny;
        v[oB + 2] = wB + iB * jn * rn1B;
        continue;
      }
      int o2 = o1 + POINT_STRIDE;
      float a2 = d[o2 + NORMAL_IMPULSE];
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

      // Stage 3 of two: e = vn - bias, x = a - M e if both push
      float rn2A = d[o2 + RN_A];
      float rn2B = d[o2 + RN_B];
      float along = (vBx - vAx) * nx + (vBy - vAy) * ny;
      float e1 = along + wB * rn1B - wA * rn1A - d[o1 + BIAS];
      float e2 = along + wB * rn2B - wA * rn2A - d[o2 + BIAS];
      float x1 = a1 - (d[c + M11] * e1 + d[c + M12] * e2);
      float x2 = a2 - (d[c + M12] * e1 + d[c + M22] * e2);
      if (!(x1 >= 0f && x2 >= 0f)) {
        float[] block = cc.block;
        int ko = K_STRIDE * i;
        float k12 = block[ko + K12];
        float q1 = block[ko + K11] * a1 + k12 * a2 - e1;
        float q2 = k12 * a1 + block[ko + K22] * a2 - e2;
        pushAtMostOne(d, o1, o2, a1, a2, block, ko, q1, q2);
        x1 = d[o1 + NORMAL_IMPULSE];
        x2 = d[o2 + NORMAL_IMPULSE];
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

  /**
   * {@code x} within {@code [-limit, limit]}. By branches, which are predicted well as most points
   * stick: {@link Math#min} and {@link Math#max} would lie on the path on which each constraint
   * waits for the one before it.
   */
  private static float clamp(float x, float limit) {
    if (x > limit) {
      return limit;
    }
    return x < -limit ? -limit : x;
  }

  /**
   * Solves the problem {@code w = K x - q, w >= 0, x >= 0, w . x = 0} where not both points push,
   * by the other index sets in turn: only 1 pushes, only 2, none. One of them fits, as K is
   * positive definite; where rounding lets none fit, the impulses stay as they are. Writes x as the
   * normal impulses of the points at {@code o1} and {@code o2}.
   *
   * @param a1 normal impulse so far of point 1; a2: of point 2
   * @param ko place of K in {@code block}
   */
  static void pushAtMostOne(
      float[] d, int o1, int o2, float a1, float a2, float[] block, int ko, float q1, float q2) {
    float k12 = block[ko + K12];
    float x1 = q1 / block[ko + K11];
    float x2 = 0f;
    if (!(x1 >= 0f && k12 * x1 >= q2)) {
      x1 = 0f;
      x2 = q2 / block[ko + K22];
      if (!(x2 >= 0f && k12 * x2 >= q1)) {
        boolean separating = q1 <= 0f && q2 <= 0f;
        x1 = separating ? 0f : a1;
        x2 = separating ? 0f : a2;
      }
    }
    d[o1 + NORMAL_IMPULSE] = x1;
    d[o2 + NORMAL_IMPULSE] = x2;
  }
}
