package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

/** The introductory listing of the thesis runs as it is. */
class ThesisListingTest {
  /** Thesis, section 2.2 and 8.2: the words of the listing, with its slips of the pen corrected. */
  @Test
  void introductorySceneOfTheThesis() {
    World w = new World(new Vec2(0, -9.81f));
    BodyDef bd = new BodyDef();
    bd.setType(BodyType.STATIC);
    Body ground = w.createBody(bd);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-10, 0), new Vec2(10, 0));
    Fixture f1 = ground.createFixture(edge, 0.0f);
    bd.type = BodyType.DYNAMIC;
    bd.position = new Vec2(0.0f, 5.0f);
    Body target = w.createBody(bd);
    PolygonShape cube = new PolygonShape();
    cube.setAsBox(5.0f, 5.0f);
    Fixture f2 = target.createFixture(cube, 1.0f);
    f2.m_friction = 0.2f;
    f2.m_restitution = 0.0f;
    f2.m_material = Material.UNIFORM;
    bd.type = BodyType.DYNAMIC;
    bd.position = new Vec2(-30.0f, 5.3f);
    bd.linearVelocity = new Vec2(100.0f, 0.0f);
    Body bullet = w.createBody(bd);
    CircleShape circle = new CircleShape();
    circle.m_radius = 1.0f;
    Fixture f3 = bullet.createFixture(circle, 2.0f);
    f3.m_friction = 0.4f;
    f3.m_restitution = 0.1f;
    for (int i = 0; i < 60; i++) {
      w.step(1f / 60, 8, 8);
    }
    assertTrue(w.getBodyCount() > 10, w.getBodyCount() + " bodies");
    int fixtures = 0;
    for (Body b = w.getBodyList(); b != null; b = b.getNext()) {
      for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
        fixtures++;
      }
    }
    assertTrue(fixtures >= w.getBodyCount());
    assertEquals(ground, f1.getBody());
  }
}
