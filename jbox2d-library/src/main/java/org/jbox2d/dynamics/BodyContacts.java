package org.jbox2d.dynamics;

import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;

/** What happens to the contacts of a body, and to its proxies, when the body is changed. */
final class BodyContacts {
  private BodyContacts() {}

  /**
   * Has contacts looked at in the next step though nobody in them may be awake, and wakes the
   * bodies that touch.
   *
   * @param fixture whose contacts; {@code null}: all of the body's
   */
  static void disturb(Body body, Fixture fixture) {
    for (ContactEdge edge = body.m_contactList; edge != null; edge = edge.next) {
      Contact c = edge.contact;
      if (isOf(c, fixture)) {
        body.m_world.m_contactManager.activateStray(c);
        if (c.isTouching() && !c.m_fixtureA.m_isSensor && !c.m_fixtureB.m_isSensor) {
          edge.other.setAwake(true);
        }
      }
    }
  }

  /** Destroys the contacts of a fixture; {@code null}: all of the body's. */
  static void destroy(Body body, Fixture fixture) {
    ContactEdge edge = body.m_contactList;
    while (edge != null) {
      Contact c = edge.contact;
      edge = edge.next;
      if (isOf(c, fixture)) {
        body.m_world.m_contactManager.destroy(c);
      }
    }
  }

  private static boolean isOf(Contact c, Fixture fixture) {
    return fixture == null || c.m_fixtureA == fixture || c.m_fixtureB == fixture;
  }

  /** Tells the bodies that have contacts with this one that it has become an obstacle, or none. */
  static void countObstacle(Body body, boolean isObstacle) {
    for (ContactEdge edge = body.m_contactList; edge != null; edge = edge.next) {
      edge.other.obstacles += isObstacle ? 1 : -1;
    }
  }

  /** Tells the broad phase whether a body stops others within a step. */
  static void markObstacle(Body body) {
    for (Fixture f = body.m_fixtureList; f != null; f = f.m_next) {
      f.markObstacle(body.m_world.m_contactManager.m_broadPhase);
    }
  }

  /** Lets the next step pair a body's proxies as if they were new. */
  static void touchProxies(Body body) {
    BroadPhase broadPhase = body.m_world.m_contactManager.m_broadPhase;
    for (Fixture f = body.m_fixtureList; f != null; f = f.m_next) {
      for (int i = 0; i < f.m_proxyCount; i++) {
        broadPhase.touchProxy(f.m_proxies[i].proxyId);
      }
    }
    body.m_world.lookForPairs();
  }
}
