package org.jbox2d.benchmarks.scenes;

import java.util.Random;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** Many bodies that lie on each other or are about to. */
public final class Piles {
  private static final double DEBRIS_RADIUS = 0.25;
  private static final int DEBRIS_COLUMNS = 40;

  private Piles() {}

  /** A triangle of boxes that stands on a floor, with so many boxes at its foot. */
  private static void triangle(Sim sim, int base, double half, double left, double floor) {
    for (int row = 0; row < base; row++) {
      for (int i = row; i < base; i++) {
        double x = left + (row + 1) * half + 2 * (i - row) * half;
        sim.dynamic(x, floor + (2 * row + 1) * half).box(half, half, SteppedScene.WOOD);
      }
    }
  }

  /** A pyramid of boxes of 1 m. */
  public static SteppedScene pyramid(Sim sim, int base) {
    SteppedScene.floor(sim, base);
    triangle(sim, base, 0.5, -0.5 * base, 0);
    return new SteppedScene(sim);
  }

  /** 400 pyramids of 55 boxes, in 20 storeys. */
  static SteppedScene manyPyramids(Sim sim) {
    int rows = 20;
    int columns = 20;
    int base = 10;
    double half = 0.5;
    double size = 2 * half * (base + 1);
    double groundHalf = 0.5 * columns * size;
    SimBody ground = sim.ground();
    for (int row = 0; row < rows; row++) {
      double y = row * size;
      ground.box(groundHalf, 0.5 * half, 0, y - 0.5 * half, SteppedScene.WOOD);
      for (int column = 0; column < columns; column++) {
        triangle(sim, base, half, -groundHalf + column * size + half, y);
      }
    }
    return new SteppedScene(sim);
  }

  /** Random convex polygons of 4 to 7 vertices that fall into a box. */
  public static SteppedScene debris(Sim sim, int bodies) {
    int columns = Math.max(DEBRIS_COLUMNS, (int) Math.round(Math.sqrt(bodies)));
    double half = 0.25 * columns;
    SteppedScene.container(sim, half + 1, 2 * half * bodies / columns / 10 + 40);
    Matter matter = Matter.rough(1, 0.5);
    Random random = new Random(1);
    for (int i = 0; i < bodies; i++) {
      double x = 0.5 * (i % columns) - half + 0.25;
      double y = 0.5 + 0.5 * (i / columns);
      sim.dynamic(x, y).polygon(matter, Polygons.random(random, DEBRIS_RADIUS));
    }
    return new SteppedScene(sim);
  }

  /** 2,025 boxes in a turning drum. */
  static SteppedScene tumbler(Sim sim) {
    sim.ground();
    SimBody drum = sim.body(Kind.KINEMATIC, 0, 10, 0);
    Matter steel = Matter.rough(50, 0.6);
    drum.box(0.5, 10, 10, 0, steel).box(0.5, 10, -10, 0, steel);
    drum.box(10, 0.5, 0, 10, steel).box(10, 0.5, 0, -10, steel);
    drum.move(0, 0, Math.toRadians(25));
    int side = 45;
    for (int i = 0; i < side * side; i++) {
      double x = -0.2 * side + 0.4 * (i % side);
      double y = 10 - 0.2 * side + 0.4 * (i / side);
      sim.dynamic(x, y).box(0.125, 0.125, SteppedScene.WOOD);
    }
    return new SteppedScene(sim);
  }

  /** A heavy box hits 9,600 small ones, without gravity. */
  static SteppedScene smash(Sim sim) {
    sim.gravity(0, 0);
    sim.dynamic(-20, 0).box(4, 4, Matter.rough(8, 0.6)).move(40, 0, 0);
    double size = 0.4;
    for (int i = 0; i < 120; i++) {
      for (int j = 0; j < 80; j++) {
        sim.dynamic(30 + (i - 60) * size, (j - 40) * size)
            .box(0.5 * size, 0.5 * size, SteppedScene.WOOD);
      }
    }
    return new SteppedScene(sim);
  }

  /** 5,000 boxes side by side that fall asleep. */
  static SteppedScene sleeping(Sim sim) {
    sim.allowSleep();
    SteppedScene.floor(sim, 2000);
    for (int i = 0; i < 5000; i++) {
      sim.dynamic(0.75 * (i - 2500), 0.25).box(0.25, 0.25, SteppedScene.WOOD);
    }
    return new SteppedScene(sim);
  }
}
