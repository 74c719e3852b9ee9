package org.jbox2d.testbed.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

class BodyOutlineTest {
  private final Body body = new World(new Vec2()).createBody(new BodyDef());

  private void addPolygon(float... xy) {
    Vec2[] vertices = new Vec2[xy.length / 2];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = new Vec2(xy[2 * i], xy[2 * i + 1]);
    }
    PolygonShape shape = new PolygonShape();
    shape.set(vertices, vertices.length);
    body.createFixture(shape, 1f);
  }

  private int innerEdges(BodyOutline outline) {
    int count = 0;
    for (int i = 0; i < outline.start(outline.partCount()); i++) {
      count += outline.isInner(i) ? 1 : 0;
    }
    return count;
  }

  @Test
  void edgeOfTwoPartsIsInnerInBoth() {
    addPolygon(0, 0, 1, 0, 1, 1, 0, 1);
    addPolygon(1, 0, 3, 0, 3, 1, 1, 1);
    BodyOutline outline = new BodyOutline(0, body);
    assertEquals(2, outline.partCount());
    assertEquals(2, innerEdges(outline));
    for (int i = 0; i < 4; i++) {
      int next = i == 3 ? 0 : i + 1;
      boolean shared = outline.x(i) == 1f && outline.x(next) == 1f;
      assertEquals(shared, outline.isInner(i));
    }
  }

  @Test
  void edgesThatOnlyTouchAreNotInner() {
    addPolygon(0, 0, 1, 0, 1, 1, 0, 1);
    addPolygon(1, 0.5f, 3, 0.5f, 3, 1.5f, 1, 1.5f);
    assertEquals(0, innerEdges(new BodyOutline(0, body)));
  }

  @Test
  void circleIsOnePointAndItsRadius() {
    CircleShape circle = new CircleShape();
    circle.m_radius = 2f;
    circle.m_p.set(3f, 4f);
    body.createFixture(circle, 1f);
    BodyOutline outline = new BodyOutline(0, body);
    assertEquals(1, outline.start(1) - outline.start(0));
    assertEquals(2f, outline.radius(0));
    assertEquals(3f, outline.x(0));
    assertEquals(4f, outline.y(0));
  }

  @Test
  void anotherFixtureMakesTheOutlineStale() {
    addPolygon(0, 0, 1, 0, 1, 1, 0, 1);
    BodyOutline outline = new BodyOutline(0, body);
    assertTrue(outline.isOf(body));
    addPolygon(1, 0, 3, 0, 3, 1, 1, 1);
    assertFalse(outline.isOf(body));
  }
}
