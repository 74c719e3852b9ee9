package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.Joint;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Ten links of half a metre with a weight at their end. By iterations alone four substeps stretched
 * them by 9 cm with a weight of a hundred links, by a metre with one of a thousand, and by more
 * than their length with one of ten thousand.
 */
class LoadedChainTest {
  private static final int LINKS = 10;
  private static final float LENGTH = 0.5f;
  private static final int SECOND = 60;

  private World world;
  private Body weight;

  @ParameterizedTest
  @CsvSource({"2, 100", "4, 100", "2, 1000", "4, 1000", "4, 10000"})
  void hangsAsLongAsItIs(int substeps, float ratio) {
    build(LINKS, 0f, ratio, Solver.softStep(substeps));
    Make.steps(world, 10 * SECOND);
    assertEquals(-LINKS * LENGTH, weight.getPosition().y, 0.001f);
    assertTrue(Chains.largestGap(world) < 0.001f);
    assertTrue(weight.getLinearVelocity().length() < 0.001f);
  }

  /** Let go level, its links crack when the weight passes below. */
  @ParameterizedTest
  @CsvSource({"20", "100", "1000"})
  void holdsWhenItSwings(float ratio) {
    build(LINKS, 0.5f * (float) Math.PI, ratio, Solver.adaptive());
    float gap = 0f;
    for (int i = 0; i < 20 * SECOND; i++) {
      world.step(Make.STEP, 8, 3);
      gap = Math.max(gap, Chains.largestGap(world));
    }
    assertTrue(gap < 0.02f, "gap " + gap);
  }

  /**
   * A flail of two links and a weight that turns without gravity keeps its energy for ten seconds.
   * By iterations alone a tenth was gone with a weight of twenty links at 5 rad/s, nearly half at
   * 10, and three quarters at 20; with one of four links a thirtieth, a quarter and two thirds.
   */
  @ParameterizedTest
  @CsvSource({"4, 5", "4, 10", "4, 20", "20, 5", "20, 10", "20, 20"})
  void aFlailGoesOn(float ratio, float spin) {
    for (Solver solver : new Solver[] {Solver.softStep(), Solver.adaptive()}) {
      build(2, 0.5f * (float) Math.PI, ratio, solver);
      world.setGravity(new Vec2());
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        b.setAngularVelocity(spin);
        b.setLinearVelocity(new Vec2(0f, spin * b.getWorldCenter().x));
      }
      float before = Chains.energy(world, 0f);
      Make.steps(world, 10 * SECOND);
      assertEquals(1f, Chains.energy(world, 0f) / before, 0.01f);
    }
  }

  /** What bears the weight is told by the upper hinge: the weight of all. */
  @ParameterizedTest
  @CsvSource({"100", "1000"})
  void theUpperHingeBearsAll(float ratio) {
    build(LINKS, 0f, ratio, Solver.softStep());
    Make.steps(world, 2 * SECOND);
    Joint upper = world.getJointList();
    while (upper.getNext() != null) {
      upper = upper.getNext();
    }
    Vec2 force = new Vec2();
    upper.getReactionForce(SECOND, force);
    float mass = weight.getMass() * (1 + LINKS / ratio);
    assertEquals(mass * Make.G, force.y, 0.001f * mass * Make.G);
  }

  private void build(int links, float angle, float ratio, Solver solver) {
    world = Make.world();
    world.setSolver(solver);
    world.setAllowSleep(false);
    weight = Chains.hangWeight(world, links, LENGTH, angle, ratio);
  }
}
