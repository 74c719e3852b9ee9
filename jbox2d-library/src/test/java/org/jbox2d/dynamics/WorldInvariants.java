package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointEdge;

/** Checks that everything a world keeps twice agrees, and that nothing is NaN. */
final class WorldInvariants {
  private WorldInvariants() {}

  static void check(World world) {
    assertFalse(world.isLocked(), "locked between steps");
    Set<Contact> contacts = checkContactList(world);
    checkBodies(world, contacts);
    checkAwakeSet(world);
    checkActiveContacts(world);
    checkJoints(world);
  }

  private static Set<Contact> checkContactList(World world) {
    Set<Contact> contacts = new HashSet<>();
    Set<Set<FixtureProxy>> pairs = new HashSet<>();
    Contact before = null;
    for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
      assertSame(before, c.m_prev);
      assertTrue(contacts.add(c), "a contact twice in the list");
      FixtureProxy a = c.m_fixtureA.m_proxies[c.m_indexA];
      FixtureProxy b = c.m_fixtureB.m_proxies[c.m_indexB];
      assertTrue(pairs.add(Set.of(a, b)), "two contacts of one pair");
      assertTrue(c.m_fixtureA.m_body.isActive() && c.m_fixtureB.m_body.isActive());
      assertSame(world, c.m_fixtureA.m_body.m_world);
      assertSame(world, c.m_fixtureB.m_body.m_world);
      before = c;
    }
    assertEquals(contacts.size(), world.getContactCount());
    return contacts;
  }

  private static void checkBodies(World world, Set<Contact> contacts) {
    int bodies = 0;
    int proxies = 0;
    int edges = 0;
    Body before = null;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      bodies++;
      assertSame(before, b.m_prev);
      assertSame(world, b.m_world);
      checkFinite(b);
      int fixtures = 0;
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        fixtures++;
        assertSame(b, f.m_body);
        assertEquals(b.isActive() ? f.m_shape.getChildCount() : 0, f.m_proxyCount);
        proxies += f.m_proxyCount;
      }
      assertEquals(b.m_fixtureCount, fixtures);
      ContactEdge edgeBefore = null;
      for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
        edges++;
        assertSame(edgeBefore, edge.prev);
        assertTrue(contacts.contains(edge.contact), "a body's contact is not in the world's list");
        Body a = edge.contact.m_fixtureA.m_body;
        Body c = edge.contact.m_fixtureB.m_body;
        assertTrue(a == b && c == edge.other || c == b && a == edge.other);
        edgeBefore = edge;
      }
      before = b;
    }
    assertEquals(bodies, world.getBodyCount());
    assertEquals(proxies, world.getProxyCount());
    assertEquals(2 * contacts.size(), edges);
  }

  private static void checkFinite(Body b) {
    float sum =
        b.m_xf.p.x
            + b.m_xf.p.y
            + b.m_sweep.c.x
            + b.m_sweep.c.y
            + b.m_sweep.a
            + b.m_linearVelocity.x
            + b.m_linearVelocity.y
            + b.m_angularVelocity;
    assertTrue(Float.isFinite(sum), "a body's state is not finite");
  }

  private static void checkAwakeSet(World world) {
    int awake = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      boolean should = b.isAwake() && b.isActive() && b.m_type != BodyType.STATIC;
      assertEquals(should, b.awakeIndex >= 0, "awake set does not fit the body's state");
      if (should) {
        assertSame(b, world.awake.bodies[b.awakeIndex]);
        awake++;
      } else {
        assertEquals(0f, b.m_force.length() + Math.abs(b.m_torque), "forces that nobody clears");
      }
    }
    assertEquals(awake, world.awake.count);
    for (int i = awake; i < world.awake.bodies.length; i++) {
      assertNull(world.awake.bodies[i], "the awake set holds on to a body");
    }
  }

  private static void checkActiveContacts(World world) {
    ContactManager manager = world.m_contactManager;
    int active = 0;
    for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
      boolean needed = c.m_fixtureA.m_body.awakeIndex >= 0 || c.m_fixtureB.m_body.awakeIndex >= 0;
      if (needed || !manager.strays) {
        assertEquals(needed, c.m_activeIndex >= 0, "active contacts do not fit the awake set");
      }
      if (c.m_activeIndex >= 0) {
        int i = c.m_activeIndex;
        assertSame(c, manager.active[i]);
        assertEquals(c.m_proxyA, manager.proxies[2 * i]);
        assertEquals(c.m_proxyB, manager.proxies[2 * i + 1]);
        int state = Contact.TOUCHING_FLAG | Contact.ENABLED_FLAG | Contact.FILTER_FLAG;
        assertTrue(!manager.apart[i] || (c.m_flags & state) == Contact.ENABLED_FLAG, "overlooked");
        active++;
      }
    }
    assertEquals(active, manager.activeCount);
  }

  private static void checkJoints(World world) {
    int joints = 0;
    Joint before = null;
    for (Joint j = world.getJointList(); j != null; j = j.getNext()) {
      joints++;
      assertSame(before, j.m_prev);
      assertFalse(j.m_islandFlag);
      assertTrue(holds(j.getBodyA(), j) && holds(j.getBodyB(), j));
      before = j;
    }
    assertEquals(joints, world.getJointCount());
  }

  private static boolean holds(Body body, Joint joint) {
    for (JointEdge edge = body.getJointList(); edge != null; edge = edge.next) {
      if (edge.joint == joint) {
        return true;
      }
    }
    return false;
  }
}
