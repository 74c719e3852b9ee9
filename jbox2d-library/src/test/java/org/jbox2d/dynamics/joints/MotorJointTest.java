package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;

class MotorJointTest {
  private static MotorJoint motor(JointScene scene, Body b, float force, float torque) {
    MotorJointDef def = new MotorJointDef();
    def.initialize(scene.ground, b);
    def.maxForce = force;
    def.maxTorque = torque;
    return (MotorJoint) scene.world.createJoint(def);
  }

  @Test
  void aBodyIsHeldAgainstGravity() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(2f, 3f, 0.5f, 0.5f);
    MotorJoint joint = motor(scene, b, 1000f, 1000f);
    scene.step(120);
    assertEquals(2f, b.getPosition().x, 1e-4f);
    assertEquals(3f, b.getPosition().y, 1e-4f);
    assertEquals(b.getMass() * JointScene.G, JointScene.force(joint).y, 1e-2f);
  }

  /** With correction factor 0.3 each step leaves 0.7 of the error. */
  @Test
  void aBodyFollowsItsOffset() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    MotorJoint joint = motor(scene, b, 1e5f, 1e5f);
    joint.setLinearOffset(new Vec2(1f, -2f));
    joint.setAngularOffset(0.5f);
    scene.step(5);
    double left = StrictMath.pow(0.7, 5);
    assertEquals(1 - left, b.getPosition().x, 1e-3);
    assertEquals(-2 * (1 - left), b.getPosition().y, 1e-3);
    assertEquals(0.5 * (1 - left), b.getAngle(), 1e-3);
    scene.step(60);
    assertEquals(1f, b.getPosition().x, 1e-4f);
    assertEquals(0.5f, b.getAngle(), 1e-4f);
    assertEquals(new Vec2(1f, -2f), joint.getLinearOffset());
    Vec2 out = new Vec2();
    joint.getLinearOffset(out);
    assertEquals(joint.getLinearOffset(), out);
  }

  /** A motor that is too weak gives its force and its torque, and no more. */
  @Test
  void aWeakMotorGivesWhatItHas() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    MotorJoint joint = motor(scene, b, 2f, 0.1f);
    joint.setLinearOffset(new Vec2(60f, 80f));
    joint.setAngularOffset(100f);
    scene.step(60);
    assertEquals(2f / b.getMass(), b.getLinearVelocity().length(), 1e-3f);
    assertEquals(1.2f / b.getMass(), b.getLinearVelocity().x, 1e-2f);
    assertEquals(2f, JointScene.force(joint).length(), 1e-4f);
    assertEquals(0.1f, joint.getReactionTorque(60f), 1e-5f);
    assertEquals(0.1 / JointScene.centralInertia(b), b.getAngularVelocity(), 1e-3);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    MotorJoint joint = motor(scene, b, 1f, 1f);
    MotorJointDef def = new MotorJointDef();
    def.initialize(scene.ground, b);
    for (float factor : new float[] {-0.1f, 1.1f, Float.NaN}) {
      def.correctionFactor = factor;
      BadInput.rejected(scene, def, "correctionFactor");
      assertThrows(IllegalArgumentException.class, () -> joint.setCorrectionFactor(factor));
    }
    def.correctionFactor = 1f;
    def.maxForce = -1f;
    BadInput.rejected(scene, def, "maxForce");
    def.maxForce = 1f;
    def.angularOffset = Float.NaN;
    BadInput.rejected(scene, def, "angularOffset");
    assertThrows(
        IllegalArgumentException.class, () -> joint.setLinearOffset(new Vec2(Float.NaN, 0f)));
    assertThrows(IllegalArgumentException.class, () -> joint.setAngularOffset(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxForce(-1f));
    b.setAwake(false);
    joint.setAngularOffset(1f);
    assertTrue(b.isAwake());
  }
}
