package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import java.util.Arrays;

/**
 * Turns position records into velocity records: world normal, arms, effective masses, restitution.
 *
 * <p>Effective mass of a direction d with arms rA, rB: {@code 1 / (mA + mB + iA (rA x d)^2 + iB (rB
 * x d)^2)}, m and i the inverse masses and inertias (Catto, "Iterative dynamics with temporal
 * coherence", GDC 2005).
 */
public final class ContactPreparation {
  /**
   * Largest condition (as {@code k11^2 / det}) of the two-point matrix that is still solved as a
   * block; two points so close together that it is exceeded act as one.
   */
  private static final float MAX_CONDITION = 1000f;

  /** Share of the tangent's own term below which what the normals leave of it is rounding. */
  private static final float LEAST_HELD = 1e-4f;

  private ContactPreparation() {}

  /**
   * Prepares constraints {@code [from, to)}. Masses, manifold data, friction, tangent speed,
   * restitution and impulses must have been written; {@code bodies} holds the positions and
   * velocities from which contacts are solved.
   */
  public static void prepare(
      ContactConstraints cc, SolverBodies bodies, int from, int to, float velocityThreshold) {
    for (int i = from; i < to; i++) {
      prepare(cc, bodies, i);
      writeRestitution(cc, bodies, i, velocityThreshold);
    }
  }

  /**
   * As {@link #prepare(ContactConstraints, SolverBodies, int, int, float)}, for substeps: {@link
   * ContactConstraints#BIAS} is the separation of each point.
   *
   * @return whether one of them has restitution
   */
  static boolean prepareSubsteps(ContactConstraints cc, SolverBodies bodies, int from, int to) {
    boolean bounces = false;
    Arrays.fill(cc.sub, S_STRIDE * from, S_STRIDE * to, 0f);
    for (int i = from; i < to; i++) {
      prepare(cc, bodies, i);
      if (cc.pointCount[i] == 2) {
        joinFriction(cc, i);
      } else {
        writeCurves(cc, i);
      }
      if (cc.corner[i] && cc.vel[V_STRIDE * i + POINT + BIAS] > 0f) {
        cc.pointCount[i] = 0;
      }
      bounces |= cc.vel[V_STRIDE * i + RESTITUTION] > 0f;
    }
    return bounces;
  }

  /**
   * Makes one row of the friction of both points, and eliminates the normals from it: with friction
   * T goes {@code N = -K^-1 k T}, k the coupling of normals and tangent, so that the tangent speed
   * gains {@code (ktt - k . K^-1 k) T}.
   */
  private static void joinFriction(ContactConstraints cc, int i) {
    float[] d = cc.vel;
    int vo = V_STRIDE * i;
    int o1 = vo + POINT;
    int o2 = o1 + POINT_STRIDE;
    float iA = d[vo + INV_I_A];
    float iB = d[vo + INV_I_B];
    float rtA = d[o1 + RT_A];
    float rtB = d[o1 + RT_B];
    float k1 = iA * d[o1 + RN_A] * rtA + iB * d[o1 + RN_B] * rtB;
    float k2 = iA * d[o2 + RN_A] * rtA + iB * d[o2 + RN_B] * rtB;
    float hold1 = -(d[vo + M11] * k1 + d[vo + M12] * k2);
    float hold2 = -(d[vo + M12] * k1 + d[vo + M22] * k2);
    float plain = d[vo + INV_MASS_A] + d[vo + INV_MASS_B] + iA * rtA * rtA + iB * rtB * rtB;
    float held = plain + k1 * hold1 + k2 * hold2;
    boolean holds = held > LEAST_HELD * plain;
    int so = S_STRIDE * i;
    cc.sub[so + S_HOLD] = holds ? hold1 : 0f;
    cc.sub[so + S_HOLD + 1] = holds ? hold2 : 0f;
    cc.sub[so + S_HELD_TANGENT_MASS] = holds ? 1f / held : d[o1 + TANGENT_MASS];
    d[o1 + TANGENT_IMPULSE] += d[o2 + TANGENT_IMPULSE];
    d[o2 + TANGENT_IMPULSE] = 0f;
  }

