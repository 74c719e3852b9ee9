package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.RopeJointDef;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Islands sleep when their bodies stay where they are, whatever their velocities are. */
class StillnessTest {
  private static final int STEPS_A_SECOND = 60;

  private final World world = Make.weightless();
  private final Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 0.5f, 0.5f);

  @Test
  void whatTremblesOnTheSpotFallsAsleepAfterTwoSeconds() {
    float seconds = trembleUntilAsleep(box, 0.1f, 5);
    assertEquals(2f, seconds, 0.1f);
    assertEquals(0f, box.getLinearVelocity().length());
  }

  @Test
  void whatTremblesWithAWiderSwingStaysAwake() {
    assertEquals(10f, trembleUntilAsleep(box, 2f, 10));
  }

  @Test
  void whatTremblesWithinAnIslandLetsAllOfItSleep() {
    Body ground = Make.body(world, BodyType.STATIC, 0f, -1f);
    ground.createFixture(Make.boxShape(5f, 0.5f), 0f);
    world.setGravity(new Vec2(0f, -Make.G));
    Body top = Make.box(world, BodyType.DYNAMIC, 0f, 1f, 0.5f, 0.5f);
    trembleUntilAsleep(top, 0.05f, 10);
    assertTrue(!top.isAwake() && !box.isAwake());
  }

  /** A spring or a motor may tremble for a purpose, unless nobody can see it. */
  @Test
  void whatHangsAtAJointMaySwingByAQuarter() {
    Body ground = Make.body(world, BodyType.STATIC, 0f, 0f);
    RopeJointDef def = new RopeJointDef();
    def.bodyA = ground;
    def.bodyB = box;
    def.maxLength = 10f;
    world.createJoint(def);
    assertEquals(5f, trembleUntilAsleep(box, 0.6f, 5));
    assertTrue(trembleUntilAsleep(box, 0.2f, 5) < 2.5f);
  }

  /** A row of boxes that touch; the first slides along the second, without friction. */
  private float creepBesideARow(int boxes, float speed, int seconds) {
    Make.surface(box, 0f, 0f);
    float apart = 1f + 2f * Settings.polygonRadius - Settings.linearSlop;
    for (int i = 1; i <= boxes; i++) {
      Make.box(world, BodyType.DYNAMIC, apart * i, 0f, 0.5f, 0.5f);
    }
    for (int i = 0; i < seconds * STEPS_A_SECOND; i++) {
      box.m_linearVelocity.y = speed;
      Make.steps(world, 1);
      if (!box.isAwake()) {
        return (float) i / STEPS_A_SECOND;
      }
    }
    return seconds;
  }

  /** A heap sleeps if one of many creeps, as one always does; see {@link IslandSleep}. */
  @Test
  void oneThatCreepsAmongManyLetsThemSleep() {
    assertEquals(2f, creepBesideARow(20, 0.03f, 6), 0.2f);
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      assertFalse(b.isAwake());
    }
  }

  @Test
  void oneThatCreepsAmongFewKeepsThemAwake() {
    assertEquals(6f, creepBesideARow(14, 0.03f, 6));
  }

  @Test
  void oneThatGoesFasterKeepsManyAwake() {
    assertEquals(6f, creepBesideARow(20, 0.06f, 6));
  }

  @Test
  void oneThatIsHeavyKeepsManyAwake() {
    MassData mass = new MassData();
    box.getMassData(mass);
    mass.mass *= 3f;
    mass.I *= 3f;
    box.setMassData(mass);
    assertEquals(6f, creepBesideARow(20, 0.03f, 6));
  }

  @Test
  void oneThatHangsAtAJointAndCreepsKeepsManyAwake() {
    RopeJointDef def = new RopeJointDef();
    def.bodyA = Make.body(world, BodyType.STATIC, 0f, 0f);
    def.bodyB = box;
    def.maxLength = 10f;
    world.createJoint(def);
    assertEquals(6f, creepBesideARow(20, 0.03f, 6));
  }

  @Test
  void aDrivenBodyStaysAwake() {
    box.setType(BodyType.KINEMATIC);
    assertEquals(5f, trembleUntilAsleep(box, 0.1f, 5));
  }

  /** Just as for calm velocities, 1 cm/s is the bound. */
  @ParameterizedTest
  @ValueSource(floats = {0.011f, 0.02f, 0.1f})
  void whatCreepsOnStaysAwake(float speed) {
    box.setLinearVelocity(new Vec2(speed, 0f));
    Make.steps(world, 20 * STEPS_A_SECOND);
    assertTrue(box.isAwake());
    assertEquals(20f * speed, box.getPosition().x, 1e-3f);
  }

  /** What is slow at its turning point only, goes on. */
  @Test
  void whatTurnsBackStaysAwake() {
    world.setGravity(new Vec2(0f, -0.07f));
    box.setLinearVelocity(new Vec2(0f, 0.2f));
    for (int i = 0; i < 8 * STEPS_A_SECOND; i++) {
      Make.steps(world, 1);
      assertTrue(box.isAwake(), "asleep after step " + i);
    }
    assertEquals(0.2f - 8f * 0.07f, box.getLinearVelocity().y, 1e-3f);
  }

  @Test
  void wakingBeginsAnew() {
    trembleUntilAsleep(box, 0.1f, 5);
    box.setAwake(true);
    assertEquals(2f, trembleUntilAsleep(box, 0.1f, 5), 0.1f);
  }

  /** Turns a body's velocity round in each step; returns after how many seconds it sleeps. */
  private float trembleUntilAsleep(Body body, float speed, int seconds) {
    for (int i = 0; i < seconds * STEPS_A_SECOND; i++) {
      // Not by the setter, which wakes.
      body.m_linearVelocity.x = i % 2 == 0 ? speed : -speed;
      Make.steps(world, 1);
      if (!body.isAwake()) {
        return (float) i / STEPS_A_SECOND;
      }
    }
    return seconds;
  }
}
