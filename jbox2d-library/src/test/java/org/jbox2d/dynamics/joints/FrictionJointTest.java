package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FrictionJointTest {
  private static FrictionJoint friction(JointScene scene, Body b, float force, float torque) {
    FrictionJointDef def = new FrictionJointDef();
    def.initialize(scene.ground, b, b.getWorldCenter());
    def.maxForce = force;
    def.maxTorque = torque;
    return (FrictionJoint) scene.world.createJoint(def);
  }

  /** A push of 3-4-5 direction: held below the friction force, F = (push - friction) above it. */
  @ParameterizedTest
  @CsvSource({"9.9, 0", "10.5, 0.5", "25, 15"})
  void aBodySlidesOnlyAboveTheForce(float push, float net) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(2f, 3f, 0.5f, 0.5f);
    FrictionJoint joint = friction(scene, b, 10f, 10f);
    for (int i = 0; i < 60; i++) {
      b.applyForceToCenter(new Vec2(0.6f * push, 0.8f * push));
      scene.step(1);
    }
    assertEquals(net / b.getMass(), b.getLinearVelocity().length(), 1e-3f);
    assertEquals(push - net, JointScene.force(joint).length(), 1e-3f);
    assertEquals(-0.6f * (push - net), JointScene.force(joint).x, 1e-3f);
    if (net == 0f) {
      assertEquals(2f, b.getPosition().x, 1e-5f);
    }
  }

  @ParameterizedTest
  @CsvSource({"1.9, 0", "5, 3"})
  void aBodyTurnsOnlyAboveTheTorque(float torque, float net) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(2f, 3f, 0.5f, 0.5f);
    FrictionJoint joint = friction(scene, b, 10f, 2f);
    for (int i = 0; i < 60; i++) {
      b.applyTorque(torque);
      scene.step(1);
    }
    double inertia = JointScene.centralInertia(b);
    assertEquals(net / inertia, b.getAngularVelocity(), 2e-3 * (1 + net / inertia));
    assertEquals(net - torque, joint.getReactionTorque(60f), 1e-3f);
  }

  /** A sliding body stops after v^2 / (2 F/m) and stays. */
  @Test
  void aSlidingBodyStopsAfterItsWay() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    friction(scene, b, 4f, 10f);
    b.setLinearVelocity(new Vec2(4f, 0f));
    scene.step(120);
    assertEquals(0f, b.getLinearVelocity().length(), 1e-5f);
    assertEquals(2f, b.getPosition().x, 0.04f);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    FrictionJoint joint = friction(scene, b, 1f, 1f);
    FrictionJointDef def = new FrictionJointDef();
    def.initialize(scene.ground, b, new Vec2());
    def.maxForce = -1f;
    BadInput.rejected(scene, def, "maxForce");
    def.maxForce = 1f;
    def.maxTorque = Float.NaN;
    BadInput.rejected(scene, def, "maxTorque");
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxForce(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxTorque(-1f));
    b.setAwake(false);
    joint.setMaxForce(2f);
    assertTrue(b.isAwake());
  }
}
