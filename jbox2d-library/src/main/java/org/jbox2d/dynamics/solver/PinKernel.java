package org.jbox2d.dynamics.solver;

/**
 * The two rows that pin a point of one body to a point of another, of a hinge or of a weld with a
 * spring: the formulas of {@link Arms} with all that they read held in local variables. Places,
 * velocities and rows are all floats, so that a compiler that sees one array written must read the
 * others again.
 */
final class PinKernel {
  private PinKernel() {}

  /**
   * One velocity iteration.
   *
   * @param at place of {@code K^-1} in the row
   * @param impulse place of the point's impulses, x and y, to which it adds
   * @param mostBend bound of the bend that is followed, m/s; see {@link Arms#mostBend}
   */
  static void solveVelocity(
      float[] f,
      int o,
      int at,
      int impulse,
      float mostBend,
      float[] v,
      float[] m,
      int a,
      int b,
      StepConfig step) {
    float rAx = f[o + Arms.RAX];
    float rAy = f[o + Arms.RAY];
    float rBx = f[o + Arms.RBX];
    float rBy = f[o + Arms.RBY];
    float vAx = v[a];
    float vAy = v[a + 1];
    float wA = v[a + 2];
    float vBx = v[b];
    float vBy = v[b + 1];
    float wB = v[b + 2];
    float cx = vBx - wB * rBy - vAx + wA * rAy;
    float cy = vBy + wB * rBx - vAy - wA * rAx;
    if (mostBend > 0f) {
      float invH = step.invDt;
      float tA = Arms.turn(wA * step.dt);
      float tB = Arms.turn(wB * step.dt);
      float versineA = Arms.versine(tA);
      float versineB = Arms.versine(tB);
      float lagA = Arms.lag(tA);
      float lagB = Arms.lag(tB);
      float bendX = invH * (versineA * rAx - lagA * rAy - versineB * rBx + lagB * rBy);
      float bendY = invH * (versineA * rAy + lagA * rAx - versineB * rBy - lagB * rBx);
      cx += Arms.bounded(bendX, mostBend);
      cy += Arms.bounded(bendY, mostBend);
    }
    float px = -(f[at] * cx + f[at + 1] * cy);
    float py = -(f[at + 1] * cx + f[at + 2] * cy);
    f[impulse] += px;
    f[impulse + 1] += py;
    float mA = m[a];
    float iA = m[a + 1];
    float mB = m[b];
    float iB = m[b + 1];
    v[a] = vAx - mA * px;
    v[a + 1] = vAy - mA * py;
    v[a + 2] = wA - iA * (rAx * py - rAy * px);
    v[b] = vBx + mB * px;
    v[b + 1] = vBy + mB * py;
    v[b + 2] = wB + iB * (rBx * py - rBy * px);
  }

  /**
   * One Newton step towards coincident points.
   *
   * @param most largest turn, rad
   * @return the square of the points' distance before it, m^2
   */
  static float join(float[] f, int o, SolverBodies bodies, int slotA, int slotB, float most) {
    int a = SolverBodies.STRIDE * slotA;
    int b = SolverBodies.STRIDE * slotB;
    float[] x = bodies.pos;
    float[] m = bodies.mass;
    Arms.turn(f, o, x, a, b);
    float rAx = f[o + Arms.RAX];
    float rAy = f[o + Arms.RAY];
    float rBx = f[o + Arms.RBX];
    float rBy = f[o + Arms.RBY];
    float mA = m[a];
    float iA = m[a + 1];
    float mB = m[b];
    float iB = m[b + 1];
    float cx = x[b] + rBx - x[a] - rAx;
    float cy = x[b + 1] + rBy - x[a + 1] - rAy;

    // K^-1 as in Arms.invert
    float mass = mA + mB;
    float cross = rAx * rBy - rAy * rBx;
    float arms = iA * (rAx * rAx + rAy * rAy) + iB * (rBx * rBx + rBy * rBy);
    float det = mass * (mass + arms) + iA * iB * cross * cross;
    float inv = det > 0f ? 1f / det : 0f;
    float m11 = inv * (mass + iA * rAx * rAx + iB * rBx * rBx);
    float m12 = inv * (iA * rAx * rAy + iB * rBx * rBy);
    float m22 = inv * (mass + iA * rAy * rAy + iB * rBy * rBy);
    float px = -(m11 * cx + m12 * cy);
    float py = -(m12 * cx + m22 * cy);

    float turnA = iA * (rAx * py - rAy * px);
    float turnB = iB * (rBx * py - rBy * px);
    float turn = Math.max(Math.abs(turnA), Math.abs(turnB));
    if (turn > most) {
      float share = most / turn;
      px *= share;
      py *= share;
      turnA *= share;
      turnB *= share;
    }
    Arms.move(bodies, slotA, -mA * px, -mA * py, -turnA);
    Arms.move(bodies, slotB, mB * px, mB * py, turnB);
    return cx * cx + cy * cy;
  }
}
