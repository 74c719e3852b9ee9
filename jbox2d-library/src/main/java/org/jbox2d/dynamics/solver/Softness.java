package org.jbox2d.dynamics.solver;

/**
 * How a constraint gives way, as a spring-damper of a frequency and a damping ratio rather than of
 * a stiffness, so that it is the same for all masses.
 *
 * <p>A spring {@code m xddot + 2 m zeta omega xdot + m omega^2 x = 0} on the constraint's error s,
 * solved by implicit Euler over a substep h, is the velocity constraint
 *
 * <pre>
 *   v + rate s + gamma P = 0,    rate = omega / (2 zeta + h omega),
 *   gamma m = 1 / (h omega (2 zeta + h omega))
 * </pre>
 *
 * With accumulated impulse P and its change dP = -(v + rate s + gamma P) / (1/m + gamma),
 *
 * <pre>
 *   dP = -massScale m (v + rate s) - impulseScale P,
 *   massScale = 1 / (1 + gamma m),   impulseScale = 1 - massScale
 * </pre>
 *
 * (Catto, "Soft constraints", GDC 2011, and "Solver2D", 2024.)
 */
final class Softness {
  float rate;
  float massScale;
  float impulseScale;

  /**
   * Sets the softness.
   *
   * @param frequency Hz, positive
   * @param h substep, s, positive
   * @param mostRate bound of the rate, 1/s: how fast an error goes is not to grow with the number
   *     of substeps, as how far it gives way under a load should
   */
  void set(float frequency, float dampingRatio, float h, float mostRate) {
    float omega = 2f * (float) Math.PI * frequency;
    float drag = 2f * dampingRatio + h * omega;
    float stiff = h * omega * drag;
    rate = Math.min(mostRate, omega / drag);
    impulseScale = 1f / (1f + stiff);
    massScale = stiff * impulseScale;
  }
}
