package org.jbox2d.fracture.fragmentation;

import java.util.Random;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.OutlineDefect;
import org.jbox2d.fracture.geometry.Rings;
import org.jbox2d.fracture.geometry.Segments;

/**
 * Kinds of outlines: each makes a simple polygon of about n vertices in the square from -1 to 1,
 * with holes if asked for.
 */
public enum OutlineKind {
  BOX,
  CONVEX,
  STAR,
  COMB,
  SPIRAL,
  RANDOM,
  COLLINEAR_VERTICES,
  SLIVER;

  /** An outline with coordinates that are floats, in random orientation. */
  public Outline make(Random random, int n, int holes) {
    for (int attempt = 0; ; attempt++) {
      if (attempt == 1000) {
        throw new IllegalStateException(this + " of " + n + " vertices is never simple");
      }
      double[] outer = ring(random, Math.max(3, n));
      for (int i = 0; i < outer.length; i++) {
        outer[i] = (float) outer[i];
      }
      if (random.nextBoolean()) {
        Rings.reverse(outer, 0, outer.length / 2);
      }
      Outline outline = Outline.of(outer);
      if (OutlineCheck.of(outline).defect() == OutlineDefect.NONE) {
        return addHoles(random, outline, holes);
      }
    }
  }

  private static Outline addHoles(Random random, Outline outline, int holes) {
    Outline result = outline;
    int made = 0;
    for (int attempt = 0; attempt < 20 * holes && made < holes; attempt++) {
      double[][] rings = new double[result.ringCount() + 1][];
      for (int r = 0; r < result.ringCount(); r++) {
        rings[r] =
            java.util.Arrays.copyOfRange(
                result.coordinates(), 2 * result.ringStart(r), 2 * result.ringEnd(r));
      }
      double size = 0.02 + 0.3 * random.nextDouble() * random.nextDouble();
      double cx = 2 * random.nextDouble() - 1;
      double cy = 2 * random.nextDouble() - 1;
      int n = 3 + random.nextInt(6);
      double[] hole = new double[2 * n];
      for (int i = 0; i < n; i++) {
        double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / n;
        hole[2 * i] = (float) (cx + size * Math.cos(angle));
        hole[2 * i + 1] = (float) (cy + size * Math.sin(angle));
      }
      rings[result.ringCount()] = hole;
      Outline candidate = Outline.ofRings(rings);
      if (OutlineCheck.of(candidate).defect() == OutlineDefect.NONE) {
        result = candidate;
        made++;
      }
    }
    return result;
  }

  private double[] ring(Random random, int n) {
    double[] xy = new double[2 * n];
    switch (this) {
      case BOX:
        return new double[] {-1, -1, 1, -1, 1, 1, -1, 1};
      case SLIVER:
        return sliver(random, n);
      case COMB:
        return comb(n);
      case SPIRAL:
        return spiral(n);
      case RANDOM:
        return twoOpt(random, Math.min(n, 512));
      case COLLINEAR_VERTICES:
        return collinear(n);
      default:
        for (int i = 0; i < n; i++) {
          double angle = 2 * Math.PI * (i + 0.5 * random.nextDouble()) / n;
          double radius = this == STAR ? (i % 2 == 0 ? 1 : 0.2 + 0.5 * random.nextDouble()) : 1;
          xy[2 * i] = radius * Math.cos(angle);
          xy[2 * i + 1] = radius * Math.sin(angle);
        }
        return xy;
    }
  }

  private static double[] sliver(Random random, int n) {
    int half = Math.max(2, n / 2);
    double slope = random.nextInt(3) * 0.5;
    double[] xy = new double[4 * half];
    for (int i = 0; i < half; i++) {
      double x = -1 + 2.0 * i / (half - 1);
      xy[2 * i] = x;
      xy[2 * i + 1] = slope * x;
      int j = 2 * half - 1 - i;
      xy[2 * j] = x;
      xy[2 * j + 1] = slope * x + 0.002;
    }
    return xy;
  }

  private static double[] comb(int n) {
    int teeth = Math.max(2, n / 4);
    double[] ring = new double[4 + 8 * (teeth - 1) + 4];
    int m = 0;
    ring[m++] = -1;
    ring[m++] = -1;
    ring[m++] = 1;
    ring[m++] = -1;
    for (int i = teeth - 1; i >= 1; i--) {
      double left = -1 + 2.0 * i / teeth;
      double right = -1 + 2.0 * (i + 0.5) / teeth;
      double[] tooth = {right, -0.8, right, 1, left, 1, left, -0.8};
      System.arraycopy(tooth, 0, ring, m, 8);
      m += 8;
    }
    ring[m++] = -1;
    ring[m++] = -0.8;
    ring[m++] = -1;
    ring[m++] = -0.9;
    return ring;
  }

  private static double[] spiral(int n) {
    int half = Math.max(3, n / 2);
    double turns = Math.min(3, half / 6.0);
    double[] xy = new double[4 * half];
    for (int i = 0; i < half; i++) {
      double angle = 2 * Math.PI * turns * i / (half - 1);
      double radius = 1 - 0.8 * i / (half - 1);
      double width = 0.2 / (turns + 1);
      xy[2 * i] = radius * Math.cos(angle);
      xy[2 * i + 1] = radius * Math.sin(angle);
      int j = 2 * half - 1 - i;
      xy[2 * j] = (radius - width) * Math.cos(angle);
      xy[2 * j + 1] = (radius - width) * Math.sin(angle);
    }
    return xy;
  }

  private static double[] collinear(int n) {
    int side = Math.max(1, n / 4);
    double[] xy = new double[8 * side];
    double[] corner = {-1, -1, 1, -1, 1, 1, -1, 1, -1, -1};
    int k = 0;
    for (int c = 0; c < 4; c++) {
      for (int i = 0; i < side; i++) {
        double t = (double) i / side;
        xy[k++] = corner[2 * c] + t * (corner[2 * c + 2] - corner[2 * c]);
        xy[k++] = corner[2 * c + 1] + t * (corner[2 * c + 3] - corner[2 * c + 1]);
      }
    }
    return xy;
  }

  /**
   * Random points, joined in random order; crossing edges are untangled by reversing what lies
   * between them.
   */
  private static double[] twoOpt(Random random, int n) {
    double[] xy = new double[2 * n];
    for (int i = 0; i < 2 * n; i++) {
      xy[i] = (float) (2 * random.nextDouble() - 1);
    }
    boolean changed = true;
    for (int sweep = 0; sweep < 200 && changed; sweep++) {
      changed = false;
      for (int i = 0; i < n - 2; i++) {
        for (int j = i + 2; j < n; j++) {
          int after = (j + 1) % n;
          if (after != i
              && Segments.touch(xy, i, i + 1, j, after)
              && distance(xy, i, i + 1) + distance(xy, j, after)
                  > distance(xy, i, j) + distance(xy, i + 1, after) + 1e-12) {
            Rings.reverse(xy, i + 1, j + 1);
            changed = true;
          }
        }
      }
    }
    return xy;
  }

  private static double distance(double[] xy, int i, int j) {
    return Math.hypot(xy[2 * i] - xy[2 * j], xy[2 * i + 1] - xy[2 * j + 1]);
  }
}
