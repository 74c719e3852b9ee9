package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GearJointTest {
  private static RevoluteJoint hub(JointScene scene, Body base, Body b) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(base, b, b.getPosition());
    return (RevoluteJoint) scene.world.createJoint(def);
  }

  private static PrismaticJoint rack(JointScene scene, Body b, Vec2 axis) {
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(scene.ground, b, b.getPosition(), axis);
    return (PrismaticJoint) scene.world.createJoint(def);
  }

  private static GearJoint gear(JointScene scene, Joint one, Joint two, float ratio) {
    GearJointDef def = new GearJointDef();
    def.joint1 = one;
    def.joint2 = two;
    def.ratio = ratio;
    return (GearJoint) scene.world.createJoint(def);
  }

  /**
   * Two wheels under a torque on the first: q1 = -ratio q2, so the first one sees I1 + I2 /
   * ratio^2.
   */
  @ParameterizedTest
  @ValueSource(floats = {1f, 2f, -3f, 0.25f})
  void wheelsTurnByTheirRatio(float ratio) {
    JointScene scene = new JointScene(0f);
    Body one = scene.box(0f, 0f, 0.5f, 0.5f);
    Body two = scene.box(3f, 0f, 1f, 1f);
    RevoluteJoint first = hub(scene, scene.ground, one);
    RevoluteJoint second = hub(scene, scene.ground, two);
    GearJoint gear = gear(scene, first, second, ratio);
    for (int i = 0; i < 60; i++) {
      one.applyTorque(1f);
      scene.step(1);
    }
    double inertia = one.getInertia() + two.getInertia() / (ratio * ratio);
    assertEquals(1 / inertia, one.getAngularVelocity(), 1e-3 / inertia);
    assertEquals(0f, first.getJointAngle() + ratio * second.getJointAngle(), 1e-4f);
    double torqueOnTwo = -two.getInertia() / ratio / inertia;
    assertEquals(torqueOnTwo, gear.getReactionTorque(60f), 1e-3 * Math.abs(torqueOnTwo));
    assertEquals(0f, JointScene.force(gear).length());
  }

  /** A weight on a rack turns a pinion: q1 + ratio q2 = 0 with q1 in rad, q2 in m. */
  @Test
  void aRackTurnsAPinion() {
    JointScene scene = new JointScene(JointScene.G);
    Body pinion = scene.box(0f, 0f, 0.5f, 0.5f);
    Body weight = scene.box(2f, 0f, 0.5f, 0.5f);
    RevoluteJoint hub = hub(scene, scene.ground, pinion);
    PrismaticJoint rack = rack(scene, weight, new Vec2(0f, 1f));
    GearJoint gear = gear(scene, hub, rack, 2f);
    scene.step(60);
    double mass = weight.getMass() + 4 * pinion.getInertia();
    double acceleration = weight.getMass() * JointScene.G / mass;
    assertEquals(-acceleration, weight.getLinearVelocity().y, 1e-3 * acceleration);
    assertEquals(0f, hub.getJointAngle() + 2f * rack.getJointTranslation(), 1e-4f);
    double pull = weight.getMass() * (JointScene.G - acceleration);
    assertEquals(pull, JointScene.force(gear).y, 1e-2 * pull);
  }

  /** Two racks on a turning carrier: base bodies that move and are shared. */
  @Test
  void gearsWorkOnMovingBases() {
    JointScene scene = new JointScene(0f);
    Body carrier = scene.box(0f, 0f, 3f, 0.5f);
    Body one = scene.box(-2f, 0f, 0.5f, 0.5f);
    Body two = scene.box(2f, 0f, 0.5f, 0.5f);
    RevoluteJoint first = hub(scene, carrier, one);
    RevoluteJoint second = hub(scene, carrier, two);
    GearJoint gear = gear(scene, first, second, -1f);
    one.setAngularVelocity(5f);
    double[] before = scene.momentum();
    scene.step(300);
    assertEquals(0f, first.getJointAngle() - second.getJointAngle(), 2e-3f);
    assertEquals(before[2], scene.momentum()[2], 1e-3 * Math.abs(before[2]));
    assertEquals(4, gear.bodyCount());
  }

  @Test
  void aNewRatioGoesOnFromWhereTheJointsAre() {
    JointScene scene = new JointScene(0f);
    Body one = scene.box(0f, 0f, 0.5f, 0.5f);
    Body two = scene.box(3f, 0f, 0.5f, 0.5f);
    RevoluteJoint first = hub(scene, scene.ground, one);
    RevoluteJoint second = hub(scene, scene.ground, two);
    GearJoint gear = gear(scene, first, second, 1f);
    one.setAngularVelocity(4f);
    scene.step(60);
    float q1 = first.getJointAngle();
    float q2 = second.getJointAngle();
    gear.setRatio(2f);
    scene.step(1);
    assertEquals(q1, first.getJointAngle(), 0.1f);
    scene.step(60);
    assertEquals(q1 + 2f * q2, first.getJointAngle() + 2f * second.getJointAngle(), 1e-3f);
    assertEquals(2f, gear.getRatio());
  }

  /** A gear without its joints rests; what is left goes on, and it can be destroyed later. */
  @Test
  void aGearOutlivesItsJointsSafely() {
    JointScene scene = new JointScene(0f);
    Body one = scene.box(0f, 0f, 0.5f, 0.5f);
    Body two = scene.box(3f, 0f, 0.5f, 0.5f);
    RevoluteJoint first = hub(scene, scene.ground, one);
    RevoluteJoint second = hub(scene, scene.ground, two);
    GearJoint gear = gear(scene, first, second, 1f);
    one.setAngularVelocity(4f);
    scene.step(10);
    assertTrue(gear.isActive());
    scene.world.destroyJoint(first);
    assertFalse(gear.isActive());
    one.setAngularVelocity(7f);
    scene.step(10);
    assertEquals(7f, one.getAngularVelocity());
    gear.setRatio(3f);
    assertEquals(2, scene.world.getJointCount());
    scene.world.destroyJoint(gear);
    assertEquals(1, scene.world.getJointCount());
  }

  /** The ground of a joint is in none of the gear's lists: the gear must notice all the same. */
  @Test
  void aGearOutlivesTheBasesOfItsJoints() {
    JointScene scene = new JointScene(0f);
    Body base = scene.box(0f, 0f, 0.5f, 0.5f);
    Body one = scene.box(0f, 1f, 0.5f, 0.5f);
    Body two = scene.box(3f, 0f, 0.5f, 0.5f);
    GearJoint gear = gear(scene, hub(scene, base, one), hub(scene, scene.ground, two), 1f);
    one.setAngularVelocity(4f);
    scene.step(10);
    scene.world.destroyBody(base);
    assertFalse(gear.isActive());
    scene.step(10);
    scene.assertFinite();
    scene.world.destroyBody(one);
    assertEquals(1, scene.world.getJointCount());
    scene.step(10);
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    Body one = scene.box(0f, 0f, 0.5f, 0.5f);
    Body two = scene.box(3f, 0f, 0.5f, 0.5f);
    RevoluteJoint first = hub(scene, scene.ground, one);
    RevoluteJoint second = hub(scene, scene.ground, two);
    GearJoint gear = gear(scene, first, second, 1f);
    GearJointDef def = new GearJointDef();
    def.joint2 = second;
    def.ratio = 1f;
    BadInput.rejected(scene, def, "joint1");
    def.joint1 = gear;
    BadInput.rejected(scene, def, "joint1");
    def.joint1 = second;
    BadInput.rejected(scene, def, "same");
    def.joint1 = first;
    for (float ratio : new float[] {0f, Float.NaN, Float.NEGATIVE_INFINITY}) {
      def.ratio = ratio;
      BadInput.rejected(scene, def, "ratio");
    }
    def.ratio = 1f;
    scene.world.destroyJoint(first);
    BadInput.rejected(scene, def, "destroyed");
    JointScene other = new JointScene(0f);
    def.joint1 = hub(other, other.ground, other.box(0f, 0f, 1f, 1f));
    BadInput.rejected(scene, def, "world");
    assertThrows(IllegalArgumentException.class, () -> gear.setRatio(0f));
  }
}
