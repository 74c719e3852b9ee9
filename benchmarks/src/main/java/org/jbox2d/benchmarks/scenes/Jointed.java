package org.jbox2d.benchmarks.scenes;

import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** Scenes with joints. */
public final class Jointed {
  private Jointed() {}

  /** A square net of discs hung up in the middle of its upper edge. The discs do not collide. */
  public static SteppedScene jointGrid(Sim sim, int side) {
    Matter matter = Matter.rough(1, 0.2).ghostly();
    SimBody[] column = new SimBody[side];
    for (int k = 0; k < side; k++) {
      for (int i = 0; i < side; i++) {
        boolean hook = i == 0 && Math.abs(k - side / 2) <= 3;
        SimBody disc = sim.body(hook ? Kind.STATIC : Kind.DYNAMIC, k, -i, 0).disc(0.4, matter);
        if (i > 0) {
          sim.hinge(column[i - 1], disc, k, 0.5 - i);
        }
        if (k > 0) {
          sim.hinge(column[i], disc, k - 0.5, -i);
        }
        column[i] = disc;
      }
    }
    return new SteppedScene(sim);
  }

  /** A long bar turns in a ring of 360 edges and stirs 6,075 small bodies. */
  static SteppedScene spinner(Sim sim) {
    Matter slick = Matter.rough(0.25, 0.1);
    SimBody ground = sim.ground().chain(slick, ring(360, 40));
    SimBody bar = sim.dynamic(0, -20).box(0.6, 20, Matter.smooth(1));
    sim.motor(ground, bar, 0, -20, 5, 40_000);
    for (int i = 0; i < 6075; i++) {
      SimBody body = sim.dynamic(-23.75 + 0.5 * (i % 96), 2 + 0.4 * (i / 96));
      switch (i % 3) {
        case 0 -> body.box(0.25, 0.12, slick);
        case 1 -> body.disc(0.17, slick);
        default -> body.box(0.17, 0.17, slick);
      }
    }
    return new SteppedScene(sim);
  }

  /** A closed ring, clockwise; its first point comes again at the end. */
  private static double[] ring(int points, double radius) {
    double[] vertices = new double[2 * points + 2];
    for (int i = 0; i <= points; i++) {
      double angle = -2 * Math.PI * (i % points) / points;
      vertices[2 * i] = radius * StrictMath.cos(angle);
      vertices[2 * i + 1] = radius * StrictMath.sin(angle);
    }
    return vertices;
  }
}
