package org.jbox2d.dynamics.solver;

/**
 * Draws a point of one body to a point of another, of a hinge or of a weld with a spring: the
 * formulas of {@link Arms} with all that they read held in local variables. Places and rows are all
 * floats, so that a compiler that sees one array written must read the others again.
 */
final class PinKernel {
  private PinKernel() {}

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