  /**
   * How the separation of the one point falls with the squares of the turns: a corner moves on a
   * circle about the centre of its body, {@code tB^2 (rB x t) / 2}. The lowest point of a disc
   * stays below the disc's centre, so there it is the arm of that centre which counts: a wheel at
   * 100 rad/s would else seem to come off the road by more than its radius in a step.
   */
  private static void writeCurves(ContactConstraints cc, int i) {
    float[] d = cc.vel;
    int o = V_STRIDE * i + POINT;
    int so = S_STRIDE * i;
    float curveA = 0f;
    float curveB = 0f;
    if (cc.kind[i] != CIRCLES) {
      curveA = 0.5f * d[o + RT_A];
      curveB = 0.5f * d[o + RT_B];
      int po = P_STRIDE * i;
      float radius = cc.pos[po + P_ROUND];
      if (radius > 0f) {
        // From the point, midway between the surfaces, to the disc's centre.
        float back = 0.5f * (radius + 0.5f * (d[o + BIAS] - cc.pos[po + P_REST]));
        if (cc.kind[i] == FACE_A) {
          curveB -= back;
        } else {
          curveA += back;
        }
      }
    }
    cc.sub[so + S_CURVE_A] = curveA;
    cc.sub[so + S_CURVE_B] = curveB;
  }

  private static void prepare(ContactConstraints cc, SolverBodies bodies, int i) {
    if (cc.kind[i] == CIRCLES) {
      prepareCircles(cc, bodies, i);
    } else {
      prepareFace(cc, bodies, i);
    }
    writeMasses(cc, i);
  }

  private static void prepareCircles(ContactConstraints cc, SolverBodies bodies, int i) {
    float[] p = cc.pos;
    float[] x = bodies.pos;
    int po = P_STRIDE * i;
    int oA = SolverBodies.STRIDE * cc.bodyA[i];
    int oB = SolverBodies.STRIDE * cc.bodyB[i];
    float ax = x[oA + 3] * p[po + PLANE_X] - x[oA + 2] * p[po + PLANE_Y];
    float ay = x[oA + 2] * p[po + PLANE_X] + x[oA + 3] * p[po + PLANE_Y];
    float bx = x[oB + 3] * p[po + P1X] - x[oB + 2] * p[po + P1Y];
    float by = x[oB + 2] * p[po + P1X] + x[oB + 3] * p[po + P1Y];
    float dx = x[oB] - x[oA] + bx - ax;
    float dy = x[oB + 1] - x[oA + 1] + by - ay;
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    float nx = 1f;
    float ny = 0f;
    if (length > 0f) {
      nx = dx / length;
      ny = dy / length;
    }
    // The contact point lies midway between the two surfaces: this far from A's centre, along the
    // normal.
    float along = 0.5f * (p[po + RADIUS_A] + length - p[po + RADIUS_B]);
    float back = along - length;
    setNormal(cc, i, nx, ny, 1);
    setArms(cc, i, 0, ax + along * nx, ay + along * ny, bx + back * nx, by + back * ny);
    cc.vel[V_STRIDE * i + POINT + BIAS] =
        length - p[po + RADIUS_A] - p[po + RADIUS_B] + p[po + P_REST];
  }

  private static void prepareFace(ContactConstraints cc, SolverBodies bodies, int i) {
    boolean faceA = cc.kind[i] == FACE_A;
    float[] p = cc.pos;
    float[] x = bodies.pos;
    int po = P_STRIDE * i;
    // R: the reference body, whose face it is; O: the other, whose points they are.
    int oR = SolverBodies.STRIDE * (faceA ? cc.bodyA[i] : cc.bodyB[i]);
    int oO = SolverBodies.STRIDE * (faceA ? cc.bodyB[i] : cc.bodyA[i]);
    float sR = x[oR + 2];
    float cR = x[oR + 3];
    float sO = x[oO + 2];
    float cO = x[oO + 3];
    float dx = x[oO] - x[oR];
    float dy = x[oO + 1] - x[oR + 1];
    float nx = cR * p[po + LOCAL_NX] - sR * p[po + LOCAL_NY];
    float ny = sR * p[po + LOCAL_NX] + cR * p[po + LOCAL_NY];
    float planeX = cR * p[po + PLANE_X] - sR * p[po + PLANE_Y];
    float planeY = sR * p[po + PLANE_X] + cR * p[po + PLANE_Y];
    float radiusR = faceA ? p[po + RADIUS_A] : p[po + RADIUS_B];
    float radiusO = faceA ? p[po + RADIUS_B] : p[po + RADIUS_A];
    int n = cc.manifoldPoints[i];
    setNormal(cc, i, faceA ? nx : -nx, faceA ? ny : -ny, n);
    for (int j = 0; j < n; j++) {
      float lx = p[po + P1X + 2 * j];
      float ly = p[po + P1Y + 2 * j];
      float clipX = cO * lx - sO * ly;
      float clipY = sO * lx + cO * ly;
      // Midway between the two skins, on the line through the clip point along the normal; as arms
      // from both centres.
      float height = (clipX + dx - planeX) * nx + (clipY + dy - planeY) * ny;
      float shift = 0.5f * (radiusR - radiusO - height);
      float rOx = clipX + shift * nx;
      float rOy = clipY + shift * ny;
      if (faceA) {
        setArms(cc, i, j, rOx + dx, rOy + dy, rOx, rOy);
      } else {
        setArms(cc, i, j, rOx, rOy, rOx + dx, rOy + dy);
      }
      cc.vel[V_STRIDE * i + POINT + POINT_STRIDE * j + BIAS] =
          height - radiusR - radiusO + p[po + P_REST];
    }
  }

