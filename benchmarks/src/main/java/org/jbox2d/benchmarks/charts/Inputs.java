package org.jbox2d.benchmarks.charts;

import java.util.Arrays;
import java.util.Random;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Segments;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/** Seeded inputs, in our form and in that of JTS. */
public final class Inputs {
  static final GeometryFactory JTS = new GeometryFactory();

  private Inputs() {}

  /** Interleaved coordinates of n points, uniform in the unit square. */
  static double[] points(int n, long seed) {
    Random random = new Random(seed);
    double[] xy = new double[2 * n];
    for (int i = 0; i < xy.length; i++) {
      xy[i] = random.nextDouble();
    }
    return xy;
  }

  /** The unit square. */
  static Outline box() {
    return Outline.of(0, 0, 1, 0, 1, 1, 0, 1);
  }

  /** A star that fills the unit square, with n vertices, every other at half the radius. */
  public static Outline star(int n) {
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * StrictMath.PI * i / n;
      double radius = i % 2 == 0 ? 0.5 : 0.25;
      xy[2 * i] = 0.5 + radius * StrictMath.cos(angle);
      xy[2 * i + 1] = 0.5 + radius * StrictMath.sin(angle);
    }
    return Outline.of(xy);
  }

  /**
   * A random simple polygon: a closed tour of random points, uncrossed by reversing the part
   * between two edges that touch until none do. Each reversal shortens the tour, so this ends.
   */
  public static Outline polygon(int n, long seed) {
    double[] xy = points(n, seed);
    boolean crossed = true;
    while (crossed) {
      crossed = false;
      for (int i = 0; i < n - 2; i++) {
        for (int j = i + 2; j < n; j++) {
          int end = (j + 1) % n;
          if (end != i && Segments.touch(xy, i, i + 1, j, end)) {
            reverse(xy, i + 1, j);
            crossed = true;
          }
        }
      }
    }
    return Outline.of(xy).normal();
  }

  private static void reverse(double[] xy, int from, int to) {
    for (int a = from, b = to; a < b; a++, b--) {
      for (int k = 0; k < 2; k++) {
        double swap = xy[2 * a + k];
        xy[2 * a + k] = xy[2 * b + k];
        xy[2 * b + k] = swap;
      }
    }
  }

  /** Points as JTS has them. */
  static Coordinate[] coordinates(double[] xy) {
    Coordinate[] result = new Coordinate[xy.length / 2];
    for (int i = 0; i < result.length; i++) {
      result[i] = new Coordinate(xy[2 * i], xy[2 * i + 1]);
    }
    return result;
  }

  /** An outline of one ring as JTS has it. */
  static Polygon polygon(Outline outline) {
    Coordinate[] open = coordinates(outline.coordinates());
    Coordinate[] ring = Arrays.copyOf(open, open.length + 1);
    ring[open.length] = new Coordinate(open[0]);
    return JTS.createPolygon(ring);
  }
}
