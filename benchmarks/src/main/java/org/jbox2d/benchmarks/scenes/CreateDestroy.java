package org.jbox2d.benchmarks.scenes;

import java.util.ArrayDeque;
import java.util.Random;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/**
 * Births and deaths as a fracture makes them. Each frame one of 100 boxes on the ground is taken
 * out and 60 small polygons come in its place; those of 30 frames ago leave, and their box comes
 * back above the ground. So 1,800 pieces and 70 boxes are there at any time.
 */
final class CreateDestroy extends SteppedScene {
  private static final int BOXES = 100;
  private static final int LIFE = 30;
  private static final int COLUMNS = 6;
  private static final int ROWS = 10;
  private static final double SPACING = 1.5;
  private static final double HALF_WIDTH = 0.5;
  private static final double HALF_HEIGHT = 0.75;
  private static final double PIECE_RADIUS = 0.07;
  private static final Matter RUBBLE = Matter.rough(1, 0.5);

  private final double[][] pieces = new double[COLUMNS * ROWS][];
  private final SimBody[] boxes = new SimBody[BOXES];
  private final ArrayDeque<SimBody[]> broken = new ArrayDeque<>();
  private int frame;

  CreateDestroy(Sim sim) {
    super(sim);
    floor(sim, 0.5 * SPACING * BOXES + 10);
    for (int i = 0; i < BOXES; i++) {
      placeBox(i);
    }
    Random random = new Random(2);
    for (int i = 0; i < pieces.length; i++) {
      pieces[i] = Polygons.random(random, PIECE_RADIUS);
    }
  }

  private void placeBox(int i) {
    double x = SPACING * (i - 0.5 * BOXES);
    boxes[i] = sim.dynamic(x, HALF_HEIGHT).box(HALF_WIDTH, HALF_HEIGHT, WOOD);
  }

  @Override
  public void step() {
    if (broken.size() == LIFE) {
      for (SimBody piece : broken.poll()) {
        sim.remove(piece);
      }
      placeBox(Math.floorMod(frame - LIFE, BOXES));
    }
    breakBox(frame % BOXES);
    frame++;
    super.step();
  }

  private void breakBox(int i) {
    double left = boxes[i].x() - HALF_WIDTH;
    double foot = boxes[i].y() - HALF_HEIGHT;
    sim.remove(boxes[i]);
    SimBody[] parts = new SimBody[pieces.length];
    double cellX = 2 * HALF_WIDTH / COLUMNS;
    double cellY = 2 * HALF_HEIGHT / ROWS;
    for (int k = 0; k < parts.length; k++) {
      double x = left + cellX * (k % COLUMNS + 0.5);
      double y = foot + cellY * (k / COLUMNS + 0.5);
      parts[k] = sim.dynamic(x, y).polygon(RUBBLE, pieces[k]);
    }
    broken.add(parts);
  }
}
