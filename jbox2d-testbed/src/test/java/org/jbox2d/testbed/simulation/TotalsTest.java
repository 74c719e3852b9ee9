package org.jbox2d.testbed.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

class TotalsTest {
  private static final double ROUNDING = 1e-4;

  private final World world = new World(new Vec2(0f, -10f));

  private Body square(BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    Body body = world.createBody(def);
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(1f, 1f);
    body.createFixture(shape, 2f);
    return body;
  }

  @Test
  void sumsOfOneMovingSquare() {
    Body body = square(BodyType.DYNAMIC, 3f, 4f);
    body.setLinearVelocity(new Vec2(5f, 6f));
    body.setAngularVelocity(7f);
    Totals totals = Totals.of(world);
    double m = 8;
    double inertia = m * (4 + 4) / 12;
    assertEquals(m, totals.mass(), ROUNDING);
    assertEquals(5 * m, totals.momentumX(), ROUNDING);
    assertEquals(6 * m, totals.momentumY(), ROUNDING);
    assertEquals(m * (3 * 6 - 4 * 5) + inertia * 7, totals.angularMomentum(), ROUNDING);
    assertEquals(0.5 * (m * (25 + 36) + inertia * 49), totals.kineticEnergy(), 10 * ROUNDING);
    assertEquals(m * 10 * 4, totals.potentialEnergy(), ROUNDING);
  }

  @Test
  void staticBodiesCountWithTheirMassAlone() {
    square(BodyType.STATIC, 3f, 4f);
    Totals totals = Totals.of(world);
    assertEquals(8, totals.mass(), ROUNDING);
    assertEquals(0, totals.potentialEnergy());
  }

  @Test
  void hashTellsStatesApart() {
    Body body = square(BodyType.DYNAMIC, 3f, 4f);
    long before = StateHash.of(world);
    assertEquals(before, StateHash.of(world));
    body.m_linearVelocity.x = Math.nextUp(body.m_linearVelocity.x);
    assertNotEquals(before, StateHash.of(world));
  }
}
