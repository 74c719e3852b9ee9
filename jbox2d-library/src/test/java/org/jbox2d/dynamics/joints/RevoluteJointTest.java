package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RevoluteJointTest {
  private static RevoluteJointDef pin(JointScene scene, Body b, float x, float y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(scene.ground, b, new Vec2(x, y));
    return def;
  }

  private static RevoluteJoint make(JointScene scene, RevoluteJointDef def) {
    return (RevoluteJoint) scene.world.createJoint(def);
  }

  /** A level arm of 2 m held by its lower limit: force m g up, torque m g times 1 m. */
  @Test
  void aLimitCarriesAnArm() {
    JointScene scene = new JointScene(JointScene.G);
    Body arm = scene.box(1f, 0f, 1f, 0.1f);
    RevoluteJointDef def = pin(scene, arm, 0f, 0f);
    def.enableLimit = true;
    RevoluteJoint joint = make(scene, def);
    scene.step(240);
    float weight = arm.getMass() * JointScene.G;
    assertEquals(weight, JointScene.force(joint).y, 1e-2f * weight);
    assertEquals(weight, joint.getReactionTorque(1f / JointScene.H), 1e-2f * weight);
    assertEquals(0f, joint.getJointAngle(), 1e-4f);
    assertEquals(0f, JointScene.gap(joint), 1e-4f);
  }

  @Test
  void limitsStopAFallingArmWithoutOvershoot() {
    JointScene scene = new JointScene(JointScene.G);
    Body arm = scene.box(1f, 0f, 1f, 0.1f);
    RevoluteJointDef def = pin(scene, arm, 0f, 0f);
    def.enableLimit = true;
    def.lowerAngle = -0.5f;
    def.upperAngle = 0.25f;
    RevoluteJoint joint = make(scene, def);
    float least = 0f;
    for (int i = 0; i < 240; i++) {
      scene.step(1);
      least = Math.min(least, joint.getJointAngle());
    }
    assertEquals(-0.5f, least, 3e-3f);
    assertEquals(-0.5f, joint.getJointAngle(), 1e-4f);
    scene.world.setGravity(new Vec2(0f, JointScene.G));
    scene.step(240);
    assertEquals(0.25f, joint.getJointAngle(), 1e-4f);
  }

  /**
   * A small bob at the end of a long arm used to bounce at its limit and to tear 0.18 m off its
   * pin, as an angular impulse on it alone hardly stops it.
   */
  @Test
  void aLimitStopsABobFarFromItsPin() {
    World world = new World(new Vec2(0f, -10f));
    Body ground = world.createBody(new BodyDef());
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(0f, 8f);
    Body bob = world.createBody(def);
    CircleShape circle = new CircleShape();
    circle.m_radius = 0.5f;
    bob.createFixture(circle, 5f);
    RevoluteJointDef pin = new RevoluteJointDef();
    pin.initialize(ground, bob, new Vec2());
    pin.enableLimit = true;
    pin.lowerAngle = -0.5f;
    pin.upperAngle = 1.5f;
    RevoluteJoint joint = (RevoluteJoint) world.createJoint(pin);
    bob.setLinearVelocity(new Vec2(-3f, 0f));
    bob.setAngularVelocity(3f / 8f);
    for (int i = 0; i < 240; i++) {
      world.step(1f / 60f, 8, 3);
      assertTrue(joint.getJointAngle() < 1.501f, "beyond the limit");
      assertEquals(8f, bob.getPosition().length(), 0.006f, "distance from the pin");
    }
    assertEquals(1.5f, joint.getJointAngle(), 1e-3f);
    assertEquals(0f, joint.getJointSpeed(), 1e-3f);
  }

  @Test
  void equalLimitsHoldTheAngle() {
    JointScene scene = new JointScene(JointScene.G);
    Body arm = scene.box(1f, 0f, 1f, 0.1f);
    RevoluteJoint joint = make(scene, pin(scene, arm, 0f, 0f));
    joint.setLimits(0.3f, 0.3f);
    joint.enableLimit(true);
    scene.step(120);
    assertEquals(0.3f, joint.getJointAngle(), 1e-4f);
    arm.applyAngularImpulse(5f);
    scene.step(1);
    assertEquals(0f, arm.getAngularVelocity(), 1e-2f);
  }

  @Test
  void aMotorKeepsItsSpeed() {
    JointScene scene = new JointScene(JointScene.G);
    Body wheel = scene.box(0f, 0f, 1f, 1f);
    RevoluteJointDef def = pin(scene, wheel, 0f, 0f);
    def.enableMotor = true;
    def.motorSpeed = 3f;
    def.maxMotorTorque = 1000f;
    RevoluteJoint joint = make(scene, def);
    scene.step(60);
    assertEquals(3f, joint.getJointSpeed(), 1e-4f);
    assertEquals(3f, joint.getJointAngle(), 1e-2f);
    assertEquals(0f, joint.getMotorTorque(60f), 1e-3f);
  }

  /** At its torque limit a motor accelerates a wheel by torque / inertia. */
  @Test
  void aWeakMotorGivesItsTorque() {
    JointScene scene = new JointScene(0f);
    Body wheel = scene.box(0f, 0f, 1f, 1f);
    RevoluteJointDef def = pin(scene, wheel, 0f, 0f);
    def.enableMotor = true;
    def.motorSpeed = -100f;
    def.maxMotorTorque = 2f;
    RevoluteJoint joint = make(scene, def);
    scene.step(60);
    assertEquals(-2f / wheel.getInertia(), joint.getJointSpeed(), 1e-4f);
    assertEquals(-2f, joint.getMotorTorque(60f), 1e-4f);
    assertEquals(-2f, joint.getReactionTorque(60f), 1e-4f);
  }

  @Test
  void aMotorHoldsAnArmAgainstGravityWithItsTorque() {
    JointScene scene = new JointScene(JointScene.G);
    Body arm = scene.box(1f, 0f, 1f, 0.1f);
    RevoluteJointDef def = pin(scene, arm, 0f, 0f);
    def.enableMotor = true;
    def.maxMotorTorque = 100f;
    RevoluteJoint joint = make(scene, def);
    scene.step(120);
    assertEquals(arm.getMass() * JointScene.G, joint.getMotorTorque(60f), 0.05f);
    assertEquals(0f, joint.getJointAngle(), 0.01f);
  }

  /**
   * A physical pendulum, a rod of length 2 pinned at its end: T = 4 sqrt(I / (m g l))
   * K(sin(amplitude / 2)), K(sin 45 degrees) = 1.8540747.
   */
  @Test
  void aRodSwingsWithItsPeriodAndKeepsItsEnergy() {
    JointScene scene = new JointScene(JointScene.G);
    Body rod = scene.box(1f, 0f, 1f, 0.05f);
    RevoluteJoint joint = make(scene, pin(scene, rod, 0f, 0f));
    double mgl = rod.getMass() * JointScene.G;
    double inertia = JointScene.centralInertia(rod) + rod.getMass();
    double expected = 4 * Math.sqrt(inertia / mgl) * 1.8540746773;
    Oscillation swing = new Oscillation(scene, 1200, () -> rod.getWorldCenter().x);
    assertEquals(expected, swing.period(11), 2e-3 * expected);
    assertEquals(0.0, scene.energy(), 0.03 * mgl);
    assertEquals(0f, JointScene.gap(joint), 1e-3f);
  }

  /**
   * The pin of a spinning rod carries m w^2 r, though the step leaves the circle by 1 - cos(w h).
   */
  @ParameterizedTest
  @ValueSource(floats = {1f, 5f, 20f})
  void aSpinningRodKeepsItsSpin(float spin) {
    JointScene scene = new JointScene(0f);
    Body rod = scene.box(1f, 0f, 1f, 0.05f);
    RevoluteJoint joint = make(scene, pin(scene, rod, 0f, 0f));
    rod.setAngularVelocity(spin);
    rod.setLinearVelocity(new Vec2(0f, spin));
    scene.step(300);
    assertEquals(spin, rod.getAngularVelocity(), 0.02f * spin);
    assertEquals(0f, JointScene.gap(joint), 1e-4f);
    float pull = JointScene.force(joint).length();
    assertEquals(rod.getMass() * spin * spin, pull, 0.06f * pull);
  }

  @Test
  void changesWakeTheBodies() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 1f, 1f);
    RevoluteJoint joint = make(scene, pin(scene, b, 0f, 0f));
    b.setSleepingAllowed(true);
    Runnable[] changes = {
      () -> joint.enableLimit(true),
      () -> joint.setLimits(-1f, 1f),
      () -> joint.enableMotor(true),
      () -> joint.setMaxMotorTorque(5f),
      () -> joint.setMotorSpeed(1f)
    };
    for (Runnable change : changes) {
      b.setAwake(false);
      change.run();
      assertTrue(b.isAwake());
      b.setAwake(false);
      change.run();
      assertTrue(!b.isAwake(), "the same value again is no change");
    }
  }

  @Test
  void oneRecordsWhatTheDefinitionSaid() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(1f, 2f, 1f, 1f);
    b.setTransform(new Vec2(1f, 2f), 0.5f);
    RevoluteJointDef def = pin(scene, b, 1f, 2f);
    def.lowerAngle = -1f;
    def.upperAngle = 2f;
    def.motorSpeed = 3f;
    def.maxMotorTorque = 4f;
    RevoluteJoint joint = make(scene, def);
    assertEquals(0.5f, joint.getReferenceAngle());
    assertEquals(new Vec2(1f, 2f), joint.getLocalAnchorA());
    assertEquals(0f, joint.getLocalAnchorB().length(), 1e-6f);
    assertEquals(-1f, joint.getLowerLimit());
    assertEquals(2f, joint.getUpperLimit());
    assertEquals(3f, joint.getMotorSpeed());
    assertEquals(4f, joint.getMaxMotorTorque());
    assertTrue(!joint.isLimitEnabled() && !joint.isMotorEnabled());
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    RevoluteJoint joint = make(scene, pin(scene, b, 0f, 0f));
    RevoluteJointDef def = pin(scene, b, 0f, 0f);
    def.lowerAngle = 1f;
    BadInput.rejected(scene, def, "lowerAngle");
    def.lowerAngle = Float.NaN;
    BadInput.rejected(scene, def, "lowerAngle");
    def.lowerAngle = 0f;
    def.motorSpeed = Float.POSITIVE_INFINITY;
    BadInput.rejected(scene, def, "motorSpeed");
    def.motorSpeed = 0f;
    def.maxMotorTorque = -1f;
    BadInput.rejected(scene, def, "maxMotorTorque");
    def.maxMotorTorque = 0f;
    def.referenceAngle = Float.NaN;
    BadInput.rejected(scene, def, "referenceAngle");
    def.referenceAngle = 0f;
    def.localAnchorA = null;
    BadInput.rejected(scene, def, "localAnchorA");
    assertThrows(IllegalArgumentException.class, () -> joint.setLimits(1f, 0f));
    assertThrows(IllegalArgumentException.class, () -> joint.setMotorSpeed(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxMotorTorque(-1f));
  }
}
