package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PulleyJointTest {
  private static PulleyJoint pulley(JointScene scene, Body a, Body b, float ratio) {
    PulleyJointDef def = new PulleyJointDef();
    Vec2 groundA = new Vec2(a.getPosition().x, 10f);
    Vec2 groundB = new Vec2(b.getPosition().x, 10f);
    def.initialize(a, b, groundA, groundB, a.getPosition(), b.getPosition(), ratio);
    return (PulleyJoint) scene.world.createJoint(def);
  }

  /** Atwood's machine: a = g (mA - mB) / (mA + mB), tension 2 g mA mB / (mA + mB). */
  @Test
  void anAtwoodMachineAccelerates() {
    JointScene scene = new JointScene(JointScene.G);
    Body a = scene.box(-2f, 0f, 0.5f, 1.5f);
    Body b = scene.box(2f, 0f, 0.5f, 0.5f);
    PulleyJoint joint = pulley(scene, a, b, 1f);
    scene.step(60);
    assertEquals(-5f, a.getLinearVelocity().y, 1e-3f);
    assertEquals(5f, b.getLinearVelocity().y, 1e-3f);
    assertEquals(15f, JointScene.force(joint).y, 1e-2f);
    assertEquals(20f, joint.getCurrentLengthA() + joint.getCurrentLengthB(), 1e-4f);
    assertEquals(10f, joint.getLengthA());
    assertEquals(joint.getCurrentLengthA(), joint.getLength1());
    assertEquals(joint.getCurrentLengthB(), joint.getLength2());
  }

  /**
   * Block and tackle with ratio k: lA + k lB is constant, vA = -k vB. In balance k mA = mB; the
   * rope pulls k times as hard on side B.
   */
  @ParameterizedTest
  @ValueSource(floats = {0.5f, 2f, 3f})
  void theRatioMultipliesWayAndForce(float ratio) {
    JointScene scene = new JointScene(JointScene.G);
    Body a = scene.box(-3f, 0f, 0.5f, 0.5f);
    Body b = scene.box(3f, 0f, 0.5f * ratio, 0.5f);
    PulleyJoint joint = pulley(scene, a, b, ratio);
    scene.step(60);
    assertEquals(0f, a.getPosition().y, 1e-3f);
    assertEquals(ratio * 10f * a.getMass(), JointScene.force(joint).y, 1e-2f);
    a.setLinearVelocity(new Vec2(0f, -1f));
    b.setLinearVelocity(new Vec2(0f, 1f / ratio));
    scene.step(60);
    assertEquals(-1f, a.getPosition().y, 0.02f);
    assertEquals(1f / ratio, b.getPosition().y, 0.02f / ratio);
    assertEquals(
        10f + ratio * 10f, joint.getCurrentLengthA() + ratio * joint.getCurrentLengthB(), 1e-3f);
    assertEquals(ratio, joint.getRatio());
  }

  /** The length holds while both sides swing. */
  @Test
  void theRopeKeepsItsLengthOnASwing() {
    JointScene scene = new JointScene(JointScene.G);
    Body a = scene.box(-3f, 5f, 0.5f, 0.5f);
    Body b = scene.box(3f, 5f, 0.5f, 0.5f);
    PulleyJoint joint = pulley(scene, a, b, 1f);
    a.setLinearVelocity(new Vec2(3f, 0f));
    float worst = 0f;
    for (int i = 0; i < 300; i++) {
      scene.step(1);
      float sum = joint.getCurrentLengthA() + joint.getCurrentLengthB();
      worst = Math.max(worst, Math.abs(sum - 10f));
    }
    assertTrue(worst < 2e-3f, "off by " + worst);
  }

  /** The original divided by the mass of a rope that pulls on nothing. */
  @Test
  void aRopeWithoutLengthGivesNoNaN() {
    JointScene scene = new JointScene(JointScene.G);
    Body a = scene.box(-3f, 10f, 0.5f, 0.5f);
    Body b = scene.box(3f, 10f, 0.5f, 0.5f);
    PulleyJoint joint = pulley(scene, a, b, 1f);
    for (int i = 0; i < 240; i++) {
      scene.step(1);
      scene.assertFinite();
      assertTrue(Float.isFinite(JointScene.force(joint).length()));
    }
    assertTrue(joint.getCurrentLengthA() + joint.getCurrentLengthB() < 0.1f);
  }

  /** One side is drawn up to its pulley by a heavy body, and past it. */
  @Test
  void aSideDrawnToItsPulleyGivesNoNaN() {
    JointScene scene = new JointScene(JointScene.G);
    Body a = scene.box(-3f, 9f, 0.25f, 0.25f);
    Body b = scene.box(3f, 9f, 2f, 2f);
    pulley(scene, a, b, 1f);
    for (int i = 0; i < 600; i++) {
      scene.step(1);
      scene.assertFinite();
    }
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body a = scene.box(-3f, 0f, 0.5f, 0.5f);
    Body b = scene.box(3f, 0f, 0.5f, 0.5f);
    PulleyJointDef def = new PulleyJointDef();
    def.initialize(a, b, new Vec2(-3f, 9f), new Vec2(3f, 9f), new Vec2(), new Vec2(), 1f);
    for (float ratio : new float[] {0f, -1f, Float.NaN, Float.POSITIVE_INFINITY}) {
      def.ratio = ratio;
      BadInput.rejected(scene, def, "ratio");
    }
    def.ratio = 1f;
    def.lengthA = -1f;
    BadInput.rejected(scene, def, "lengthA");
    def.lengthA = 1f;
    def.lengthB = Float.NaN;
    BadInput.rejected(scene, def, "lengthB");
    def.lengthB = 1f;
    def.groundAnchorA = null;
    BadInput.rejected(scene, def, "groundAnchorA");
    def.groundAnchorA = new Vec2(Float.NaN, 0f);
    BadInput.rejected(scene, def, "groundAnchorA");
  }
}
