package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The adaptive solver sees what buckles, sags and stretches, and what does not. */
class AdaptiveEffortTest {
  /**
   * 16 bricks on each other, a little out of line. With the two substeps that the weight alone asks
   * for the column swayed more and more, and fell within four seconds.
   */
  @Test
  void aColumnOfBricksStands() {
    World world = world();
    floor(world);
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

  /**
   * A brick that lies on the floor needs the least substeps there are. It kept three for ever:
   * seven tenths of three, rounded up.
   */
  @Test
  void whatLiesStillGetsTheLeast() {
    World world = world();
    floor(world);
    Body brick = brick(world, 0f, 0.1f, 0.2f);
    for (int i = 0; i < 180; i++) {
      world.step(1f / 60f, 8, 3);
    }
    assertEquals(Solver.adaptive().getLeastSubsteps(), brick.effort);
  }

  /**
   * Two planks and a hinge fall at 15 m/s. A blow is no load, and the spin that it gives a plank
   * ends on the floor; they had six substeps and more for four seconds, which a swing may need.
   */
  @Test
  void aBlowIsSoonForgotten() {
    World world = world();
    floor(world);
    Body a = brick(world, 0f, 3f, 0.3f);
    Body b = brick(world, 0.6f, 3f, 0.3f);
    RevoluteJointDef hinge = new RevoluteJointDef();
    hinge.initialize(a, b, new Vec2(0.3f, 3f));
    world.createJoint(hinge);
    for (Body plank : new Body[] {a, b}) {
      plank.setLinearVelocity(new Vec2(0f, -15f));
    }
    b.setAngularVelocity(30f);
    int most = 0;
    for (int i = 0; i < 240; i++) {
      world.step(1f / 60f, 8, 3);
      most = Math.max(most, b.effort);
    }
    assertTrue(most > 4);
    assertTrue(b.effort <= 4, "still " + b.effort + " of " + most);
  }

  /**
   * The same, falling at 8 m/s and thrown up again by a floor that bounces: what the blow has asked
   * for is not kept in the air, nor for half a second on the floor. In two seconds it was 6.2
   * substeps on average, with eight at most.
   */
  @Test
  void limbsThatABlowHasTurnedAreSlowAgainSoon() {
    World world = world();
    Body floor = Make.body(world, BodyType.STATIC, 0f, -0.5f);
    floor.createFixture(Make.boxShape(10f, 0.5f), 0f).setRestitution(0.4f);
    Body a = brick(world, 0f, 3f, 0.3f);
    Body b = brick(world, 0.6f, 3f, 0.3f);
    RevoluteJointDef hinge = new RevoluteJointDef();
    hinge.initialize(a, b, new Vec2(0.3f, 3f));
    hinge.enableLimit = true;
    hinge.lowerAngle = -0.5f;
    hinge.upperAngle = 0.5f;
    world.createJoint(hinge);
    for (Body plank : new Body[] {a, b}) {
      plank.setLinearVelocity(new Vec2(0f, -8f));
    }
    a.setAngularVelocity(-20f);
    int most = 0;
    int sum = 0;
    for (int i = 0; i < 120; i++) {
      world.step(1f / 60f, 8, 3);
      most = Math.max(most, b.effort);
      sum += b.effort;
    }
    assertTrue(most > 6, "most " + most);
    assertTrue(sum < 120 * 5.4, "mean " + sum / 120f + ", most " + most);
  }

  /**
   * Bricks that fall on each other look like a column while they strike. What does so for a step or
   * two does not get all that a column needs: there is one substep more a step at most.
   */
  @Test
  void bricksThatFallOnEachOtherAreNotYetAColumn() {
    World world = world();
    floor(world);
    Body[] bricks = new Body[12];
    for (int i = 0; i < bricks.length; i++) {
      bricks[i] = brick(world, 0.01f * (i % 3), 0.22f * i + 0.2f, 0.1f);
    }
    int before = 3;
    for (int i = 0; i < 30; i++) {
      world.step(1f / 60f, 8, 3);
      int now = bricks[0].effort;
      assertTrue(now <= before + 1, "step " + i + ": from " + before + " to " + now);
      before = Math.max(before, now);
    }
    assertTrue(before > 5, "up to " + before);
  }

  /**
   * 200 links are let go level, or hang. Four substeps were all that so many joints could have, and
   * the chain that was let go stretched by 60 %. A link is 20 cm long: 5 % are two slops for each.
   */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aLongChainHardlyStretches(boolean hangs) {
    World world = world();
    int links = 200;
    float length = 0.2f;
    Body last = world.createBody(new BodyDef());
    for (int i = 0; i < links; i++) {
      float at = (i + 0.5f) * length;
      Body link = Make.body(world, BodyType.DYNAMIC, hangs ? 0f : at, hangs ? -at : 0f);
      link.createFixture(Make.boxShape(hangs ? 0.03f : 0.1f, hangs ? 0.1f : 0.03f), 1f)
          .setSensor(true);
      RevoluteJointDef hinge = new RevoluteJointDef();
      float end = i * length;
      hinge.initialize(last, link, new Vec2(hangs ? 0f : end, hangs ? -end : 0f));
      world.createJoint(hinge);
      last = link;
    }
    float longest = 0f;
    for (int i = 0; i < 300; i++) {
      world.step(1f / 60f, 8, 3);
      longest = Math.max(longest, last.getWorldCenter().length() + 0.5f * length);
    }
    assertEquals(1f, longest / (links * length), 0.05f);
  }

  private static void floor(World world) {
    Body floor = Make.body(world, BodyType.STATIC, 0f, -0.5f);
    floor.createFixture(Make.boxShape(10f, 0.5f), 0f);
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
