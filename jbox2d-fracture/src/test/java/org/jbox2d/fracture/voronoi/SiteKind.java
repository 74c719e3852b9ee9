package org.jbox2d.fracture.voronoi;

import java.util.Random;

/** Kinds of input for diagrams: each makes n sites in and around the square from -1 to 1. */
public enum SiteKind {
  UNIFORM,
  LOG_POLAR,
  RINGS,
  GRID,
  COLLINEAR,
  COLLINEAR_SLANTED,
  DUPLICATED,
  NEAR_PAIRS,
  ALL_OUTSIDE,
  COCIRCULAR,
  NEARLY_COLLINEAR,
  TINY_CLUSTER,
  ALIGNED_GRID,
  TURNED_GRID;

  /** Interleaved coordinates of n sites; every coordinate is a float. */
  public double[] make(Random random, int n) {
    double[] xy = new double[2 * n];
    int side = Math.max(1, (int) Math.round(Math.sqrt(n)));
    int aligned = 4 * Math.max(1, Math.round(side / 4f));
    double turn = 0;
    for (int i = 0; i < n; i++) {
      double x = 2 * random.nextDouble() - 1;
      double y = 2 * random.nextDouble() - 1;
      double angle = 2 * Math.PI * random.nextDouble();
      turn = i == 0 ? angle : turn;
      switch (this) {
        case LOG_POLAR -> {
          double radius = -Math.log(1 - random.nextDouble()) * 0.3;
          x = radius * Math.cos(angle);
          y = radius * Math.sin(angle) * 4;
        }
        case RINGS -> {
          double radius = (1 + i % 4) * 0.25 + random.nextDouble() * 0.01;
          x = radius * Math.cos(angle);
          y = radius * Math.sin(angle);
        }
        case GRID -> {
          x = -1 + (2.0 * (i % side) + 1) / side;
          y = -1 + (2.0 * (i / side) + 1) / side;
        }
        case COLLINEAR -> y = 0.25;
        case COLLINEAR_SLANTED -> {
          x = Math.round(x * 64) / 64.0;
          y = x / 2;
        }
        case DUPLICATED -> {
          x = Math.round(x * 3) / 3.0;
          y = Math.round(y * 3) / 3.0;
        }
        case NEAR_PAIRS -> {
          if (i % 2 == 1) {
            x = xy[2 * i - 2] + 1e-6 * Math.cos(angle);
            y = xy[2 * i - 1] + 1e-6 * Math.sin(angle);
          }
        }
        case ALL_OUTSIDE -> {
          x = 3 + x;
          y = 5 * y;
        }
        case COCIRCULAR -> {
          int[][] triples = {{3, 4}, {4, 3}, {5, 0}, {0, 5}};
          int[] t = triples[random.nextInt(4)];
          x = (random.nextBoolean() ? t[0] : -t[0]) / 8.0;
          y = (random.nextBoolean() ? t[1] : -t[1]) / 8.0;
        }
        case NEARLY_COLLINEAR -> y = x / 3 + 1e-7 * y;
        case TINY_CLUSTER -> {
          x = 0.1 + x * 1e-5;
          y = 0.2 + y * 1e-5;
        }
        case ALIGNED_GRID -> {
          // Reaches from -2 to 2, with edges of cells along the sides of the square.
          x = -2 + (4.0 * (i % aligned) + 2) / aligned;
          y = -2 + (4.0 * (i / aligned % aligned) + 2) / aligned;
        }
        case TURNED_GRID -> {
          double u = -1 + (2.0 * (i % side) + 1) / side;
          double v = -1 + (2.0 * (i / side) + 1) / side;
          x = u * Math.cos(turn) - v * Math.sin(turn);
          y = u * Math.sin(turn) + v * Math.cos(turn);
        }
        default -> {}
      }
      xy[2 * i] = (float) x;
      xy[2 * i + 1] = (float) y;
    }
    return xy;
  }
}
