package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Random;
import java.util.stream.Stream;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What holds for every kind of joint. */
class AllJointsTest {
  /** Definitions with motors, limits and springs between two boxes of a scene. */
  private static JointDef definition(JointType type, JointScene scene, Body a, Body b) {
    Vec2 middle = a.getPosition().add(b.getPosition()).mul(0.5f);
    switch (type) {
      case DISTANCE:
        DistanceJointDef distance = new DistanceJointDef();
        distance.initialize(a, b, a.getPosition(), b.getPosition());
        return distance;
      case REVOLUTE:
        RevoluteJointDef revolute = new RevoluteJointDef();
        revolute.initialize(a, b, middle);
        revolute.enableLimit = true;
        revolute.lowerAngle = -0.3f;
        revolute.upperAngle = 0.3f;
        revolute.enableMotor = true;
        revolute.motorSpeed = 2f;
        revolute.maxMotorTorque = 1f;
        return revolute;
      case PRISMATIC:
        PrismaticJointDef prismatic = new PrismaticJointDef();
        prismatic.initialize(a, b, middle, new Vec2(1f, 1f));
        prismatic.enableLimit = true;
        prismatic.lowerTranslation = -0.2f;
        prismatic.upperTranslation = 0.2f;
        prismatic.enableMotor = true;
        prismatic.motorSpeed = 2f;
        prismatic.maxMotorForce = 1f;
        return prismatic;
      case PULLEY:
        PulleyJointDef pulley = new PulleyJointDef();
        Vec2 over = new Vec2(0f, 4f);
        pulley.initialize(
            a,
            b,
            a.getPosition().add(over),
            b.getPosition().add(over),
            a.getPosition(),
            b.getPosition(),
            1.5f);
        return pulley;
      case MOUSE:
        MouseJointDef mouse = new MouseJointDef();
        mouse.bodyA = a;
        mouse.bodyB = b;
        mouse.target.set(b.getPosition());
        mouse.maxForce = 100f;
        return mouse;
      case WHEEL:
        WheelJointDef wheel = new WheelJointDef();
        wheel.initialize(a, b, middle, new Vec2(1f, 1f));
        wheel.frequencyHz = 3f;
        wheel.dampingRatio = 0.2f;
        wheel.enableMotor = true;
        wheel.motorSpeed = 2f;
        wheel.maxMotorTorque = 1f;
        return wheel;
      case WELD:
        WeldJointDef weld = new WeldJointDef();
        weld.initialize(a, b, middle);
        weld.frequencyHz = 3f;
        return weld;
      case FRICTION:
        FrictionJointDef friction = new FrictionJointDef();
        friction.initialize(a, b, middle);
        friction.maxForce = 1f;
        friction.maxTorque = 0.5f;
        return friction;
      case ROPE:
        RopeJointDef rope = new RopeJointDef();
        rope.bodyA = a;
        rope.bodyB = b;
        rope.localAnchorA.setZero();
        rope.localAnchorB.setZero();
        rope.maxLength = 2f;
        return rope;
      case MOTOR:
        MotorJointDef motor = new MotorJointDef();
        motor.initialize(a, b);
        motor.linearOffset.addLocal(0.5f, 0.5f);
        motor.maxForce = 10f;
        return motor;
      case CONSTANT_VOLUME:
        ConstantVolumeJointDef volume = new ConstantVolumeJointDef();
        volume.addBody(a);
        volume.addBody(b);
        volume.addBody(scene.box(middle.x, middle.y + 2f, 0.5f, 0.5f));
        volume.frequencyHz = 2f;
        return volume;
      case GEAR:
        GearJointDef gear = new GearJointDef();
        Body base = scene.box(middle.x, middle.y - 2f, 1f, 0.5f);
        RevoluteJointDef hub = new RevoluteJointDef();
        hub.initialize(base, a, a.getPosition());
        gear.joint1 = scene.world.createJoint(hub);
        PrismaticJointDef rack = new PrismaticJointDef();
        rack.initialize(base, b, b.getPosition(), new Vec2(1f, 1f));
        gear.joint2 = scene.world.createJoint(rack);
        gear.ratio = 1.5f;
        return gear;
      default:
        throw new AssertionError(type);
    }
  }

  private static JointScene scene(JointType type, float gravity) {
    JointScene scene = new JointScene(gravity);
    Body a = scene.box(5f, 3f, 0.5f, 0.25f);
    Body b = scene.box(7f, 3f, 0.25f, 0.5f);
    scene.world.createJoint(definition(type, scene, a, b));
    a.setLinearVelocity(new Vec2(1f, 2f));
    a.setAngularVelocity(3f);
    b.setLinearVelocity(new Vec2(-1f, 1f));
    b.setAngularVelocity(-2f);
    return scene;
  }

