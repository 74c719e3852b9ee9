package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.solver.Arms;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.SolverBodies;

/** What the joints have in common when they write their rows. */
final class JointGather {
  private JointGather() {}

  /**
   * Writes the points relative to the centres of mass, which are read from the slots of the bodies:
   * in a body they lie two objects further.
   */
  static void arms(JointRows rows, int o, Body a, Vec2 localA, Body b, Vec2 localB) {
    float[] centre = rows.masses;
    int oA = SolverBodies.STRIDE * a.m_islandIndex + 2;
    int oB = SolverBodies.STRIDE * b.m_islandIndex + 2;
    Arms.write(
        rows.f,
        o,
        localA.x - centre[oA],
        localA.y - centre[oA + 1],
        localB.x - centre[oB],
        localB.y - centre[oB + 1]);
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
