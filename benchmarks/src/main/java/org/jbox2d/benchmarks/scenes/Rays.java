package org.jbox2d.benchmarks.scenes;

import java.util.Random;
import org.jbox2d.benchmarks.engines.Sim;

/** 10,000 rays through a settled pile of 2,000 polygons, each to its nearest hit; no step. */
final class Rays extends SteppedScene {
  private static final int RAYS = 10_000;
  private static final int SETTLING_STEPS = 240;

  private final double[] ends = new double[4 * RAYS];

  /** Sum of what the rays returned: kept, or the compiler might drop them. */
  private double sum;

  Rays(Sim sim) {
    super(sim);
    SteppedScene pile = Piles.debris(sim, 2000);
    for (int i = 0; i < SETTLING_STEPS; i++) {
      pile.step();
    }
    Random random = new Random(3);
    for (int i = 0; i < ends.length; i += 2) {
      ends[i] = 20 * random.nextDouble() - 10;
      ends[i + 1] = 20 * random.nextDouble();
    }
  }

  @Override
  public void step() {
    for (int i = 0; i < ends.length; i += 4) {
      sum += sim.ray(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
    }
  }

  /** Mean part of the rays' ways that was free. */
  double free() {
    return sum / RAYS;
  }
}
