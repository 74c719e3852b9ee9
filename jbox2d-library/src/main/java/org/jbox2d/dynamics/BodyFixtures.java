package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.Shape;

/** Adds fixtures to a body and removes them. The body has checked that it may change. */
final class BodyFixtures {
  private BodyFixtures() {}

  static Fixture create(Body body, FixtureDef def) {
    Checks.notNull(def, "def");
    def.check();
    Checks.shape(def.shape, "FixtureDef.shape");
    Fixture fixture = add(body, def);
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
      Checks.shape(parts[i], "CompoundShape.getParts()[" + i + "]");
    }
    List<Fixture> fixtures = new ArrayList<>(parts.length);
    Shape given = def.shape;
    for (Shape part : parts) {
      def.shape = part;
      Fixture fixture = add(body, def);
      fixture.setCompound(compound);
      fixtures.add(fixture);
    }
    def.shape = given;
    if (def.density > 0f) {
      body.resetMassData();
    }
    return fixtures;
  }

  private static Fixture add(Body body, FixtureDef def) {
    Fixture fixture = new Fixture();
    fixture.create(body, def);
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

  static void destroy(Body body, Fixture fixture) {
    // Contacts first: they call the listener, which may throw, or destroy the fixture itself.
    body.destroyContactsOf(fixture);
    if (fixture.m_body != body) {
      return;
    }
    unlink(body, fixture);
    if (body.isActive()) {
      fixture.destroyProxies(body.m_world.m_contactManager.m_broadPhase);
    }
    fixture.destroy();
    fixture.m_body = null;
    body.m_fixtureCount--;
    body.resetMassData();
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
