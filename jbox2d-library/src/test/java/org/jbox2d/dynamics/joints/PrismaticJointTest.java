package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;

class PrismaticJointTest {
  private static PrismaticJointDef slide(JointScene scene, Body b, float ax, float ay) {
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(scene.ground, b, b.getWorldCenter(), new Vec2(ax, ay));
    return def;
  }

  private static PrismaticJoint make(JointScene scene, PrismaticJointDef def) {
    return (PrismaticJoint) scene.world.createJoint(def);
  }

  /**
   * On a slope of 3-4-5 a body slides with 3/5 g, and presses on the rail with 4/5 of its weight.
   */
  @Test
  void aBodySlidesDownARail() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    PrismaticJoint joint = make(scene, slide(scene, b, 4f, -3f));
    scene.step(60);
    assertEquals(0.6f * JointScene.G, joint.getJointSpeed(), 1e-3f);
    assertEquals(0.3f * JointScene.G, joint.getJointTranslation(), 0.06f);
    assertEquals(0.8f * b.getMass() * JointScene.G, JointScene.force(joint).length(), 1e-2f);
    assertEquals(0f, b.getAngle(), 1e-4f);
  }

  /** A load off the axis: the rail carries its moment. */
  @Test
  void theRailCarriesAMoment() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(2f, 0f, 0.5f, 0.5f);
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(scene.ground, b, new Vec2(0f, 0f), new Vec2(0f, 1f));
    def.enableLimit = true;
    PrismaticJoint joint = make(scene, def);
    scene.step(120);
    float weight = b.getMass() * JointScene.G;
    assertEquals(weight, JointScene.force(joint).y, 1e-2f * weight);
    assertEquals(2f * weight, joint.getReactionTorque(1f / JointScene.H), 2e-2f * weight);
    assertEquals(0f, b.getAngle(), 1e-3f);
  }

  @Test
  void limitsStopTheSlideWithoutOvershoot() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    PrismaticJointDef def = slide(scene, b, 0f, 2f);
    def.enableLimit = true;
    def.lowerTranslation = -1f;
    def.upperTranslation = 2f;
    PrismaticJoint joint = make(scene, def);
    assertEquals(1f, joint.getLocalAxisA().length(), 1e-6f);
    float least = 0f;
    for (int i = 0; i < 120; i++) {
      scene.step(1);
      least = Math.min(least, joint.getJointTranslation());
    }
    assertEquals(-1f, least, 1e-4f);
    assertEquals(-1f, joint.getJointTranslation(), 1e-4f);
    scene.world.setGravity(new Vec2(0f, JointScene.G));
    scene.step(120);
    assertEquals(2f, joint.getJointTranslation(), 1e-4f);
    assertEquals(-b.getMass() * JointScene.G, JointScene.force(joint).y, 1e-2f);
  }

  @Test
  void aMotorRunsAtItsSpeedOrAtItsForce() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    PrismaticJointDef def = slide(scene, b, 0f, 1f);
    def.enableMotor = true;
    def.motorSpeed = 2f;
    def.maxMotorForce = 100f;
    PrismaticJoint joint = make(scene, def);
    scene.step(60);
    assertEquals(2f, joint.getJointSpeed(), 1e-4f);
    assertEquals(2f, joint.getJointTranslation(), 1e-2f);
    assertEquals(b.getMass() * JointScene.G, joint.getMotorForce(60f), 1e-2f);
    joint.setMaxMotorForce(4f);
    float before = joint.getJointSpeed();
    scene.step(30);
    assertEquals(before + (4f / b.getMass() - JointScene.G) * 0.5f, joint.getJointSpeed(), 1e-3f);
    assertEquals(4f, joint.getMotorForce(60f), 1e-4f);
  }

  /**
   * A bead slides off on a rod that spins about its end: without a force along the rod, {@code r =
   * r0 cosh(w t)}. The rail feels the Coriolis force only.
   */
  @Test
  void aBeadOnASpinningRodFliesOff() {
    JointScene scene = new JointScene(0f);
    Body rod = scene.box(0f, 0f, 4f, 0.5f);
    RevoluteJointDef hub = new RevoluteJointDef();
    hub.initialize(scene.ground, rod, new Vec2());
    hub.enableMotor = true;
    hub.motorSpeed = 1f;
    hub.maxMotorTorque = 1e6f;
    scene.world.createJoint(hub);
    rod.setAngularVelocity(1f);
    Body bead = scene.box(0.5f, 0f, 0.05f, 0.05f);
    bead.setLinearVelocity(new Vec2(0f, 0.5f));
    bead.setAngularVelocity(1f);
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(rod, bead, bead.getPosition(), new Vec2(1f, 0f));
    PrismaticJoint joint = make(scene, def);
    scene.step(120);
    double expected = 0.5 * (Math.exp(2) + Math.exp(-2)) / 2;
    assertEquals(expected, bead.getPosition().length(), 0.01 * expected);
    assertEquals(expected - 0.5, joint.getJointTranslation(), 0.01 * expected);
    double sinh = 0.5 * (Math.exp(2) - Math.exp(-2)) / 2;
    assertEquals(2 * bead.getMass() * sinh, JointScene.force(joint).length(), 0.02 * sinh);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    PrismaticJoint joint = make(scene, slide(scene, b, 1f, 0f));
    PrismaticJointDef def = slide(scene, b, 1f, 0f);
    def.localAxisA.setZero();
    BadInput.rejected(scene, def, "localAxisA");
    def.localAxisA.set(Float.NaN, 1f);
    BadInput.rejected(scene, def, "localAxisA");
    def.localAxisA.set(1f, 0f);
    def.lowerTranslation = 1f;
    BadInput.rejected(scene, def, "lowerTranslation");
    def.lowerTranslation = 0f;
    def.maxMotorForce = Float.NaN;
    BadInput.rejected(scene, def, "maxMotorForce");
    def.maxMotorForce = 0f;
    def.motorSpeed = Float.NaN;
    BadInput.rejected(scene, def, "motorSpeed");
    assertThrows(IllegalArgumentException.class, () -> joint.setLimits(1f, 0f));
    assertThrows(IllegalArgumentException.class, () -> joint.setMotorSpeed(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxMotorForce(-1f));
    assertThrows(
        IllegalArgumentException.class,
        () -> new PrismaticJointDef().initialize(null, b, new Vec2(), new Vec2(1f, 0f)));
  }

  @Test
  void changesWakeTheBodies() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 1f, 1f);
    PrismaticJoint joint = make(scene, slide(scene, b, 1f, 0f));
    Runnable[] changes = {
      () -> joint.enableLimit(true),
      () -> joint.setLimits(-1f, 1f),
      () -> joint.enableMotor(true),
      () -> joint.setMaxMotorForce(5f),
      () -> joint.setMotorSpeed(1f)
    };
    for (Runnable change : changes) {
      b.setAwake(false);
      change.run();
      assertTrue(b.isAwake());
    }
  }
}
