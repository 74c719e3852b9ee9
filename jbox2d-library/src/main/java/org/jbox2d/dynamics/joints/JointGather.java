package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.solver.Arms;

/** What the joints have in common when they write their rows. */
final class JointGather {
  private JointGather() {}

  /** Writes the points relative to the centres of mass. */
  static void arms(float[] f, int o, Body a, Vec2 localA, Body b, Vec2 localB) {
    Vec2 centreA = a.m_sweep.localCenter;
    Vec2 centreB = b.m_sweep.localCenter;
    Arms.write(
        f,
        o,
        localA.x - centreA.x,
        localA.y - centreA.y,
        localB.x - centreB.x,
        localB.y - centreB.y);
  }

  /**
   * Writes the velocities of both bodies as the last step and the user left them: while rows are
   * gathered, those of this step are in the solver alone.
   */
  static void velocities(float[] f, int at, Body a, Body b) {
    f[at] = a.m_linearVelocity.x;
    f[at + 1] = a.m_linearVelocity.y;
    f[at + 2] = a.m_angularVelocity;
    f[at + 3] = b.m_linearVelocity.x;
    f[at + 4] = b.m_linearVelocity.y;
    f[at + 5] = b.m_angularVelocity;
  }

  /**
   * Wakes both bodies, for a change of the joint that may set them moving; one that was destroyed
   * stays.
   */
  static void wake(Body a, Body b) {
    if (a.getWorld() != null) {
      a.setAwake(true);
    }
    if (b.getWorld() != null) {
      b.setAwake(true);
    }
  }
}
