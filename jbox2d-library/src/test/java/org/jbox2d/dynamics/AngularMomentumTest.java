package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * With substeps, boxes that fly at each other keep their momentum and their angular momentum, and
 * gain no energy, though the arms of their contacts are those of the start of a step and overlap is
 * pushed apart. Of the sum of the magnitudes it is made of, their angular momentum changed by up to
 * 1 % before that was seen to; with sequential impulses it still does, by up to 2 %, as it did in
 * the original.
 */
class AngularMomentumTest {
  private static final int STEPS = 60;
  private static final int SEEDS = 40;

  /** Rounding of the places and velocities of all steps, as a share of the magnitudes. */
  private static final double ROUNDING = 1e-4;

  static Stream<Solver> solvers() {
    return Stream.of(Solver.softStep(), Solver.adaptive());
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void freeCollisionsKeepIt(Solver solver) {
    int hits = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      hits += keepsIt(solver, new Vec2(), 2 + seed % 4, seed, 0f) ? 1 : 0;
    }
    assertTrue(hits > SEEDS / 2, hits + " hit");
  }

  /**
   * What falls as a whole has it about its centre of mass. Two boxes, which touch or fly both: with
   * substeps, what touches falls by half of {@code g dt h} further in a step than what does not, h
   * the substep.
   */
  @ParameterizedTest
  @MethodSource("solvers")
  void fallingBodiesKeepIt(Solver solver) {
    int hits = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      hits += keepsIt(solver, new Vec2(3f, -10f), 2, seed, 0f) ? 1 : 0;
    }
    assertTrue(hits > SEEDS / 2, hits + " hit");
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void bouncesKeepIt(Solver solver) {
    int hits = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      hits += keepsIt(solver, new Vec2(), 2 + seed % 4, seed, 0.8f) ? 1 : 0;
    }
    assertTrue(hits > SEEDS / 2, hits + " hit");
  }

  /** Returns whether they hit each other. */
  private static boolean keepsIt(Solver solver, Vec2 gravity, int n, int seed, float restitution) {
    World world = new World(gravity);
    world.setSolver(solver);
    List<Body> bodies = Make.thrownTogether(world, n, 10f, new Random(seed));
    for (Body body : bodies) {
      Make.surface(body, 0.5f, restitution);
    }
    Totals before = new Totals(bodies);
    double least = before.energy;
    for (int i = 0; i < STEPS; i++) {
      world.step(Make.STEP, 8, 3);
      least = Math.min(least, new Totals(bodies).energy);
    }
    Totals after = new Totals(bodies);
    String what = solver + ", seed " + seed + ": ";
    double spin = Math.abs(after.spin - before.spin) / before.magnitude;
    assertTrue(spin < ROUNDING, what + "angular momentum changed by " + spin);
    double gain = (after.energy - before.energy) / before.energy;
    assertTrue(gain < ROUNDING, what + "energy gained " + gain);
    return least < 0.99 * before.energy;
  }

  /** Of bodies, about their centre of mass and against its velocity. */
  private static final class Totals {
    double spin;
    double magnitude;
    double energy;

    Totals(List<Body> bodies) {
      double mass = 0;
      double x = 0;
      double y = 0;
      double vx = 0;
      double vy = 0;
      for (Body b : bodies) {
        mass += b.m_mass;
        x += b.m_mass * b.m_sweep.c.x;
        y += b.m_mass * b.m_sweep.c.y;
        vx += b.m_mass * b.m_linearVelocity.x;
        vy += b.m_mass * b.m_linearVelocity.y;
      }
      for (Body b : bodies) {
        add(b, b.m_sweep.c.x - x / mass, b.m_sweep.c.y - y / mass, vx / mass, vy / mass);
      }
    }

    private void add(Body b, double x, double y, double meanX, double meanY) {
      double u = b.m_linearVelocity.x - meanX;
      double v = b.m_linearVelocity.y - meanY;
      double w = b.m_angularVelocity;
      spin += b.m_mass * (x * v - y * u) + b.m_I * w;
      magnitude += b.m_mass * Math.hypot(x, y) * Math.hypot(u, v) + b.m_I * Math.abs(w);
      energy += 0.5 * (b.m_mass * (u * u + v * v) + b.m_I * w * w);
    }
  }
}
