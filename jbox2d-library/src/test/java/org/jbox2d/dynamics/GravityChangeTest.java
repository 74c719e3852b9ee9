package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** What gravity held together is not thrown apart by impulses kept from before it changed. */
class GravityChangeTest {
  private static final int BOXES = 10;
  private final Body[] boxes = new Body[BOXES];

  /** Before, the impulses of the last step threw the stack up at 0.29 m/s. */
  @Test
  void aStackStaysAtRestWhenGravityEnds() {
    World world = stack(Solver.sequentialImpulses());
    world.setGravity(new Vec2(0f, 0f));
    assertTrue(fastest(world, 60) < 0.001f);
  }

  /**
   * Soft contacts give back the way by which they were pressed. That threw the stack up at 0.24
   * m/s, and at 0.07 when what was above 0.05 of the mean energy was taken away.
   */
  @Test
  void withSubstepsItComesApartSlowly() {
    assertTrue(fastestWithout(Solver.softStep(4)) < 0.02f);
    assertTrue(fastestWithout(Solver.adaptive()) < 0.02f);
  }

  private float fastestWithout(Solver solver) {
    World world = stack(solver);
    world.setGravity(new Vec2(0f, 0f));
    return fastest(world, 60);
  }

  /**
   * Where gravity changes by a tenth in each step, and leans, the stack neither sinks nor drifts.
   */
  @Test
  void aStackStandsWhileGravityRocks() {
    World world = stack(Solver.sequentialImpulses());
    float top = boxes[BOXES - 1].getPosition().y;
    for (int i = 0; i < 240; i++) {
      float lean = 0.2f * (i % 60 < 30 ? 1f : -1f);
      world.setGravity(new Vec2(lean, -10f - (i % 2)));
      world.step(1f / 60f, 8, 3);
    }
    assertEquals(top, boxes[BOXES - 1].getPosition().y, 0.03f);
    assertEquals(0f, boxes[BOXES - 1].getPosition().x, 0.05f);
  }

  private World stack(Solver solver) {
    World world = new World(new Vec2(0f, -10f));
    world.setSolver(solver);
    world.setAllowSleep(false);
    PolygonShape floor = new PolygonShape();
    floor.setAsBox(10f, 0.5f);
    world.createBody(new BodyDef()).createFixture(floor, 0f);
    for (int i = 0; i < BOXES; i++) {
      BodyDef def = new BodyDef();
      def.type = BodyType.DYNAMIC;
      def.position.set(0f, i + 1f);
      PolygonShape box = new PolygonShape();
      box.setAsBox(0.5f, 0.5f);
      boxes[i] = world.createBody(def);
      boxes[i].createFixture(box, 1f);
    }
    for (int i = 0; i < 150; i++) {
      world.step(1f / 60f, 8, 3);
    }
    return world;
  }

  private float fastest(World world, int steps) {
    float fastest = 0f;
    for (int i = 0; i < steps; i++) {
      world.step(1f / 60f, 8, 3);
      for (Body box : boxes) {
        fastest = Math.max(fastest, box.getLinearVelocity().length());
      }
    }
    return fastest;
  }
}
