package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Joints at anchors far outside of small bodies: an impulse of the joint turns such a body so fast
 * that the length changes, or the path of the anchor bends, by more than the impulse takes away. A
 * rigid, frictionless joint does no work, so without forces the energy stays what it was, or falls
 * where a joint is stretched by the throw.
 */
class FarAnchorTest {
  private static final int CASES = 200;
  private static final int STEPS = 60;

  /**
   * A step turns these bodies by up to a radian, where the paths that joints follow are coarse:
   * some energy comes and goes. Before it was bounded it grew by nine powers of ten in such cases.
   */
  private static final double MOST_GAIN = 2.5;

  enum Kind {
    DISTANCE,
    ROPE,
    PULLEY,
    REVOLUTE,
    WELD,
    PRISMATIC,
    LIMITED_PRISMATIC,
    WHEEL
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void noEnergyComesFromNowhere(Kind kind) {
    Solver[] solvers = {Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()};
    for (int i = 0; i < CASES; i++) {
      Random random = new Random(i);
      World world = new World(new Vec2());
      world.setSolver(solvers[i % 3]);
      world.setAllowSleep(false);
      Body a = disc(world, random);
      Body b = disc(world, random);
      world.createJoint(joint(kind, a, b, random));
      double start = energy(a) + energy(b);
      float dt = 1f / (30 << random.nextInt(3));
      for (int k = 0; k < STEPS; k++) {
        world.step(dt, 8, 3);
        double now = energy(a) + energy(b);
        assertTrue(now <= MOST_GAIN * start, "case " + i + " step " + k + ": " + now / start);
      }
    }
  }

  private static double energy(Body b) {
    double v2 = b.getLinearVelocity().lengthSquared();
    double w = b.getAngularVelocity();
    return 0.5 * (b.getMass() * v2 + b.m_I * w * w);
  }

  private static Body disc(World world, Random random) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(between(random, 2f), between(random, 2f));
    def.linearVelocity.set(between(random, 30f), between(random, 30f));
    def.angularVelocity = between(random, 30f);
    Body body = world.createBody(def);
    CircleShape shape = new CircleShape();
    shape.m_radius = 0.05f + 0.1f * random.nextFloat();
    body.createFixture(shape, 1f).setSensor(true);
    return body;
  }

  private static JointDef joint(Kind kind, Body a, Body b, Random random) {
    Vec2 atA = a.getPosition().add(new Vec2(between(random, 0.6f), between(random, 0.6f)));
    Vec2 atB = b.getPosition().add(new Vec2(between(random, 0.6f), between(random, 0.6f)));
    switch (kind) {
      case DISTANCE:
        DistanceJointDef distance = new DistanceJointDef();
        distance.initialize(a, b, atA, atB);
        return distance;
      case ROPE:
        RopeJointDef rope = new RopeJointDef();
        rope.bodyA = a;
        rope.bodyB = b;
        rope.localAnchorA.set(a.getLocalPoint(atA));
        rope.localAnchorB.set(b.getLocalPoint(atB));
        rope.maxLength = atB.sub(atA).length();
        return rope;
      case REVOLUTE:
        RevoluteJointDef revolute = new RevoluteJointDef();
        revolute.initialize(a, b, atA);
        return revolute;
      case WELD:
        WeldJointDef weld = new WeldJointDef();
        weld.initialize(a, b, atA);
        return weld;
      case PRISMATIC:
      case LIMITED_PRISMATIC:
        PrismaticJointDef prismatic = new PrismaticJointDef();
        prismatic.initialize(a, b, atA, new Vec2(0.6f, 0.8f));
        prismatic.enableLimit = kind == Kind.LIMITED_PRISMATIC;
        prismatic.lowerTranslation = -0.1f;
        prismatic.upperTranslation = 0.1f;
        return prismatic;
      case WHEEL:
        WheelJointDef wheel = new WheelJointDef();
        wheel.initialize(a, b, atA, new Vec2(0.6f, 0.8f));
        wheel.frequencyHz = 0f;
        return wheel;
      default:
        PulleyJointDef pulley = new PulleyJointDef();
        pulley.initialize(a, b, new Vec2(-1, 5), new Vec2(1, 5), atA, atB, 1.5f);
        return pulley;
    }
  }

  private static float between(Random random, float most) {
    return most * (2 * random.nextFloat() - 1);
  }
}
