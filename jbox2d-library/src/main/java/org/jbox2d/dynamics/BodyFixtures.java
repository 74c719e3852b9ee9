package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.narrowphase.PartShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;

/** Adds fixtures to a body and removes them. The body has checked that it may change. */
final class BodyFixtures {
  private BodyFixtures() {}

  static Fixture create(Body body, FixtureDef def) {
    Checks.notNull(def, "def");
    def.check();
    Checks.shape(def.shape, "FixtureDef.shape");
    Fixture fixture = add(body, def, def.shape.clone());
    if (fixture.m_density > 0f) {
      body.resetMassData();
    }
    return fixture;
  }

  static List<Fixture> createAll(Body body, FixtureDef def, CompoundShape compound) {
    Checks.notNull(def, "def");
    Checks.notNull(compound, "compound");
    def.check();
    Shape[] parts = compound.getParts();
    Checks.notNull(parts, "CompoundShape.getParts()");
    if (parts.length == 0) {
      throw new IllegalArgumentException("CompoundShape.getParts() is empty");
    }
    for (int i = 0; i < parts.length; i++) {
      Checks.part(parts, i);
    }
    List<Fixture> fixtures = new ArrayList<>(parts.length);
    PartShape[] linked = PartShape.link(parts);
    for (int i = 0; i < parts.length; i++) {
      boolean isLinked = linked != null && linked[i] != null;
      Fixture fixture = add(body, def, isLinked ? linked[i] : parts[i].clone());
      fixture.setCompound(compound);
      fixtures.add(fixture);
    }
    if (def.density > 0f) {
      body.resetMassData();
    }
    return fixtures;
  }

  /** The shape is the fixture's own. */
  private static Fixture add(Body body, FixtureDef def, Shape shape) {
    Fixture fixture = new Fixture();
    fixture.create(body, def, shape);
    if (body.isActive()) {
      fixture.createProxies(body.m_world.m_contactManager.m_broadPhase, body.m_xf);
    }
    fixture.m_next = body.m_fixtureList;
    body.m_fixtureList = fixture;
    body.m_fixtureCount++;
    body.thickness = -1f;
    body.m_world.lookForPairs();
    return fixture;
  }

  /** Throws if the fixture is not of the body. */
  static void checkOwn(Body body, Fixture fixture) {
    Checks.notNull(fixture, "fixture");
    if (fixture.m_body != body) {
      throw new IllegalArgumentException("fixture is not of this body, or was destroyed before");
    }
  }

  /** Removes a fixture and computes the mass anew. */
  static void remove(Body body, Fixture fixture) {
    destroy(body, fixture);
    resetMassUnlessDestroyed(body);
  }

  /** Removes fixtures and computes the mass anew, whatever a listener throws. */
  static void removeAll(Body body, List<Fixture> fixtures) {
    try {
      destroyAll(body, fixtures);
    } finally {
      resetMassUnlessDestroyed(body);
    }
  }

  /** A listener may have destroyed the body. */
  private static void resetMassUnlessDestroyed(Body body) {
    if (body.m_world != null) {
      body.resetMassData();
    }
  }

  /** Removes a fixture, unless a listener has done so meanwhile; does not compute the mass anew. */
  private static void destroy(Body body, Fixture fixture) {
    // Contacts first: they call the listener, which may throw, or destroy fixture or body itself.
    BodyContacts.destroy(body, fixture);
    if (fixture.m_body != body || body.m_world == null) {
      return;
    }
    unlink(body, fixture);
    if (fixture.m_shape instanceof PartShape) {
      ((PartShape) fixture.m_shape).leave();
    }
    if (body.isActive()) {
      fixture.destroyProxies(body.m_world.m_contactManager.m_broadPhase);
    }
    fixture.destroy();
    fixture.m_body = null;
    body.m_fixtureCount--;
  }

  /** As {@link #destroy} of each. */
  private static void destroyAll(Body body, List<Fixture> fixtures) {
    if (body.m_world.m_contactManager.m_contactListener == null) {
      destroyContacts(body, fixtures);
    }
    for (Fixture fixture : fixtures) {
      if (fixture.m_body == body && body.m_world != null) {
        destroy(body, fixture);
      }
    }
  }

  /**
   * Destroys the contacts of fixtures in the order in which they would go with one fixture after
   * the other, on which the order of the other contacts depends; but looks at each contact of the
   * body twice rather than once for each fixture. Nobody must hear of it, for who did could change
   * more.
   */
  private static void destroyContacts(Body body, List<Fixture> fixtures) {
    int n = fixtures.size();
    for (int i = 0; i < n; i++) {
      fixtures.get(i).leavingIndex = i;
    }
    int[] end = new int[n + 1];
    for (ContactEdge edge = body.m_contactList; edge != null; edge = edge.next) {
      end[leavingIndex(body, edge) + 1]++;
    }
    // Contacts of fixtures that stay are counted first, and not taken.
    end[0] = 0;
    for (int i = 1; i <= n; i++) {
      end[i] += end[i - 1];
    }
    Contact[] leaving = new Contact[end[n]];
    for (ContactEdge edge = body.m_contactList; edge != null; edge = edge.next) {
      int index = leavingIndex(body, edge);
      if (index >= 0) {
        leaving[end[index]++] = edge.contact;
      }
    }
    for (Contact contact : leaving) {
      body.m_world.m_contactManager.destroy(contact);
    }
  }

  private static int leavingIndex(Body body, ContactEdge edge) {
    Contact c = edge.contact;
    return (c.m_fixtureA.m_body == body ? c.m_fixtureA : c.m_fixtureB).leavingIndex;
  }

  private static void unlink(Body body, Fixture fixture) {
    Fixture before = null;
    Fixture f = body.m_fixtureList;
    while (f != fixture) {
      before = f;
      f = f.m_next;
    }
    if (before == null) {
      body.m_fixtureList = fixture.m_next;
    } else {
      before.m_next = fixture.m_next;
    }
  }
}