  /** A free pair conserves momentum and angular momentum. */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN", "MOUSE", "PULLEY"},
      mode = EnumSource.Mode.EXCLUDE)
  void aFreePairConservesMomentum(JointType type) {
    JointScene scene = scene(type, 0f);
    double[] before = scene.momentum();
    scene.step(120);
    double[] after = scene.momentum();
    scene.assertFinite();
    assertEquals(before[0], after[0], 1e-4);
    assertEquals(before[1], after[1], 1e-4);
    assertEquals(before[2], after[2], 1e-3, "angular momentum about the origin, 6 m away");
  }

  /**
   * Bodies that get faster may still make a buffer of the continuous phase grow once; what is
   * allocated in each step shows in every window.
   */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN"},
      mode = EnumSource.Mode.EXCLUDE)
  void aWarmStepAllocatesNothing(JointType type) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    assumeTrue(threads.isThreadAllocatedMemorySupported());
    JointScene scene = scene(type, 1f);
    scene.step(300);
    long thread = Thread.currentThread().getId();
    long used = Long.MAX_VALUE;
    for (int window = 0; window < 5; window++) {
      long before = threads.getThreadAllocatedBytes(thread);
      scene.step(100);
      used = Math.min(used, threads.getThreadAllocatedBytes(thread) - before);
    }
    assertTrue(used < 100, type + " allocated " + used + " bytes in 100 steps");
  }

  /** The same world again, the same bits. */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN"},
      mode = EnumSource.Mode.EXCLUDE)
  void twoRunsAgreeToTheBit(JointType type) {
    JointScene one = scene(type, 10f);
    JointScene two = scene(type, 10f);
    one.step(100);
    two.step(100);
    Body b = two.world.getBodyList();
    for (Body a = one.world.getBodyList(); a != null; a = a.getNext(), b = b.getNext()) {
      assertEquals(a.getPosition(), b.getPosition());
      assertEquals(a.getAngle(), b.getAngle());
      assertEquals(a.getLinearVelocity(), b.getLinearVelocity());
    }
  }

  /**
   * Spins and speeds up to far beyond what a step can follow leave numbers finite. Prismatic and
   * constant volume joints once drove themselves to infinity, because the terms for the bend of the
   * path, taken anew in each iteration, fed on each other.
   */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN"},
      mode = EnumSource.Mode.EXCLUDE)
  void violentMotionStaysFinite(JointType type) {
    for (int seed = 0; seed < 12; seed++) {
      JointScene scene = scene(type, 10f);
      Random random = new Random(seed);
      double scale = StrictMath.pow(10, seed % 6);
      for (Body b = scene.world.getBodyList(); b != null; b = b.getNext()) {
        b.setAngularVelocity((float) (scale * random.nextGaussian()));
        b.setLinearVelocity(
            new Vec2(
                (float) (scale * random.nextGaussian()), (float) (scale * random.nextGaussian())));
      }
      for (int i = 0; i < 120; i++) {
        scene.step(1);
        scene.assertFinite();
      }
    }
  }

  /** Bodies put far apart by hand come together again without being thrown away. */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"DISTANCE", "REVOLUTE", "PRISMATIC", "WHEEL", "WELD", "ROPE"})
  void bodiesTornApartComeTogether(JointType type) {
    JointScene scene = new JointScene(0f);
    Body a = scene.box(0f, 0f, 0.5f, 0.25f);
    Body b = scene.box(2f, 0f, 0.25f, 0.5f);
    Joint joint = scene.world.createJoint(definition(type, scene, a, b));
    float gap = JointScene.gap(joint);
    b.setTransform(new Vec2(7f, 4f), 2f);
    scene.step(300);
    scene.assertFinite();
    assertEquals(gap, JointScene.gap(joint), type == JointType.WHEEL ? 1f : 0.25f);
  }

  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN", "GEAR"},
      mode = EnumSource.Mode.EXCLUDE)
  void theJointRemembersItsDefinition(JointType type) {
    JointScene scene = new JointScene(0f);
    Body a = scene.box(0f, 0f, 0.5f, 0.25f);
    Body b = scene.box(2f, 0f, 0.25f, 0.5f);
    JointDef def = definition(type, scene, a, b);
    assertSame(type, def.type);
    def.userData = "mine";
    def.collideConnected = true;
    Joint joint = scene.world.createJoint(def);
    assertSame(type, joint.getType());
    assertSame(a, joint.getBodyA());
    assertSame(b, joint.getBodyB());
    assertEquals("mine", joint.getUserData());
    assertTrue(joint.getCollideConnected());
    assertTrue(joint.isActive());
    b.setActive(false);
    assertFalse(joint.isActive());
  }

  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN", "GEAR", "MOUSE", "CONSTANT_VOLUME"},
      mode = EnumSource.Mode.EXCLUDE)
  void oneBodyCannotBeJoinedToItself(JointType type) {
    JointScene scene = new JointScene(0f);
    Body a = scene.box(0f, 0f, 0.5f, 0.25f);
    Body b = scene.box(2f, 0f, 0.25f, 0.5f);
    JointDef def = definition(type, scene, a, b);
    def.bodyB = a;
    BadInput.rejected(scene, def, "same body");
    def.bodyB = null;
    BadInput.rejected(scene, def, "bodyB");
    def.bodyB = new JointScene(0f).ground;
    BadInput.rejected(scene, def, "bodyB");
  }

  /** Bodies of which neither can be moved by forces: a joint between them rests. */
  @ParameterizedTest
  @EnumSource(
      value = JointType.class,
      names = {"UNKNOWN", "GEAR", "CONSTANT_VOLUME"},
      mode = EnumSource.Mode.EXCLUDE)
  void aJointOfKinematicBodiesRests(JointType type) {
    JointScene scene = new JointScene(10f);
    Body a = scene.body(BodyType.KINEMATIC, 0f, 0f);
    Body b = scene.body(BodyType.KINEMATIC, 2f, 0f);
    scene.world.createJoint(definition(type, scene, a, b));
    b.setLinearVelocity(new Vec2(1f, 0f));
    scene.step(60);
    scene.assertFinite();
    assertEquals(1f, b.getLinearVelocity().x);
    assertEquals(3f, b.getPosition().x, 1e-4f);
  }

  static Stream<JointDef> definitionsOfAnotherClass() {
    JointDef unknown = new JointDef();
    JointDef wrong = new JointDef(JointType.WELD);
    JointDef none = new JointDef();
    none.type = null;
    return Stream.of(unknown, wrong, none);
  }

  @ParameterizedTest
  @MethodSource("definitionsOfAnotherClass")
  void aDefinitionMustFitItsType(JointDef def) {
    JointScene scene = new JointScene(0f);
    def.bodyA = scene.ground;
    def.bodyB = scene.box(0f, 0f, 1f, 1f);
    BadInput.rejected(scene, def, "JointDef.type");
  }

  @Test
  void aDestroyedJointCannotBeDestroyedAgain() {
    JointScene scene = scene(JointType.WELD, 0f);
    WeldJoint joint = (WeldJoint) scene.world.getJointList();
    scene.world.destroyBody(joint.getBodyB());
    assertEquals(0, scene.world.getJointCount());
    assertThrows(IllegalArgumentException.class, () -> scene.world.destroyJoint(joint));
    joint.setFrequency(1f);
    scene.step(1);
  }

  /** Nothing is left of a joint that was destroyed: the bodies move freely. */
  @Test
  void bodiesAreFreeAfterTheirJoint() {
    JointScene scene = new JointScene(0f);
    Body a = scene.box(0f, 0f, 0.5f, 0.25f);
    Body b = scene.box(2f, 0f, 0.25f, 0.5f);
    Joint joint = scene.world.createJoint(definition(JointType.WELD, scene, a, b));
    scene.step(5);
    scene.world.destroyJoint(joint);
    b.setLinearVelocity(new Vec2(3f, 0f));
    scene.step(60);
    assertEquals(3f, b.getLinearVelocity().x);
    assertEquals(0f, a.getPosition().x, 1e-5f);
  }

  /** With a step of half the length kept impulses are halved: a hanging body does not stir. */
  @Test
  void aChangeOfStepLengthDoesNotStirAHangingBody() {
    JointScene scene = new JointScene(10f);
    Body b = scene.box(0f, -2f, 0.5f, 0.5f);
    scene.world.createJoint(definition(JointType.DISTANCE, scene, scene.ground, b));
    scene.step(60);
    scene.world.step(1f / 120f, 1, 1);
    assertEquals(0f, b.getLinearVelocity().y, 1e-5f);
    assertEquals(-2f, b.getPosition().y, 1e-5f);
  }
}
