package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.junit.jupiter.api.Test;

/** The adaptive solver sees what buckles and what sags. */
class AdaptiveEffortTest {
  /**
   * 16 bricks on each other, a little out of line. With the two substeps that the weight alone asks
   * for the column swayed more and more, and fell within four seconds.
   */
  @Test
  void aColumnOfBricksStands() {
    World world = world();
    PolygonShape floor = new PolygonShape();
    floor.setAsBox(10f, 0.5f, new Vec2(0f, -0.5f), 0f);
    world.createBody(new BodyDef()).createFixture(floor, 0f);
    Body[] bricks = new Body[16];
    for (int i = 0; i < bricks.length; i++) {
      bricks[i] = brick(world, 0.02f * (i % 3 - 1), 0.2f * i + 0.1f, 0.2f);
    }
    for (int i = 0; i < 600; i++) {
      world.step(1f / 60f, 8, 3);
    }
    for (int i = 0; i < bricks.length; i++) {
      assertEquals(0.02f * (i % 3 - 1), bricks[i].getPosition().x, 0.02f);
      assertEquals(0.2f * i + 0.1f, bricks[i].getPosition().y, 0.1f);
    }
  }

  /**
   * A beam of six planks, welded to a wall and to each other, 3.6 m long. Its end sank by 0.32 m: a
   * weld that bears a moment asked for no more substeps than one that bears none.
   */
  @Test
  void aWeldedBeamHardlySags() {
    World world = world();
    Body last = world.createBody(new BodyDef());
    for (int i = 0; i < 6; i++) {
      Body plank = brick(world, 0.6f * i + 0.3f, 0f, 0.3f);
      WeldJointDef weld = new WeldJointDef();
      weld.initialize(last, plank, new Vec2(0.6f * i, 0f));
      world.createJoint(weld);
      last = plank;
    }
    float lowest = 0f;
    for (int i = 0; i < 300; i++) {
      world.step(1f / 60f, 8, 3);
      lowest = Math.min(lowest, last.getPosition().y);
    }
    assertEquals(0f, lowest, 0.16f);
    assertEquals(0f, last.getPosition().y, 0.1f);
  }

  private static World world() {
    World world = new World(new Vec2(0f, -10f));
    world.setSolver(Solver.adaptive());
    world.setAllowSleep(false);
    return world;
  }

  private static Body brick(World world, float x, float y, float halfWidth) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, y);
    PolygonShape box = new PolygonShape();
    box.setAsBox(halfWidth, 0.1f);
    FixtureDef fixture = new FixtureDef();
    fixture.shape = box;
    fixture.density = 2f;
    fixture.friction = 0.5f;
    Body body = world.createBody(def);
    body.createFixture(fixture);
    return body;
  }
}
