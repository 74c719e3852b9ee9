package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;

class RopeJointTest {
  private static RopeJoint rope(JointScene scene, Body b, float length) {
    RopeJointDef def = new RopeJointDef();
    def.bodyA = scene.ground;
    def.bodyB = b;
    def.localAnchorA.setZero();
    def.localAnchorB.setZero();
    def.maxLength = length;
    return (RopeJoint) scene.world.createJoint(def);
  }

  /** A body falls freely until the rope is taut, then hangs; the rope is never longer. */
  @Test
  void aBodyFallsFreelyUntilTheRopeIsTaut() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    RopeJoint joint = rope(scene, b, 2f);
    scene.step(30);
    assertEquals(-JointScene.G * 30 * JointScene.H, b.getLinearVelocity().y, 1e-4f);
    assertEquals(LimitState.INACTIVE, joint.getLimitState());
    assertEquals(0f, JointScene.force(joint).length());
    float longest = 0f;
    for (int i = 0; i < 120; i++) {
      scene.step(1);
      longest = Math.max(longest, JointScene.gap(joint));
    }
    assertEquals(2f, longest, 1e-4f);
    assertEquals(LimitState.AT_UPPER, joint.getLimitState());
    assertEquals(b.getMass() * JointScene.G, JointScene.force(joint).y, 1e-3f);
    assertEquals(0f, joint.getReactionTorque(60f));
  }

  /** The length holds on a swing too, where each step leaves the circle along a tangent. */
  @Test
  void theLengthHoldsOnASwing() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(2f, 0f, 0.1f, 0.1f);
    RopeJoint joint = rope(scene, b, 2f);
    float longest = 0f;
    for (int i = 0; i < 600; i++) {
      scene.step(1);
      longest = Math.max(longest, JointScene.gap(joint));
    }
    assertTrue(longest < 2f + 2e-4f, "longest " + longest);
  }

  @Test
  void itNeverPushes() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 2f, 0.5f, 0.5f);
    rope(scene, b, 2f);
    b.setLinearVelocity(new Vec2(0f, -1f));
    scene.step(60);
    assertEquals(-1f, b.getLinearVelocity().y);
    assertEquals(1f, b.getPosition().y, 1e-4f);
  }

  @Test
  void aShorterRopePullsTheSleeperUp() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, -2f, 0.5f, 0.5f);
    RopeJoint joint = rope(scene, b, 2f);
    b.setSleepingAllowed(true);
    scene.step(120);
    assertTrue(!b.isAwake());
    joint.setMaxLength(1f);
    assertTrue(b.isAwake());
    scene.step(120);
    assertEquals(1f, JointScene.gap(joint), 1e-3f);
    assertEquals(1f, joint.getMaxLength());
  }

  @Test
  void noLengthGivesNoNaN() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    RopeJoint joint = rope(scene, b, 0f);
    for (int i = 0; i < 240; i++) {
      scene.step(1);
      scene.assertFinite();
      assertTrue(JointScene.gap(joint) < 0.02f);
    }
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    RopeJoint joint = rope(scene, b, 3f);
    RopeJointDef def = new RopeJointDef();
    def.bodyA = scene.ground;
    def.bodyB = b;
    def.maxLength = -1f;
    BadInput.rejected(scene, def, "maxLength");
    def.maxLength = Float.NaN;
    BadInput.rejected(scene, def, "maxLength");
    def.maxLength = 1f;
    def.localAnchorB.y = Float.NEGATIVE_INFINITY;
    BadInput.rejected(scene, def, "localAnchorB");
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxLength(-1f));
  }
}
