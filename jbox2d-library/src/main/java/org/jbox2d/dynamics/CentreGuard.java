package org.jbox2d.dynamics;

import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;

/**
 * Keeps a body's centre of mass outside of the still bodies that it touches. What touches from the
 * start of a step is no impact, so a splinter that turns about its corner at a wall may get deep
 * into it within a step, and out on the other side in the next.
 */
final class CentreGuard {
  private final RayCastInput ray = new RayCastInput();
  private final RayCastOutput hit = new RayCastOutput();
  private final Vec2 surface = new Vec2();

  /**
   * Lets the way of a body end one slop before the first surface that its centre would pass.
   *
   * @return whether that shortened it
   */
  boolean shorten(Body b, float slop) {
    Sweep s = b.m_sweep;
    ray.p1.set(s.c0);
    ray.p2.set(s.c);
    if (ray.p1.equals(ray.p2)) {
      return false;
    }
    ray.maxFraction = 1f;
    boolean asked = false;
    int left = b.obstacles;
    for (ContactEdge edge = b.m_contactList; left > 0 && edge != null; edge = edge.next) {
      if (edge.other.isObstacle()) {
        left--;
      }
      if (edge.other.m_type != BodyType.STATIC || !isSolid(edge.contact)) {
        continue;
      }
      if (!asked && !isSolidAtCentre(b)) {
        return false;
      }
      asked = true;
      clip(b, edge.contact);
    }
    if (!(ray.maxFraction < 1f)) {
      return false;
    }
    s.c.x = s.c0.x + ray.maxFraction * (s.c.x - s.c0.x) + slop * surface.x;
    s.c.y = s.c0.y + ray.maxFraction * (s.c.y - s.c0.y) + slop * surface.y;
    b.synchronizeTransform();
    return true;
  }

  private static boolean isSolid(Contact c) {
    return c.isTouching() && c.isEnabled() && !c.m_fixtureA.m_isSensor && !c.m_fixtureB.m_isSensor;
  }

  /**
   * Whether the centre lies within the body, in whichever fixture: that of a ring or a hook does
   * not, and may pass through anything.
   */
  private static boolean isSolidAtCentre(Body b) {
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      if (!f.m_isSensor && f.testPoint(b.m_sweep.c)) {
        return true;
      }
    }
    return false;
  }

  /** Shortens the ray to where it meets the other shape of a contact. */
  private void clip(Body b, Contact c) {
    boolean isA = c.m_fixtureA.m_body == b;
    Fixture still = isA ? c.m_fixtureB : c.m_fixtureA;
    if (still.raycast(hit, ray, isA ? c.m_indexB : c.m_indexA)) {
      ray.maxFraction = hit.fraction;
      surface.set(hit.normal);
    }
  }
}
