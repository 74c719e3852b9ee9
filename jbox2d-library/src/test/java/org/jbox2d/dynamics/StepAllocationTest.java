package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.MouseJoint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.api.Test;

/** A warm step of a scene without births and deaths allocates nothing. */
class StepAllocationTest {
  private static final int ROUND = 20;

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  @Test
  void pyramid() {
    World world = Make.pyramid(15);
    world.setSleepingAllowed(false);
    assertNoneAllocated(world, 200, 10);
  }

  @Test
  void pyramidWithSubsteps() {
    for (Solver solver : new Solver[] {Solver.softStep(), Solver.adaptive()}) {
      World world = Make.pyramid(15);
      world.setSolver(solver);
      world.setSleepingAllowed(false);
      assertNoneAllocated(world, 200, 10);
    }
  }

  /** A chain with a weight, which is solved at once, and dolls of hinges that lie on the ground. */
  @Test
  void hingesWithSubsteps() {
    for (Solver solver : new Solver[] {Solver.softStep(), Solver.adaptive()}) {
      World world = Make.world();
      world.setSolver(solver);
      world.setSleepingAllowed(false);
      Body last = Make.ground(world);
      for (int i = 0; i < 8; i++) {
        Body link = Make.box(world, BodyType.DYNAMIC, 0.5f + i, 12f, i < 7 ? 0.5f : 2f, 0.1f);
        hinge(world, last, link, i);
        last = link;
      }
      Body lying = Make.box(world, BodyType.DYNAMIC, -10f, 0.1f, 0.5f, 0.1f);
      hinge(world, lying, Make.box(world, BodyType.DYNAMIC, -9f, 0.1f, 0.5f, 0.1f), -9.5f);
      assertNoneAllocated(world, 200, 10);
    }
  }

  private static void hinge(World world, Body a, Body b, float x) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(x, b.getPosition().y));
    world.createJoint(def);
  }

  @Test
  void pileOfDebris() {
    World world = Make.debris(150, 9);
    world.setSleepingAllowed(false);
    assertNoneAllocated(world, 600, 10);
  }

  @Test
  void pileOfDebrisThatHearsAndIsPulledAt() {
    World world = Make.debris(150, 9);
    world.setContactListener(new CollisionResponseTest.QuietListener());
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      b.getFixtureList().setMaterial((fixture, solved) -> solved.normalImpulse());
    }
    MouseJointDef def = new MouseJointDef();
    Body body = world.getBodyList();
    def.bodyA = body.getNext();
    def.bodyB = body;
    def.target.set(body.getPosition());
    def.maxForce = 100f;
    MouseJoint joint = (MouseJoint) world.createJoint(def);
    joint.setTarget(new Vec2(0f, 20f));
    assertNoneAllocated(world, 600, 10);
  }

  /** It keeps churning, so now and then an array still grows: the best of many rounds counts. */
  @Test
  void tumbler() {
    World world = Make.tumbler(100);
    assertNoneAllocated(world, 1200, 30);
  }

  @Test
  void bodiesThatMeetAndPart() {
    World world = Make.world();
    Make.ground(world);
    for (int i = 0; i < 40; i++) {
      Body ball = Make.disc(world, 0.7f * i, 3f + 0.1f * i, 0.3f);
      Make.surface(ball, 0f, 1f);
    }
    assertNoneAllocated(world, 600, 30);
  }

  /** Fast bullets in a box: many impacts in each step, with contacts made and dropped. */
  @Test
  void bullets() {
    assertNoneAllocated(Make.bullets(60, 4), 900, 60);
  }

  @Test
  void sleepers() {
    World world = Make.pyramid(10);
    Make.steps(world, 400);
    assertEquals(0, world.awake.count);
    assertNoneAllocated(world, 50, 10);
  }

  private void assertNoneAllocated(World world, int warmUp, int rounds) {
    Make.steps(world, warmUp);
    long fewest = Long.MAX_VALUE;
    for (int round = 0; round < rounds; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      Make.steps(world, ROUND);
      fewest = Math.min(fewest, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, fewest, "bytes in " + ROUND + " steps");
    assertTrue(world.getContactCount() > 0);
  }
}
