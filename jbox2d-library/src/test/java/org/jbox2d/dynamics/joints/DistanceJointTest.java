package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DistanceJointTest {
  private static DistanceJoint rod(JointScene scene, Body b) {
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(scene.ground, b, new Vec2(), b.getPosition());
    return (DistanceJoint) scene.world.createJoint(def);
  }

  private static DistanceJoint spring(JointScene scene, Body b, float hz, float damping) {
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(scene.ground, b, new Vec2(), b.getPosition());
    def.frequencyHz = hz;
    def.dampingRatio = damping;
    return (DistanceJoint) scene.world.createJoint(def);
  }

  @Test
  void aHangingBodyIsHeldByItsWeight() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    DistanceJoint joint = rod(scene, b);
    scene.step(120);
    assertEquals(b.getMass() * JointScene.G, JointScene.force(joint).y, 1e-3f);
    assertEquals(0f, JointScene.force(joint).x, 1e-4f);
    assertEquals(3f, JointScene.gap(joint), 1e-5f);
    assertEquals(0f, joint.getReactionTorque(60f));
  }

  /** T = 4 sqrt(L/g) K(sin(amplitude / 2)); for a right angle K = 1.8540747. */
  @Test
  void aPendulumKeepsItsPeriodAndItsEnergy() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(2f, 0f, 0.1f, 0.1f);
    DistanceJoint joint = rod(scene, b);
    Oscillation swing = new Oscillation(scene, 1200, () -> b.getPosition().x);
    double expected = 4 * Math.sqrt(2 / JointScene.G) * 1.8540746773;
    assertEquals(expected, swing.period(11), 1e-3 * expected);
    // It started with no kinetic energy at height 0; one swing converts m g L = 0.8 J.
    assertEquals(0.0, scene.energy(), 0.02 * 0.8);
    assertEquals(2f, JointScene.gap(joint), 2e-4f);
  }

  @ParameterizedTest
  @CsvSource({"0.5, 0", "1, 0", "2, 0", "1, 0.1", "2, 0.1", "1, 0.5", "4, 0.3"})
  void aSpringHasItsFrequencyAndDamping(float hz, float damping) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -5f, 0.5f, 0.5f);
    spring(scene, b, hz, damping);
    b.setTransform(new Vec2(0f, -4f), 0f);
    Oscillation o = new Oscillation(scene, 600, () -> b.getPosition().y + 5.0);
    double expected = 1 / (hz * Math.sqrt(1 - damping * damping));
    assertEquals(expected, o.period(5), 0.02 * expected);
    assertEquals(damping, o.dampingRatio(3), 0.01);
  }

  /** The sag of a spring is g / omega^2, whatever the mass. */
  @ParameterizedTest
  @ValueSource(floats = {0.5f, 2f, 8f})
  void aSpringSagsUnderItsLoad(float hz) {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, -5f, 0.5f, 0.5f);
    DistanceJoint joint = spring(scene, b, hz, 0.7f);
    scene.step(900);
    double omega = 2 * Math.PI * hz;
    assertEquals(5 + JointScene.G / (omega * omega), JointScene.gap(joint), 1e-4);
    assertEquals(b.getMass() * JointScene.G, JointScene.force(joint).y, 1e-2f);
  }

  /** A spring far too stiff for the step neither gains energy nor leaves its place. */
  @ParameterizedTest
  @ValueSource(floats = {20f, 30f, 60f, 1000f})
  void aStiffSpringIsStable(float hz) {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, -5f, 0.5f, 0.5f);
    DistanceJoint joint = spring(scene, b, hz, 0f);
    b.setTransform(new Vec2(0f, -4f), 0f);
    scene.step(600);
    assertEquals(5f, JointScene.gap(joint), 0.05f);
  }

  @Test
  void aChangeOfLengthMovesTheBody() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    DistanceJoint joint = rod(scene, b);
    b.setSleepingAllowed(true);
    scene.step(120);
    assertTrue(!b.isAwake());
    joint.setLength(4f);
    assertTrue(b.isAwake());
    scene.step(120);
    assertEquals(4f, JointScene.gap(joint), 1e-4f);
    assertEquals(4f, joint.getLength());
  }

  /** Coincident anchors have no direction; length 0 asks for that very state. */
  @ParameterizedTest
  @ValueSource(floats = {0f, 1e-6f, 0.005f, 2f})
  void coincidentAnchorsGiveNoNaN(float length) {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(0f, 0f, 0.5f, 0.5f);
    DistanceJointDef def = new DistanceJointDef();
    def.bodyA = scene.ground;
    def.bodyB = b;
    def.length = length;
    DistanceJoint joint = (DistanceJoint) scene.world.createJoint(def);
    for (int i = 0; i < 240; i++) {
      scene.step(1);
      scene.assertFinite();
    }
    assertEquals(Math.max(length, 0.005f), JointScene.gap(joint), 0.01f);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    DistanceJoint joint = rod(scene, b);
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(scene.ground, b, new Vec2(), new Vec2());
    def.length = -1f;
    BadInput.rejected(scene, def, "length");
    def.length = Float.NaN;
    BadInput.rejected(scene, def, "length");
    def.length = 1f;
    def.frequencyHz = Float.POSITIVE_INFINITY;
    BadInput.rejected(scene, def, "frequencyHz");
    def.frequencyHz = 0f;
    def.dampingRatio = -0.1f;
    BadInput.rejected(scene, def, "dampingRatio");
    def.dampingRatio = 0f;
    def.localAnchorA.x = Float.NaN;
    BadInput.rejected(scene, def, "localAnchorA");
    assertThrows(IllegalArgumentException.class, () -> joint.setLength(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> joint.setFrequency(-1f));
    assertThrows(IllegalArgumentException.class, () -> joint.setDampingRatio(Float.NaN));
  }
}
