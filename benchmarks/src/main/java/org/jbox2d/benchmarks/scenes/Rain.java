package org.jbox2d.benchmarks.scenes;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/**
 * Dolls of eleven boxes and ten limited hinges fall on steps. Every eighth frame a column of them
 * is put in; when there are 40 columns of 25 dolls, 11,000 bodies, the oldest is taken out for it.
 */
final class Rain extends SteppedScene {
  private static final int COLUMNS = 40;
  private static final int ROWS = 5;
  private static final int GROUP = 5;
  private static final int PAUSE = 8;
  private static final double WIDTH = 3;
  private static final double SCALE = 0.3;
  private static final Matter FLESH = Matter.rough(1, 0.3).ghostly();

  /** Half width, half height, x, y of each part, and the part that it hangs on. */
  private static final double[][] PARTS = {
    {0.30, 0.25, 0.00, 2.00, -1},
    {0.28, 0.25, 0.00, 2.50, 0},
    {0.20, 0.20, 0.00, 2.95, 1},
    {0.12, 0.45, -0.15, 1.30, 0},
    {0.10, 0.45, -0.15, 0.40, 3},
    {0.12, 0.45, 0.15, 1.30, 0},
    {0.10, 0.45, 0.15, 0.40, 5},
    {0.25, 0.09, -0.53, 2.60, 1},
    {0.25, 0.08, -1.03, 2.60, 7},
    {0.25, 0.09, 0.53, 2.60, 1},
    {0.25, 0.08, 1.03, 2.60, 9}
  };

  private final List<List<SimBody>> columns = new ArrayList<>();
  private int frame;

  Rain(Sim sim) {
    super(sim);
    SimBody ground = sim.ground();
    for (int row = 0; row < ROWS; row++) {
      for (int i = 0; i < COLUMNS; i++) {
        double x = (i - 0.5 * COLUMNS) * WIDTH + (row % 2) * 0.5 * WIDTH;
        ground.box(0.45, 0.45, x, 12 * row, WOOD);
      }
    }
    floorUnder(ground);
  }

  private static void floorUnder(SimBody ground) {
    ground.box(COLUMNS * WIDTH, 1, 0, -8, WOOD);
  }

  @Override
  public void step() {
    if (frame % PAUSE == 0) {
      int column = frame / PAUSE % COLUMNS;
      if (columns.size() == COLUMNS) {
        for (SimBody body : columns.get(column)) {
          sim.remove(body);
        }
        columns.set(column, dolls(column));
      } else {
        columns.add(dolls(column));
      }
    }
    frame++;
    super.step();
  }

  private List<SimBody> dolls(int column) {
    List<SimBody> bodies = new ArrayList<>();
    double x = (column - 0.5 * COLUMNS) * WIDTH + 0.5;
    for (int row = 0; row < ROWS; row++) {
      for (int i = 0; i < GROUP; i++) {
        doll(x + 0.15 * i, 12 * row + 1 + 1.1 * i, bodies);
      }
    }
    return bodies;
  }

  private void doll(double x, double y, List<SimBody> bodies) {
    SimBody[] parts = new SimBody[PARTS.length];
    for (int k = 0; k < parts.length; k++) {
      double[] p = PARTS[k];
      parts[k] =
          sim.dynamic(x + SCALE * p[2], y + SCALE * p[3]).box(SCALE * p[0], SCALE * p[1], FLESH);
      int parent = (int) p[4];
      if (parent >= 0) {
        double[] q = PARTS[parent];
        boolean arm = k >= 7;
        double jx = arm ? p[2] - Math.signum(p[2]) * p[0] : p[2];
        double jy = arm ? p[3] : p[3] + (p[3] > q[3] ? -p[1] : p[1]);
        sim.limited(parts[parent], parts[k], x + SCALE * jx, y + SCALE * jy, -0.6, 0.6);
      }
      bodies.add(parts[k]);
    }
  }
}
