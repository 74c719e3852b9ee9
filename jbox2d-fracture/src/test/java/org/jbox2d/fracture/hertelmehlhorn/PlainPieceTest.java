package org.jbox2d.fracture.hertelmehlhorn;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.fracture.geometry.Outline;
import org.junit.jupiter.api.Test;

/** What the shortcut takes must come out as it does the long way. */
class PlainPieceTest {
  private static final int MOST_VERTICES = 8;
  private static final double RESOLUTION = 0.0025;

  /** On an ellipse, from round to a sliver, some vertices near others, some hardly sticking out. */
  private static double[] ring(Random random) {
    int n = 3 + random.nextInt(7);
    double flat = random.nextInt(3) == 0 ? 1e-3 * random.nextDouble() : random.nextDouble();
    double size = Math.pow(10, -2 + 3 * random.nextDouble());
    double x = random.nextInt(2) * 100 * random.nextGaussian();
    double y = random.nextInt(2) * 100 * random.nextGaussian();
    double[] angles = random.doubles(n, 0, 2 * Math.PI).sorted().toArray();
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double radius = size * (random.nextInt(8) == 0 ? 0.6 + 0.5 * random.nextDouble() : 1);
      xy[2 * i] = x + radius * Math.cos(angles[i]);
      xy[2 * i + 1] = y + radius * flat * Math.sin(angles[i]);
    }
    return xy;
  }

  @Test
  void isWhatTheLongWayGives() {
    Random random = new Random(21);
    PlainPiece plain = new PlainPiece();
    OutlineSimplifier simplifier = new OutlineSimplifier();
    int taken = 0;
    for (int c = 0; c < 20_000; c++) {
      Outline outline = Outline.of(ring(random));
      ConvexParts part = plain.of(outline, MOST_VERTICES, RESOLUTION);
      if (part == null) {
        continue;
      }
      taken++;
      int n = outline.vertexCount();
      Outline coarse = simplifier.simplify(outline, RESOLUTION);
      assertTrue(simplifier.isConvex(), "case " + c);
      assertEquals(n, coarse.vertexCount(), "case " + c);
      double[] xy = new double[2 * n];
      System.arraycopy(coarse.coordinates(), 0, xy, 2, 2 * n - 2);
      System.arraycopy(coarse.coordinates(), 2 * n - 2, xy, 0, 2);
      ConvexParts whole = new ConvexParts(xy, new int[] {0, n});
      ConvexParts expected = new PartFilter().filter(whole, RESOLUTION, outline.area());
      assertEquals(1, expected.count(), "case " + c);
      assertArrayEquals(expected.coordinates(0), part.coordinates(0), "case " + c);
    }
    assertTrue(taken > 5000, "taken: " + taken);
  }

  @Test
  void whatIsNotPlainIsLeft() {
    PlainPiece plain = new PlainPiece();
    double[][] rings = {
      {0, 0, 1, 0, 0.2, 0.2, 0, 1},
      {0, 0, 0, 1, 1, 1, 1, 0},
      {0, 0, 1, 0, 1, 0.001, 0, 1},
      {0, 0, 0.5, 0, 1, 0, 0, 1},
      {0, 1, 1, -0.8, -1, 0.3, 1, 0.3, -1, -0.8},
      {0, 1, -1, -0.8, 1, 0.3, -1, 0.3, 1, -0.8},
      {0, 0, 1, 0, Double.NaN, 1},
      {0, 0, 1e300, 0, 0, 1e300},
    };
    for (double[] ring : rings) {
      assertNull(plain.of(Outline.of(ring), MOST_VERTICES, RESOLUTION));
    }
    Outline square = Outline.of(0, 0, 1, 0, 1, 1, 0, 1);
    assertEquals(1, plain.of(square, MOST_VERTICES, RESOLUTION).count());
    assertNull(plain.of(square, 3, RESOLUTION));
  }
}
