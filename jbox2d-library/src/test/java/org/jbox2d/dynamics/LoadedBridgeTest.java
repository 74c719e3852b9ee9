package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Blocks of eight times a plank's mass fall on a bridge of hinged planks that is just as long as
 * the gap between its piers. Thrown up again it is pulled straight, where the paths that its hinges
 * ask for contradict each other.
 */
class LoadedBridgeTest {
  private static final int PLANKS = 12;
  private static final float HALF = 1.2f;

  static Solver[] solvers() {
    return new Solver[] {Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()};
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void energyDoesNotGrow(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    Body ground = Make.ground(world);
    build(world, ground);
    double most = energy(world);
    for (int i = 0; i < 600; i++) {
      Make.steps(world, 1);
      double now = energy(world);
      assertTrue(now < most + 100.0, "step " + i + ": " + now + " J of " + most + " J");
    }
  }

  private static void build(World world, Body ground) {
    Body before = Make.box(world, BodyType.STATIC, -PLANKS * HALF - 2f, 4f, 2f, 4f);
    float x = -PLANKS * HALF;
    for (int i = 0; i < PLANKS; i++) {
      Body plank = Make.body(world, BodyType.DYNAMIC, x + HALF, 7.75f);
      plank.createFixture(Make.boxShape(HALF, 0.25f), 1.5f);
      Make.surface(plank, 0.6f, 0f);
      plank.setAngularDamping(1f);
      hinge(world, before, plank, x);
      before = plank;
      x += 2f * HALF;
    }
    hinge(world, before, Make.box(world, BodyType.STATIC, x + 2f, 4f, 2f, 4f), x);
    for (int i = 0; i < 6; i++) {
      Body block = Make.body(world, BodyType.DYNAMIC, -7.5f + 3f * i, 14f + 4f * (i % 3));
      block.createFixture(Make.boxShape(0.8f, 0.8f), 6f);
      Make.surface(block, 0.6f, 0f);
    }
  }

  private static void hinge(World world, Body a, Body b, float x) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(x, 7.75f));
    world.createJoint(def);
  }

  private static double energy(World world) {
    double sum = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() == BodyType.DYNAMIC) {
        double w = b.getAngularVelocity();
        sum += 0.5 * b.getMass() * b.getLinearVelocity().lengthSquared();
        sum += 0.5 * b.getInertia() * w * w + b.getMass() * Make.G * b.getPosition().y;
      }
    }
    return sum;
  }
}
