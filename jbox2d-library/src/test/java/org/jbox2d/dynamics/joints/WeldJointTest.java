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

class WeldJointTest {
  private static WeldJoint weld(JointScene scene, Body a, Body b, float x, float hz, float damp) {
    WeldJointDef def = new WeldJointDef();
    def.initialize(a, b, new Vec2(x, 0f));
    def.frequencyHz = hz;
    def.dampingRatio = damp;
    return (WeldJoint) scene.world.createJoint(def);
  }

  /** A bracket of 2 m in the wall: force m g, torque m g times 1 m, and it does not bend. */
  @Test
  void aBracketCarriesItsWeightAndItsMoment() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(1f, 0f, 1f, 0.1f);
    WeldJoint joint = weld(scene, scene.ground, b, 0f, 0f, 0f);
    scene.step(120);
    float weight = b.getMass() * JointScene.G;
    assertEquals(weight, JointScene.force(joint).y, 1e-3f * weight);
    assertEquals(weight, joint.getReactionTorque(60f), 1e-3f * weight);
    assertEquals(0f, b.getAngle(), 1e-5f);
    assertEquals(0f, JointScene.gap(joint), 1e-5f);
  }

  /** Of a beam of four boxes each weld carries what lies beyond it; the beam hardly sags. */
  @Test
  void aBeamOfFourIsNearlyStraight() {
    JointScene scene = new JointScene(JointScene.G);
    Body last = scene.ground;
    WeldJoint root = null;
    for (int i = 0; i < 4; i++) {
      Body b = scene.box(0.5f + i, 0f, 0.5f, 0.125f);
      WeldJoint joint = weld(scene, last, b, i, 0f, 0f);
      root = root == null ? joint : root;
      last = b;
    }
    scene.step(600);
    float weight = 4 * last.getMass() * JointScene.G;
    assertEquals(weight, JointScene.force(root).y, 0.02f * weight);
    assertEquals(2f * weight, root.getReactionTorque(60f), 0.04f * weight);
    assertEquals(0f, last.getPosition().y, 0.02f);
  }

  /** The spring of a soft weld: stiffness = omega^2 / (iA + iB), so a torque bends it by T / k. */
  @ParameterizedTest
  @ValueSource(floats = {1f, 4f})
  void aSoftWeldBendsByTorqueOverStiffness(float hz) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 1f, 0.5f);
    WeldJoint joint = weld(scene, scene.ground, b, 0f, hz, 0.7f);
    for (int i = 0; i < 600; i++) {
      b.applyTorque(3f);
      scene.step(1);
    }
    double omega = 2 * Math.PI * hz;
    double stiffness = JointScene.centralInertia(b) * omega * omega;
    assertEquals(3 / stiffness, b.getAngle(), 1e-3 * 3 / stiffness);
    assertEquals(-3f, joint.getReactionTorque(60f), 1e-3f);
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "1, 0.2", "3, 0.1"})
  void aSoftWeldSwingsAtItsFrequency(float hz, float damping) {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, 0f, 1f, 0.5f);
    weld(scene, scene.ground, b, 0f, hz, damping);
    b.setTransform(new Vec2(), 0.5f);
    Oscillation o = new Oscillation(scene, 400, b::getAngle);
    double expected = 1 / (hz * Math.sqrt(1 - damping * damping));
    assertEquals(expected, o.period(5), 0.02 * expected);
    assertEquals(damping, o.dampingRatio(3), 0.01);
  }

  @Test
  void aWeldOfBodiesThatDoNotTurnHoldsThePoint() {
    JointScene scene = new JointScene(JointScene.G);
    Body b = scene.box(1f, 0f, 1f, 0.1f);
    b.setFixedRotation(true);
    WeldJoint joint = weld(scene, scene.ground, b, 0f, 0f, 0f);
    scene.step(60);
    scene.assertFinite();
    assertEquals(0f, JointScene.gap(joint), 1e-5f);
    assertEquals(0f, b.getAngle());
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body b = scene.box(0f, -3f, 0.5f, 0.5f);
    WeldJoint joint = weld(scene, scene.ground, b, 0f, 0f, 0f);
    WeldJointDef def = new WeldJointDef();
    def.initialize(scene.ground, b, new Vec2());
    def.frequencyHz = Float.NaN;
    BadInput.rejected(scene, def, "frequencyHz");
    def.frequencyHz = 0f;
    def.dampingRatio = -1f;
    BadInput.rejected(scene, def, "dampingRatio");
    def.dampingRatio = 0f;
    def.referenceAngle = Float.NEGATIVE_INFINITY;
    BadInput.rejected(scene, def, "referenceAngle");
    assertThrows(IllegalArgumentException.class, () -> joint.setFrequency(-1f));
    assertThrows(IllegalArgumentException.class, () -> joint.setDampingRatio(Float.NaN));
    b.setAwake(false);
    joint.setFrequency(2f);
    assertTrue(b.isAwake());
  }
}