  private static void setNormal(ContactConstraints cc, int i, float nx, float ny, int points) {
    int vo = V_STRIDE * i;
    cc.vel[vo + NX] = nx;
    cc.vel[vo + NY] = ny;
    cc.pointCount[i] = points;
  }

  private static void setArms(
      ContactConstraints cc, int i, int j, float rAx, float rAy, float rBx, float rBy) {
    float[] d = cc.vel;
    int vo = V_STRIDE * i;
    float nx = d[vo + NX];
    float ny = d[vo + NY];
    int o = vo + POINT + POINT_STRIDE * j;
    d[o + RN_A] = rAx * ny - rAy * nx;
    d[o + RN_B] = rBx * ny - rBy * nx;
    // r x t with t = (ny, -nx)
    d[o + RT_A] = -(rAx * nx + rAy * ny);
    d[o + RT_B] = -(rBx * nx + rBy * ny);
  }

  private static void writeMasses(ContactConstraints cc, int i) {
    float[] d = cc.vel;
    int vo = V_STRIDE * i;
    float m = d[vo + INV_MASS_A] + d[vo + INV_MASS_B];
    float iA = d[vo + INV_I_A];
    float iB = d[vo + INV_I_B];
    for (int j = 0; j < cc.pointCount[i]; j++) {
      int o = vo + POINT + POINT_STRIDE * j;
      float kt = m + iA * d[o + RT_A] * d[o + RT_A] + iB * d[o + RT_B] * d[o + RT_B];
      d[o + TANGENT_MASS] = kt > 0f ? 1f / kt : 0f;
    }
    if (cc.pointCount[i] == 2) {
      writeBlock(cc, i, m, iA, iB);
    } else {
      int o = vo + POINT;
      writeSingle(d, vo, m + iA * d[o + RN_A] * d[o + RN_A] + iB * d[o + RN_B] * d[o + RN_B]);
    }
  }

  private static void writeSingle(float[] d, int vo, float k) {
    d[vo + M11] = k > 0f ? 1f / k : 0f;
    d[vo + M12] = 0f;
    d[vo + M22] = 0f;
  }

  private static void writeBlock(ContactConstraints cc, int i, float m, float iA, float iB) {
    float[] d = cc.vel;
    int vo = V_STRIDE * i;
    int o1 = vo + POINT;
    int o2 = o1 + POINT_STRIDE;
    float k11 = m + iA * d[o1 + RN_A] * d[o1 + RN_A] + iB * d[o1 + RN_B] * d[o1 + RN_B];
    float k22 = m + iA * d[o2 + RN_A] * d[o2 + RN_A] + iB * d[o2 + RN_B] * d[o2 + RN_B];
    float k12 = m + iA * d[o1 + RN_A] * d[o2 + RN_A] + iB * d[o1 + RN_B] * d[o2 + RN_B];
    float det = k11 * k22 - k12 * k12;
    if (k11 * k11 < MAX_CONDITION * det) {
      float inv = 1f / det;
      int ko = K_STRIDE * i;
      cc.block[ko + K11] = k11;
      cc.block[ko + K12] = k12;
      cc.block[ko + K22] = k22;
      d[vo + M11] = inv * k22;
      d[vo + M12] = -inv * k12;
      d[vo + M22] = inv * k11;
    } else {
      cc.pointCount[i] = 1;
      writeSingle(d, vo, k11);
    }
  }

  private static void writeRestitution(
      ContactConstraints cc, SolverBodies bodies, int i, float threshold) {
    float[] d = cc.vel;
    float[] v = bodies.vel;
    int vo = V_STRIDE * i;
    int oA = SolverBodies.STRIDE * cc.bodyA[i];
    int oB = SolverBodies.STRIDE * cc.bodyB[i];
    float along = d[vo + NX] * (v[oB] - v[oA]) + d[vo + NY] * (v[oB + 1] - v[oA + 1]);
    for (int j = 0; j < cc.pointCount[i]; j++) {
      int o = vo + POINT + POINT_STRIDE * j;
      float vn = along + v[oB + 2] * d[o + RN_B] - v[oA + 2] * d[o + RN_A];
      d[o + BIAS] = vn < -threshold ? -d[vo + RESTITUTION] * vn : 0f;
    }
  }
}
