package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What calms down sleeps, and what disturbs it wakes it. */
class SleepTest {
  private final World world = Make.world();
  private final Body ground = Make.ground(world);
  private final Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);

  @BeforeEach
  void sleep() {
    Make.steps(world, 60);
    assertFalse(box.isAwake());
  }

  @AfterEach
  void allAgrees() {
    WorldInvariants.check(world);
    Make.steps(world, 5);
    WorldInvariants.check(world);
  }

  @Test
  void theSleepingDoNotMove() {
    float y = box.getPosition().y;
    Make.steps(world, 60);
    assertEquals(y, box.getPosition().y);
    assertEquals(0f, box.getLinearVelocity().length());
  }

  @Test
  void aTouchWakes() {
    Body ball = Make.disc(world, 0f, 3f, 0.3f);
    boolean woke = false;
    for (int i = 0; i < 60; i++) {
      world.step(Make.STEP, 8, 3);
      woke |= box.isAwake();
    }
    assertTrue(woke);
    Make.steps(world, 200);
    assertFalse(box.isAwake() || ball.isAwake());
  }

  @Test
  void passingNearbyDoesNotWake() {
    Body ball = Make.disc(world, 1.05f, 3f, 0.5f);
    ball.setFixedRotation(true);
    for (int i = 0; i < 30; i++) {
      world.step(Make.STEP, 8, 3);
      assertFalse(box.isAwake());
    }
  }

  @Test
  void theTouchOfASensorDoesNotWake() {
    Body ball = Make.body(world, BodyType.DYNAMIC, 0f, 2f);
    FixtureDef def = new FixtureDef();
    def.shape = Make.circle(0.3f);
    def.isSensor = true;
    ball.createFixture(def);
    ball.setGravityScale(0.2f);
    for (int i = 0; i < 60; i++) {
      world.step(Make.STEP, 8, 3);
      assertFalse(box.isAwake());
    }
  }

  @Test
  void eachPushWakes() {
    Runnable[] pushes = {
      () -> box.applyForceToCenter(new Vec2(1f, 0f)),
      () -> box.applyForce(new Vec2(1f, 0f), new Vec2()),
      () -> box.applyTorque(1f),
      () -> box.applyLinearImpulse(new Vec2(1f, 0f), new Vec2()),
      () -> box.applyAngularImpulse(1f),
      () -> box.setLinearVelocity(new Vec2(1f, 0f)),
      () -> box.setAngularVelocity(1f),
      () -> box.setAwake(true),
    };
    for (Runnable push : pushes) {
      box.setAwake(false);
      WorldInvariants.check(world);
      push.run();
      assertTrue(box.isAwake());
      WorldInvariants.check(world);
    }
  }

  @Test
  void anImpulseThatIsNotToWakeDoesNothingToASleeper() {
    box.applyLinearImpulse(new Vec2(5f, 5f), new Vec2(), false);
    assertFalse(box.isAwake());
    assertEquals(0f, box.getLinearVelocity().length());
  }

  @Test
  void settingNoVelocityDoesNotWake() {
    box.setLinearVelocity(new Vec2());
    box.setAngularVelocity(0f);
    assertFalse(box.isAwake());
  }

  @Test
  void destroyingTheGroundWakes() {
    world.destroyBody(ground);
    assertTrue(box.isAwake());
    Make.steps(world, 30);
    assertTrue(box.getPosition().y < 0f);
  }

  @Test
  void destroyingTheGroundsFixtureWakes() {
    ground.destroyFixture(ground.getFixtureList());
    assertTrue(box.isAwake());
  }

  @Test
  void movingTheGroundAwayWakes() {
    ground.setTransform(new Vec2(0f, -2f), 0f);
    Make.steps(world, 120);
    assertEquals(-1.5f, box.getPosition().y, 0.03f);
  }

  @Test
  void puttingTheGroundWhereItIsDoesNotWake() {
    ground.setTransform(new Vec2(0f, 0f), 0f);
    Make.steps(world, 2);
    assertFalse(box.isAwake());
  }

  @Test
  void deactivatingTheGroundWakes() {
    ground.setActive(false);
    assertTrue(box.isAwake());
    Make.steps(world, 30);
    assertTrue(box.getPosition().y < 0f);
  }

  @Test
  void makingTheGroundASensorWakes() {
    ground.getFixtureList().setSensor(true);
    Make.steps(world, 30);
    assertTrue(box.getPosition().y < 0f);
  }

  @Test
  void filteringTheGroundOutWakes() {
    Filter filter = new Filter();
    filter.maskBits = 0;
    ground.getFixtureList().setFilterData(filter);
    Make.steps(world, 30);
    assertTrue(box.getPosition().y < 0f);
  }

  @Test
  void filteringWithoutEffectLetsSleep() {
    ground.getFixtureList().refilter();
    Make.steps(world, 3);
    assertFalse(box.isAwake());
    assertEquals(0, world.getContactManager().activeCount);
  }

  @Test
  void aStaticBodyPutIntoASleeperWakesIt() {
    Make.box(world, BodyType.STATIC, 0.4f, 0.5f, 0.2f, 0.2f);
    Make.steps(world, 2);
    assertTrue(box.isAwake());
    Make.steps(world, 60);
    assertTrue(box.getPosition().x < -0.2f, "pushed out");
  }

  @Test
  void aStaticFixtureAddedToTheGroundWakesWhatItTouches() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-3f, 0.2f), new Vec2(3f, 0.2f));
    ground.createFixture(edge, 0f);
    Make.steps(world, 2);
    assertTrue(box.isAwake());
  }

  @Test
  void changingTheTypeWakes() {
    box.setType(BodyType.STATIC);
    WorldInvariants.check(world);
    box.setType(BodyType.DYNAMIC);
    assertTrue(box.isAwake());
    assertEquals(1f, box.getMass(), 1e-5f);
  }

  @Test
  void changingTheTypeOfTheNeighbourWakes() {
    Body floor = Make.box(world, BodyType.STATIC, 5f, 1f, 1f, 0.2f);
    Body load = Make.box(world, BodyType.DYNAMIC, 5f, 1.75f, 0.5f, 0.5f);
    Make.steps(world, 80);
    assertFalse(load.isAwake());
    floor.setType(BodyType.DYNAMIC);
    Make.steps(world, 60);
    assertTrue(load.getPosition().y < 1f);
  }

  @Test
  void aMovedTargetWakes() {
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = box;
    def.target.set(box.getPosition());
    def.maxForce = 100f;
    org.jbox2d.dynamics.joints.MouseJoint joint =
        (org.jbox2d.dynamics.joints.MouseJoint) world.createJoint(def);
    assertFalse(box.isAwake());
    joint.setTarget(new Vec2(0f, 3f));
    Make.steps(world, 60);
    assertEquals(3f, box.getPosition().y, 0.3f);
  }

  @Test
  void destroyingAJointWakes() {
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = box;
    def.target.set(box.getPosition());
    Joint joint = world.createJoint(def);
    box.setAwake(false);
    world.destroyJoint(joint);
    assertTrue(box.isAwake());
  }

  @Test
  void aBodyThatMayNotSleepKeepsItsIslandAwake() {
    Body top = Make.box(world, BodyType.DYNAMIC, 0f, 1.53f, 0.5f, 0.5f);
    top.setSleepingAllowed(false);
    Make.steps(world, 120);
    assertTrue(top.isAwake() && box.isAwake());
    top.setSleepingAllowed(true);
    Make.steps(world, 60);
    assertFalse(top.isAwake() || box.isAwake());
  }

  @Test
  void forbiddingSleepWakesAll() {
    world.setSleepingAllowed(false);
    assertTrue(box.isAwake());
    Make.steps(world, 120);
    assertTrue(box.isAwake());
    world.setSleepingAllowed(true);
    Make.steps(world, 60);
    assertFalse(box.isAwake());
  }

  @Test
  void aBodyMadeAsleepHangsUntilItIsWoken() {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.awake = false;
    def.position.set(4f, 4f);
    Body hanging = world.createBody(def);
    hanging.createFixture(Make.circle(0.5f), 1f);
    Make.steps(world, 10);
    assertEquals(4f, hanging.getPosition().y);
    hanging.setAwake(true);
    Make.steps(world, 10);
    assertTrue(hanging.getPosition().y < 4f);
  }

  @Test
  void puttingToSleepStops() {
    box.setAwake(true);
    box.setLinearVelocity(new Vec2(3f, 3f));
    box.applyTorque(5f);
    box.setAwake(false);
    assertEquals(0f, box.getLinearVelocity().length());
    assertEquals(0f, box.m_torque);
    Make.steps(world, 10);
    assertFalse(box.isAwake());
  }
}
