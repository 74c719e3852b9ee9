package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Pushes overlapping bodies apart, without touching their velocities: non-linear projected
 * Gauss-Seidel on the positions (Catto, "Modeling and solving constraints", GDC 2009).
 *
 * <p>Each point is moved towards a remaining penetration of one slop: {@code C = clamp(beta (s +
 * slop), -max, 0)}, impulse {@code -C / k} along the current normal, s and k evaluated at the
 * positions as corrected so far.
 */
public final class ContactPositionKernel {
  private ContactPositionKernel() {}

  /**
   * One iteration over constraints {@code [from, to)}.
   *
   * @return the smallest separation met, m; negative is penetration
   */
  public static float solve(
      ContactConstraints cc,
      SolverBodies bodies,
      int from,
      int to,
      float beta,
      float slop,
      float maxCorrection) {
    float least = 0f;
    for (int i = from; i < to; i++) {
      if (cc.kind[i] == CIRCLES) {
        float s = solveCircles(cc, bodies, i, beta, slop, maxCorrection);
        least = s < least ? s : least;
      } else {
        int n = cc.manifoldPoints[i];
        for (int j = 0; j < n; j++) {
          float s = solveFacePoint(cc, bodies, i, j, beta, slop, maxCorrection);
          least = s < least ? s : least;
        }
      }
    }
    return least;
  }

  private static float solveCircles(
      ContactConstraints cc, SolverBodies bodies, int i, float beta, float slop, float max) {
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
    float separation = length - p[po + RADIUS_A] - p[po + RADIUS_B];
    float error = beta * (separation + slop);
    if (error < 0f) {
      error = error < -max ? -max : error;
      float nx = length > 0f ? dx / length : 1f;
      float ny = length > 0f ? dy / length : 0f;
      // The point midway between the centres, as arms from both.
      float mx = 0.5f * dx;
      float my = 0.5f * dy;
      push(
          bodies,
          p,
          po,
          cc.bodyA[i],
          cc.bodyB[i],
          nx,
          ny,
          ax + mx,
          ay + my,
          bx - mx,
          by - my,
          error);
    }
    return separation;
  }

  private static float solveFacePoint(
      ContactConstraints cc, SolverBodies bodies, int i, int j, float beta, float slop, float max) {
    boolean faceA = cc.kind[i] == FACE_A;
    float[] p = cc.pos;
    float[] x = bodies.pos;
    int po = P_STRIDE * i;
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
    float lx = p[po + P1X + 2 * j];
    float ly = p[po + P1Y + 2 * j];
    float clipX = cO * lx - sO * ly;
    float clipY = sO * lx + cO * ly;
    float height = (clipX + dx - planeX) * nx + (clipY + dy - planeY) * ny;
    float separation = height - p[po + RADIUS_A] - p[po + RADIUS_B];
    float error = beta * (separation + slop);
    if (error < 0f) {
      error = error < -max ? -max : error;
      if (faceA) {
        push(
            bodies,
            p,
            po,
            cc.bodyA[i],
            cc.bodyB[i],
            nx,
            ny,
            clipX + dx,
            clipY + dy,
            clipX,
            clipY,
            error);
      } else {
        push(
            bodies,
            p,
            po,
            cc.bodyA[i],
            cc.bodyB[i],
            -nx,
            -ny,
            clipX,
            clipY,
            clipX + dx,
            clipY + dy,
            error);
      }
    }
    return separation;
  }

  private static void push(
      SolverBodies bodies,
      float[] p,
      int po,
      int a,
      int b,
      float nx,
      float ny,
      float rAx,
      float rAy,
      float rBx,
      float rBy,
      float error) {
    float mA = p[po + P_INV_MASS_A];
    float iA = p[po + P_INV_I_A];
    float mB = p[po + P_INV_MASS_B];
    float iB = p[po + P_INV_I_B];
    float rnA = rAx * ny - rAy * nx;
    float rnB = rBx * ny - rBy * nx;
    float k = mA + mB + iA * rnA * rnA + iB * rnB * rnB;
    if (!(k > 0f)) {
      return;
    }
    float impulse = -error / k;
    float[] x = bodies.pos;
    int oA = SolverBodies.STRIDE * a;
    int oB = SolverBodies.STRIDE * b;
    x[oA] -= mA * impulse * nx;
    x[oA + 1] -= mA * impulse * ny;
    x[oB] += mB * impulse * nx;
    x[oB + 1] += mB * impulse * ny;
    if (iA > 0f) {
      bodies.turn(a, -iA * rnA * impulse);
    }
    if (iB > 0f) {
      bodies.turn(b, iB * rnB * impulse);
    }
  }
}
