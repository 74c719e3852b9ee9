package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.Stream;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A ball breaks a free block off its centre: what the two had of angular momentum, the ball and the
 * pieces have two seconds later, with substeps. From the blow to the next step the ball has been
 * held up by what then broke, and both it and the pieces make up for that; in which up to 4 % of it
 * went before that was seen to, 0.3 to 0.7 % on average at 30 and 60 Hz.
 */
class ShotSpinTest {
  private static final int SEEDS = 30;

  /** As a share of the magnitudes that it is the sum of. */
  private static final double MOST = 1e-3;

  /** A bullet that meets pieces within a step: the rest of its way is not along its velocity. */
  private static final double MOST_OF_BULLETS = 0.02;

  private static final double MEAN_OF_BULLETS = 0.0015;

  static Stream<Solver> solvers() {
    return Stream.of(Solver.softStep(), Solver.adaptive());
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void ballsKeepIt(Solver solver) {
    for (float hz : new float[] {30f, 60f, 120f}) {
      for (int seed = 0; seed < SEEDS; seed++) {
        double error = errorOf(solver, hz, seed, false);
        assertTrue(error < MOST, hz + " Hz, seed " + seed + ": " + error);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void bulletsNearlyKeepIt(Solver solver) {
    for (float hz : new float[] {30f, 60f, 120f}) {
      double sum = 0;
      for (int seed = 0; seed < SEEDS; seed++) {
        double error = errorOf(solver, hz, seed, true);
        assertTrue(error < MOST_OF_BULLETS, hz + " Hz, seed " + seed + ": " + error);
        sum += error;
      }
      assertTrue(sum / SEEDS < MEAN_OF_BULLETS, hz + " Hz: " + sum / SEEDS);
    }
  }

  private static double errorOf(Solver solver, float hz, int seed, boolean bullet) {
    World world = new World(new Vec2());
    world.setSolver(solver);
    FractureSystem.of(world).setSeed(seed);
    Random random = new Random(seed);
    Body block = Range.body(world, BodyType.DYNAMIC, 0f, 0f);
    Range.fixture(block, Range.box(2f, 3f), 1f, Range.uniform(20f, 2f)).setFriction(0.5f);
    block.setAngularVelocity(2f * random.nextFloat() - 1f);
    float y = 3f * random.nextFloat() - 1.5f;
    float speed = 20f + 35f * random.nextFloat();
    Body ball = Range.disc(world, -6f, y, 0.5f, 5f, speed, 10f * random.nextFloat() - 5f);
    ball.setBullet(bullet);
    Totals before = Totals.of(world);
    Range.step(world, hz, 2f);
    assertTrue(FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
    return Math.abs(Totals.of(world).spin - before.spin) / before.spinScale;
  }
}
