package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Takes into account when in the step a bounce happens.
 *
 * <p>A step moves bodies by velocities that already have all of the step's gain from gravity and
 * forces. So, as in the leapfrog method (Hairer, Lubich and Wanner, "Geometric numerical
 * integration illustrated by the Stoermer-Verlet method", Acta Numerica 2003, section 1.1), they
 * are the velocities of the middle of the step. With g the gain of the relative speed vn along the
 * normal, the speed at the time alpha of the bounce is {@code vn + g (alpha - 1/2)}; -e times that
 * leaves, which in the middle of the step is
 *
 * <pre>  -e (vn + s) - s,   s = g (alpha - 1/2)</pre>
 *
 * Without s a ball that bounces without loss at speed u gains or loses {@code u dt (1 - 2 alpha)}
 * of height each time, a random walk of some per cent; what remains with it is of the order g dt^2.
 * The contacts of a whole step bounce at its start, alpha = 0; impacts within a step where they
 * are.
 */
final class BounceTiming {
  private BounceTiming() {}

  /**
   * Corrects the speed that the velocity constraints {@code [from, to)}, those of {@code contacts},
   * aim at. They have been prepared.
   */
  static void correct(
      ContactConstraints cc, Contact[] contacts, int from, int to, float alpha, StepConfig step) {
    float[] d = cc.vel;
    for (int i = from; i < to; i++) {
      int o = V_STRIDE * i;
      if (!(d[o + RESTITUTION] > 0f)) {
        continue;
      }
      for (int k = o + POINT; k < o + POINT + POINT_STRIDE * cc.pointCount[i]; k += POINT_STRIDE) {
        if (d[k + BIAS] > 0f) {
          float s = gain(contacts[i], d[o + NX], d[o + NY], step) * (alpha - step.velocityTime);
          d[k + BIAS] = Math.max(0f, d[k + BIAS] - (1f + d[o + RESTITUTION]) * s);
        }
      }
    }
  }

  private static float gain(Contact c, float nx, float ny, StepConfig step) {
    return gain(c.m_fixtureB.m_body, nx, ny, step) - gain(c.m_fixtureA.m_body, nx, ny, step);
  }

  /** What gravity and forces have added to the speed of a body along a direction in this step. */
  private static float gain(Body b, float nx, float ny, StepConfig step) {
    if (b.m_type != BodyType.DYNAMIC || !(b.m_invMass > 0f)) {
      return 0f;
    }
    float gravity = b.m_gravityScale * (nx * step.gravityX + ny * step.gravityY);
    return step.dt * (gravity + b.m_invMass * (nx * b.m_force.x + ny * b.m_force.y));
  }
}
