package org.jbox2d.benchmarks.scenes;

import java.util.Random;

/** Random convex polygons. */
final class Polygons {
  /** Part of its sector within which a vertex is placed; less than 1 keeps vertices apart. */
  private static final double SPREAD = 0.8;

  private Polygons() {}

  /** A convex polygon of 4 to 7 vertices on a circle, counter-clockwise: x, y, x, y... */
  static double[] random(Random random, double radius) {
    int n = 4 + random.nextInt(4);
    double[] vertices = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + SPREAD * random.nextDouble()) / n;
      vertices[2 * i] = radius * StrictMath.cos(angle);
      vertices[2 * i + 1] = radius * StrictMath.sin(angle);
    }
    return vertices;
  }
}
