package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WheelJointTest {
  private static WheelJointDef wheel(JointScene scene, Body b) {
    WheelJointDef def = new WheelJointDef();
    def.initialize(scene.ground, b, b.getWorldCenter(), new Vec2(0f, 2f));
    return def;
  }

  private static WheelJoint make(JointScene scene, WheelJointDef def) {
    return (WheelJoint) scene.world.createJoint(def);
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "1, 0.2", "3, 0.1", "2, 0.5"})
  void theSuspensionHasItsFrequencyAndDamping(float hz, float damping) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(1f, 2f, 0.5f, 0.5f);
    WheelJointDef def = wheel(scene, b);
    def.frequencyHz = hz;
    def.dampingRatio = damping;
    WheelJoint joint = make(scene, def);
    b.setTransform(new Vec2(1f, 3f), 0f);
    Oscillation o = new Oscillation(scene, 400, joint::getJointTranslation);
    double expected = 1 / (hz * Math.sqrt(1 - damping * damping));
    assertEquals(expected, o.period(4), 0.02 * expected);
    assertEquals(damping, o.dampingRatio(2), 0.01);
    assertEquals(1f, b.getPosition().x, 1e-4f);
  }

  @Test
  void theSpringCarriesTheLoadAndTheAxisTheRest() {
    JointScene scene = new JointScene(JointScene.G);
    scene.world.setGravity(new Vec2(3f, -JointScene.G));
    Body b = scene.box(1f, 2f, 0.5f, 0.5f);
    WheelJointDef def = wheel(scene, b);
    def.frequencyHz = 2f;
    def.dampingRatio = 0.7f;
    WheelJoint joint = make(scene, def);
    scene.step(400);
    double omega = 4 * Math.PI;
    assertEquals(-JointScene.G / (omega * omega), joint.getJointTranslation(), 1e-4);
    Vec2 force = JointScene.force(joint);
    assertEquals(b.getMass() * JointScene.G, force.y, 1e-2f);
    assertEquals(-3f * b.getMass(), force.x, 1e-2f);
  }

  @Test
  void aMotorRunsAtItsSpeedOrAtItsTorque() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(1f, 2f, 0.5f, 0.5f);
    WheelJointDef def = wheel(scene, b);
    def.enableMotor = true;
    def.motorSpeed = -4f;
    def.maxMotorTorque = 0.2f;
    WheelJoint joint = make(scene, def);
    scene.step(30);
    float inertia = (float) JointScene.centralInertia(b);
    assertEquals(-0.2f / inertia * 0.5f, joint.getJointSpeed(), 1e-4f);
    assertEquals(-0.2f, joint.getMotorTorque(60f), 1e-5f);
    assertEquals(-0.2f, joint.getReactionTorque(60f), 1e-5f);
    joint.setMaxMotorTorque(1000f);
    scene.step(1);
    assertEquals(-4f, joint.getJointSpeed(), 1e-4f);
  }

  /** Frequency 0 means no spring: the wheel falls freely along the axis. */
  @Test
  void withoutASpringTheWheelFalls() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(1f, 2f, 0.5f, 0.5f);
    make(scene, wheel(scene, b));
    scene.step(30);
    assertEquals(-JointScene.G * 0.5f, b.getLinearVelocity().y, 1e-4f);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    WheelJoint joint = make(scene, wheel(scene, b));
    WheelJointDef def = wheel(scene, b);
    def.localAxisA.setZero();
    BadInput.rejected(scene, def, "localAxisA");
    def.localAxisA.set(1f, 0f);
    def.frequencyHz = -1f;
    BadInput.rejected(scene, def, "frequencyHz");
    def.frequencyHz = 0f;
    def.dampingRatio = Float.NaN;
    BadInput.rejected(scene, def, "dampingRatio");
    def.dampingRatio = 0f;
    def.maxMotorTorque = -1f;
    BadInput.rejected(scene, def, "maxMotorTorque");
    assertThrows(IllegalArgumentException.class, () -> joint.setSpringFrequencyHz(-1f));
    assertThrows(IllegalArgumentException.class, () -> joint.setSpringDampingRatio(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMotorSpeed(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setMaxMotorTorque(-1f));
    b.setAwake(false);
    joint.setSpringFrequencyHz(2f);
    assertTrue(b.isAwake());
  }
}
