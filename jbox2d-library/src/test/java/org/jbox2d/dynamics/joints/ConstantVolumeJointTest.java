package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ConstantVolumeJointTest {
  private static final int N = 20;

  /** A ring of discs, radius 2 about (0, y). */
  private static ConstantVolumeJointDef ring(JointScene scene, float y) {
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    for (int i = 0; i < N; i++) {
      double angle = 2 * Math.PI * i / N;
      Body b =
          scene.body(
              BodyType.DYNAMIC,
              (float) (2 * StrictMath.cos(angle)),
              (float) (y + 2 * StrictMath.sin(angle)));
      CircleShape disc = new CircleShape();
      disc.m_radius = 0.2f;
      b.createFixture(disc, 1f);
      def.addBody(b);
    }
    def.frequencyHz = 10f;
    def.dampingRatio = 1f;
    return def;
  }

  /** The area of the polygon, by the shoelace formula in double. */
  private static double area(ConstantVolumeJoint joint) {
    double area = 0;
    Body[] bodies = joint.getBodies();
    for (int i = 0; i < bodies.length; i++) {
      Vec2 p = bodies[i].getWorldCenter();
      Vec2 q = bodies[(i + 1) % bodies.length].getWorldCenter();
      area += 0.5 * ((double) p.x * q.y - (double) p.y * q.x);
    }
    return area;
  }

  /** A soft body falls on the ground and is pressed flat by a heavy box: its area stays. */
  @ParameterizedTest
  @ValueSource(floats = {0f, 100f})
  void theAreaIsKeptToOnePerCent(float load) {
    JointScene scene = new JointScene(JointScene.G);
    EdgeShape floor = new EdgeShape();
    floor.set(new Vec2(-20f, 0f), new Vec2(20f, 0f));
    scene.ground.createFixture(floor, 0f);
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(ring(scene, 3f));
    double target = area(joint);
    assertEquals(N / 2.0 * 4 * StrictMath.sin(2 * Math.PI / N), target, 1e-4 * target);
    assertEquals(N, joint.getJoints().length);
    assertEquals(N + 1, scene.world.getJointCount());
    double worst = 0;
    for (int i = 0; i < 600; i++) {
      for (int k = 0; k <= N / 2; k++) {
        joint.getBodies()[k].applyForceToCenter(new Vec2(0f, -load / N));
      }
      scene.step(1);
      worst = Math.max(worst, Math.abs(area(joint) / target - 1));
    }
    assertTrue(worst < 0.01, "off by " + worst);
    scene.assertFinite();
  }

  /** Inflated, the pressure drives the ring to its new area. */
  @Test
  void aRingInflates() {
    JointScene scene = new JointScene(0f);
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(ring(scene, 0f));
    double before = area(joint);
    joint.inflate(1.2f);
    scene.step(300);
    assertEquals(1.2 * before, area(joint), 0.01 * before);
  }

  /** A clockwise ring has a negative area and is kept as well. */
  @Test
  void aClockwiseRingIsKeptToo() {
    JointScene scene = new JointScene(0f);
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    def.frequencyHz = 1f;
    def.addBody(scene.box(0f, 0f, 0.1f, 0.1f));
    def.addBody(scene.box(0f, 2f, 0.1f, 0.1f));
    def.addBody(scene.box(2f, 2f, 0.1f, 0.1f));
    def.addBody(scene.box(2f, 0f, 0.1f, 0.1f));
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(def);
    assertEquals(-4, area(joint), 1e-6);
    joint.getBodies()[2].setLinearVelocity(new Vec2(1f, 2f));
    for (int i = 0; i < 300; i++) {
      scene.step(1);
      assertEquals(-4, area(joint), 0.04);
    }
  }

  /** Bodies all in one place have no area and no gradient. */
  @Test
  void aRingWithoutAreaGivesNoNaN() {
    JointScene scene = new JointScene(JointScene.G);
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    for (int i = 0; i < 4; i++) {
      def.addBody(scene.box(0f, 0f, 0.1f, 0.1f));
    }
    scene.world.createJoint(def);
    for (int i = 0; i < 120; i++) {
      scene.step(1);
      scene.assertFinite();
    }
  }

  @Test
  void itsJointsGoWithIt() {
    JointScene scene = new JointScene(0f);
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(ring(scene, 0f));
    scene.world.destroyJoint(joint.getJoints()[3]);
    assertEquals(N, scene.world.getJointCount());
    scene.world.destroyJoint(joint);
    assertEquals(0, scene.world.getJointCount());
  }

  /** The ring's third body is in none of the joint's lists: the joint must notice all the same. */
  @Test
  void itOutlivesABodySafely() {
    JointScene scene = new JointScene(0f);
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(ring(scene, 0f));
    scene.step(5);
    assertTrue(joint.isActive());
    scene.world.destroyBody(joint.getBodies()[5]);
    assertFalse(joint.isActive());
    scene.step(5);
    joint.inflate(2f);
    scene.world.destroyBody(joint.getBodies()[0]);
    assertEquals(0, scene.world.getJointCount());
    scene.step(5);
    scene.assertFinite();
  }

  @Test
  void givenJointsAreUsed() {
    JointScene scene = new JointScene(0f);
    Body[] b = {
      scene.box(0f, 0f, 0.1f, 0.1f), scene.box(2f, 0f, 0.1f, 0.1f), scene.box(1f, 2f, 0.1f, 0.1f)
    };
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    for (int i = 0; i < 3; i++) {
      DistanceJointDef edge = new DistanceJointDef();
      Body next = b[(i + 1) % 3];
      edge.initialize(b[i], next, b[i].getPosition(), next.getPosition());
      def.addBodyAndJoint(b[i], (DistanceJoint) scene.world.createJoint(edge));
    }
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(def);
    assertEquals(4, scene.world.getJointCount());
    assertEquals(3, joint.getJoints().length);
    assertEquals(b[0], joint.getBodyA());
    assertEquals(b[1], joint.getBodyB());
  }

  @Test
  void badValuesAreNamed() {
    JointScene scene = new JointScene(0f);
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    BadInput.rejected(scene, def, "bodyA");
    Body a = scene.box(0f, 0f, 0.1f, 0.1f);
    Body b = scene.box(2f, 0f, 0.1f, 0.1f);
    def.addBody(a);
    def.addBody(b);
    BadInput.rejected(scene, def, "3 bodies");
    def.addBody(a);
    BadInput.rejected(scene, def, "twice");
    ConstantVolumeJointDef foreign = new ConstantVolumeJointDef();
    foreign.addBody(a);
    foreign.addBody(b);
    foreign.addBody(new JointScene(0f).box(0f, 0f, 1f, 1f));
    BadInput.rejected(scene, foreign, "world");
    ConstantVolumeJointDef soft = ring(scene, 0f);
    soft.frequencyHz = -1f;
    BadInput.rejected(scene, soft, "frequencyHz");
    assertThrows(IllegalArgumentException.class, () -> def.addBody(null));
    assertThrows(IllegalArgumentException.class, () -> def.addBodyAndJoint(a, null));
    ConstantVolumeJoint joint = (ConstantVolumeJoint) scene.world.createJoint(ring(scene, 0f));
    for (float factor : new float[] {0f, -1f, Float.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> joint.inflate(factor));
    }
  }
}
