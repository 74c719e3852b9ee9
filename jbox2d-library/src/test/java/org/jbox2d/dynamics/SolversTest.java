package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What solvers with substeps get right, by laws of mechanics. */
class SolversTest {
  private static final float TAN_10 = 0.17633f;

  static Stream<Solver> substeps() {
    return Stream.of(Solver.softStep(2), Solver.softStep(), Solver.softStep(8), Solver.adaptive());
  }

  private static World world(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    return world;
  }

  private static void pin(World world, Body a, Body b, float x, float y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(x, y));
    world.createJoint(def);
  }

  @Test
  void sequentialImpulsesAreTheDefault() {
    World world = Make.world();
    assertEquals(Solver.sequentialImpulses(), world.getSolver());
    world.setSolver(Solver.softStep(6));
    assertEquals(Solver.softStep(6), world.getSolver());
    assertFalse(Solver.softStep(6).equals(Solver.softStep(7)));
    assertEquals(Solver.adaptive().hashCode(), Solver.adaptive().hashCode());
  }

  @Test
  void refusesWhatIsNoChoice() {
    assertThrows(IllegalArgumentException.class, () -> Solver.softStep(0));
    assertThrows(IllegalArgumentException.class, () -> Solver.adaptive(0, 4));
    assertThrows(IllegalArgumentException.class, () -> Solver.adaptive(4, 4));
    assertThrows(IllegalArgumentException.class, () -> Make.world().setSolver(null));
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void freeFallIsExact(Solver solver) {
    World world = world(solver);
    Body disc = Make.disc(world, 0f, 0f, 0.5f);
    disc.setLinearVelocity(new Vec2(3f, 4f));
    Make.steps(world, 120);
    assertEquals(6f, disc.getPosition().x, 1e-4f);
    assertEquals(8f - 20f, disc.getPosition().y, 1e-4f);
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void aStackStandsAndSleeps(Solver solver) {
    World world = world(solver);
    Make.ground(world);
    Body top = null;
    for (int i = 0; i < 10; i++) {
      top = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f + i, 0.5f, 0.5f);
    }
    Make.steps(world, 400);
    assertFalse(top.isAwake());
    assertEquals(9.5f, top.getPosition().y, 0.1f);
    assertEquals(0f, top.getPosition().x, 0.01f);
  }

  /** A box of 1000 times the mass sinks into the light one below by a share of its size alone. */
  @ParameterizedTest
  @ValueSource(floats = {10f, 100f, 1000f})
  void heavyOnLight(float ratio) {
    World world = world(Solver.adaptive());
    Make.ground(world);
    Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Body heavy = Make.body(world, BodyType.DYNAMIC, 0f, 1.5f);
    heavy.createFixture(Make.boxShape(0.5f, 0.5f), ratio);
    Make.steps(world, 400);
    assertEquals(1.5f, heavy.getPosition().y, 0.03f);
    assertEquals(0f, heavy.getPosition().x, 0.01f);
  }

  /** The end of a chain of ten links stays at its length, whatever hangs on it. */
  @ParameterizedTest
  @ValueSource(floats = {1f, 100f, 1000f})
  void chainWithALoad(float mass) {
    World world = world(Solver.adaptive());
    Body before = Make.body(world, BodyType.STATIC, 0f, 0f);
    for (int i = 0; i < 10; i++) {
      Body link = Make.box(world, BodyType.DYNAMIC, 0f, -0.5f - i, 0.25f, 0.5f);
      pin(world, before, link, 0f, -i);
      before = link;
    }
    Body load = Make.body(world, BodyType.DYNAMIC, 0f, -10.5f);
    load.createFixture(Make.boxShape(0.5f, 0.5f), mass);
    pin(world, before, load, 0f, -10f);
    load.setLinearVelocity(new Vec2(1f, 0f));
    for (int i = 0; i < 300; i++) {
      Make.steps(world, 1);
      float length = load.getWorldPoint(new Vec2(0f, 0.5f)).length();
      assertTrue(length < 10.06f, "length " + length + " in step " + i);
    }
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void aPendulumKeepsItsEnergy(Solver solver) {
    World world = world(solver);
    Body pivot = Make.body(world, BodyType.STATIC, 0f, 0f);
    Body bob = Make.box(world, BodyType.DYNAMIC, 2f, 0f, 0.1f, 0.1f);
    pin(world, pivot, bob, 0f, 0f);
    double inertia = bob.getInertia();
    for (int i = 0; i < 1200; i++) {
      Make.steps(world, 1);
      double energy =
          0.5 * bob.getMass() * bob.getLinearVelocity().lengthSquared()
              + 0.5 * inertia * bob.getAngularVelocity() * bob.getAngularVelocity()
              + bob.getMass() * Make.G * bob.getPosition().y;
      // of what it gains from the top to the lowest point
      assertEquals(0.0, energy / (bob.getMass() * Make.G * 2f), 0.02, "step " + i);
    }
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void aBlowRunsThroughARowOfBalls(Solver solver) {
    World world = Make.weightless();
    world.setSolver(solver);
    Body[] balls = new Body[5];
    for (int i = 0; i < 5; i++) {
      balls[i] = Make.disc(world, i == 0 ? -2f : i, 0f, 0.5f);
      Make.surface(balls[i], 0f, 1f);
    }
    balls[0].setLinearVelocity(new Vec2(4f, 0f));
    Make.steps(world, 60);
    assertEquals(4f, balls[4].getLinearVelocity().x, 0.04f);
    for (int i = 0; i < 4; i++) {
      assertEquals(0f, balls[i].getLinearVelocity().x, 0.04f, "ball " + i);
    }
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void aBallBouncesToItsHeight(Solver solver) {
    World world = world(solver);
    Make.surface(Make.ground(world), 0f, 1f);
    Body ball = Make.disc(world, 0f, 5.5f, 0.5f);
    Make.surface(ball, 0f, 1f);
    float top = 0f;
    for (int i = 0; i < 1200; i++) {
      Make.steps(world, 1);
      top = i > 900 ? Math.max(top, ball.getPosition().y) : top;
    }
    assertEquals(5.5f, top, 0.05f);
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void overlapGoesAwayWithoutAJump(Solver solver) {
    World world = world(solver);
    Make.ground(world);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.3f, 0.5f, 0.5f);
    for (int i = 0; i < 60; i++) {
      Make.steps(world, 1);
      assertTrue(box.getLinearVelocity().y < 0.1f);
    }
    assertEquals(0.5f, box.getPosition().y, 0.02f);
  }

  /** What listener and material hear of a falling and resting box is its change of momentum. */
  @ParameterizedTest
  @MethodSource("substeps")
  void impulsesAreTheChangeOfMomentum(Solver solver) {
    World world = world(solver);
    Make.ground(world);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 1f, 0.5f, 0.5f);
    box.setSleepingAllowed(false);
    double[] heard = new double[2];
    world.setContactListener(
        new QuietListener() {
          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {
            for (int i = 0; i < impulse.count; i++) {
              heard[0] += impulse.normalImpulses[i];
            }
          }
        });
    box.getFixtureList().setMaterial((fixture, solved) -> heard[1] += solved.normalImpulse());
    int steps = 120;
    Make.steps(world, steps);
    double momentum = box.getMass() * (Make.G * steps * Make.STEP + box.getLinearVelocity().y);
    assertEquals(momentum, heard[0], 1e-3 * momentum);
    assertEquals(momentum, heard[1], 1e-3 * momentum);
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void aBoxSticksAndSlips(Solver solver) {
    for (float margin : new float[] {0.98f, 1.02f}) {
      World world = world(solver);
      world.setGravity(new Vec2(Make.G * TAN_10, -Make.G));
      Make.surface(Make.ground(world), margin * TAN_10, 0f);
      Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.26f, 0.5f, 0.25f);
      Make.surface(box, margin * TAN_10, 0f);
      box.setSleepingAllowed(false);
      Make.steps(world, 30);
      float start = box.getPosition().x;
      Make.steps(world, 120);
      float way = box.getPosition().x - start;
      double slides = 0.5 * 0.02 * TAN_10 * Make.G * 4;
      if (margin > 1f) {
        assertEquals(0.0, way, 1e-3);
      } else {
        assertTrue(way > 0.8 * slides, "slid " + way + " of " + slides);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("substeps")
  void repeatsItself(Solver solver) {
    assertArrayEquals(new long[] {pile(solver)}, new long[] {pile(solver)});
  }

  private static long pile(Solver solver) {
    World world = Make.debris(40, 3);
    world.setSolver(solver);
    Make.steps(world, 200);
    WorldInvariants.check(world);
    return StateHash.of(world);
  }

  /** An island that is changed from one solver to another goes on standing. */
  @Test
  void aChangeOfSolverDoesNotDisturb() {
    World world = Make.pyramid(6);
    world.setSleepingAllowed(false);
    Solver[] all = {Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()};
    Make.steps(world, 120);
    for (int round = 0; round < 9; round++) {
      world.setSolver(all[round % 3]);
      Make.steps(world, 30);
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        assertTrue(b.getLinearVelocity().length() < 0.2f, "round " + round);
      }
    }
  }

  private abstract static class QuietListener implements ContactListener {
    @Override
    public void beginContact(Contact contact) {}

    @Override
    public void endContact(Contact contact) {}

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {}
  }
}
