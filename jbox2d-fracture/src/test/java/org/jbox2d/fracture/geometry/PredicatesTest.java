package org.jbox2d.fracture.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * The predicates against arithmetic of arbitrary precision, on points that are nearly or exactly
 * degenerate.
 */
class PredicatesTest {
  private static final int CASES = 20_000;

  private static BigDecimal difference(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }

  private static BigDecimal cross(BigDecimal ax, BigDecimal ay, BigDecimal bx, BigDecimal by) {
    return ax.multiply(by).subtract(ay.multiply(bx));
  }

  private static double coordinate(Random random, int kind) {
    return switch (kind) {
      case 0 -> random.nextInt(5);
      case 1 -> (float) (1e6 + random.nextInt(3) * 0.125);
      case 2 -> 0.5 + random.nextInt(8) * 0x1p-53;
      case 3 -> random.nextInt(3) * 1e-30;
      case 4 -> random.nextInt(4) + random.nextInt(4) * 0x1p-60;
      default -> random.nextFloat() * (random.nextBoolean() ? 1 : 1e-6f);
    };
  }

  @Test
  void orientationIsExact() {
    Random random = new Random(1);
    int zero = 0;
    for (int i = 0; i < CASES; i++) {
      double[] p = new double[6];
      for (int k = 0; k < 6; k++) {
        p[k] = coordinate(random, i % 7 == 6 ? random.nextInt(6) : i % 7);
      }
      int expected =
          cross(
                  difference(p[0], p[4]),
                  difference(p[1], p[5]),
                  difference(p[2], p[4]),
                  difference(p[3], p[5]))
              .signum();
      assertEquals(expected, Predicates.orientation(p, 0, 1, 2));
      zero += expected == 0 ? 1 : 0;
    }
    assertTrue(zero > CASES / 20 && zero < CASES / 2, "degenerate cases: " + zero);
  }

  @Test
  void inCircleIsExact() {
    Random random = new Random(2);
    InCircle inCircle = new InCircle();
    int zero = 0;
    for (int i = 0; i < CASES; i++) {
      double[] p = new double[8];
      for (int k = 0; k < 8; k++) {
        p[k] = coordinate(random, i % 7 == 6 ? random.nextInt(6) : i % 7);
      }
      BigDecimal expected = BigDecimal.ZERO;
      for (int a = 0; a < 3; a++) {
        int b = (a + 1) % 3;
        int c = (a + 2) % 3;
        BigDecimal ax = difference(p[2 * a], p[6]);
        BigDecimal ay = difference(p[2 * a + 1], p[7]);
        BigDecimal minor =
            cross(
                difference(p[2 * b], p[6]),
                difference(p[2 * b + 1], p[7]),
                difference(p[2 * c], p[6]),
                difference(p[2 * c + 1], p[7]));
        expected = expected.add(ax.multiply(ax).add(ay.multiply(ay)).multiply(minor));
      }
      assertEquals(
          expected.signum(), inCircle.sign(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]));
      zero += expected.signum() == 0 ? 1 : 0;
    }
    assertTrue(zero > CASES / 20 && zero < CASES / 2, "degenerate cases: " + zero);
  }

  @Test
  void locateKnowsInsideBoundaryAndOutside() {
    double[] ring = {0, 0, 4, 0, 4, 4, 2, 2, 0, 4};
    assertEquals(1, Rings.locate(ring, 0, 5, 1, 2));
    assertEquals(-1, Rings.locate(ring, 0, 5, 2, 3));
    assertEquals(0, Rings.locate(ring, 0, 5, 2, 2));
    assertEquals(0, Rings.locate(ring, 0, 5, 3, 0));
    assertEquals(0, Rings.locate(ring, 0, 5, 3, 3));
    assertEquals(-1, Rings.locate(ring, 0, 5, -1, 0));
    assertEquals(-1, Rings.locate(ring, 0, 5, -1, 4));
    assertEquals(1, Rings.locate(ring, 0, 5, 1, 0.5));
  }
}
