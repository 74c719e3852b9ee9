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

  /**
   * For how many steps in a row bodies with joints may be stopped for the sake of contacts that a
   * step has solved and whose approach it could not end. Where contact and joints hinder each other
   * that takes some steps; where they contradict each other it never comes about, and the bodies
   * would hang in the air for good while gravity adds to their velocities.
   */
  private static final int MOST_HELD = 6;

  /** Share of a step up to which bodies that are stopped count as not having moved at all. */
  private static final float HELD = 0.1f;

  Body[] bodies = new Body[16];
  int count;

  /** Number of steps so far; see {@link Body#heldAt}. */
  private int steps;

  void beginStep() {
    steps++;
  }

  /**
   * Whether a body that would be stopped at the fraction {@code t} of its way has been held too
   * long; see {@link #MOST_HELD}. Then it and what joints tie to it need not stop in this step.
   */
  boolean mustLetGo(Body b, float t) {
    if (b.heldSteps < MOST_HELD || b.heldAt < steps - 1 || t > HELD) {
      return false;
    }
    collect(b);
    noteHeld(0);
    return true;
  }

  /** Counts this step for the bodies collected, or goes on without. */
  private void noteHeld(int more) {
    for (int i = 0; i < count; i++) {
      Body b = bodies[i];
      if (b.heldAt != steps) {
        b.heldSteps = b.heldAt == steps - 1 ? b.heldSteps + more : more;
        b.heldAt = steps;
      }
    }
  }

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
    if (t <= HELD) {
      noteHeld(1);
    }
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
