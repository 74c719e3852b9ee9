package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.common.Sweep;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;

/**
 * Bodies that joints hold together, taken as a whole: they are stopped on their way at the same
 * time, so that no joint is torn.
 */
final class JointedBodies {
  /** Marks the bodies collected, among {@link Body#m_flags}. */
  private static final int COLLECTED = 0x4000_0000;

  Body[] bodies = new Body[16];
  int count;

  /**
   * Collects a dynamic body and all dynamic ones that joints tie to it; ways through others do not
   * count.
   */
  void collect(Body first) {
    count = 0;
    add(first);
    for (int i = 0; i < count; i++) {
      for (JointEdge edge = bodies[i].m_jointList; edge != null; edge = edge.next) {
        Joint joint = edge.joint;
        for (int k = 0; k < joint.bodyCount() && joint.isActive(); k++) {
          add(joint.body(k));
        }
      }
    }
    for (int i = 0; i < count; i++) {
      bodies[i].m_flags &= ~COLLECTED;
    }
  }

  private void add(Body b) {
    if (b.m_type != BodyType.DYNAMIC || (b.m_flags & COLLECTED) != 0) {
      return;
    }
    b.m_flags |= COLLECTED;
    if (count == bodies.length) {
      bodies = Arrays.copyOf(bodies, 2 * count);
    }
    bodies[count++] = b;
  }

  /** Ends the way of the collected bodies at the fraction {@code t} of what was left of it. */
  void stopAt(float t) {
    for (int i = 0; i < count; i++) {
      Sweep s = bodies[i].m_sweep;
      s.c.x = s.c0.x + t * (s.c.x - s.c0.x);
      s.c.y = s.c0.y + t * (s.c.y - s.c0.y);
      s.a = s.a0 + t * (s.a - s.a0);
      bodies[i].synchronizeTransform();
    }
  }

  void release() {
    Arrays.fill(bodies, 0, count, null);
    count = 0;
  }
}
