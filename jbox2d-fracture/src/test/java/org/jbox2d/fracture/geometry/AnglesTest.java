package org.jbox2d.fracture.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class AnglesTest {
  private static final int CASES = 200_000;

  /** Two units in the last place of 1. */
  private static final double TWO_ULPS = 2 * 0x1p-52;

  @Test
  void sineAndCosineAreThoseOfStrictMath() {
    Random random = new Random(1);
    for (int i = 0; i < CASES; i++) {
      double x = (random.nextDouble() - 0.5) * (i % 3 == 0 ? 2e6 : 4 * Math.PI);
      assertEquals(StrictMath.sin(x), Angles.sin(x), TWO_ULPS);
      assertEquals(StrictMath.cos(x), Angles.cos(x), TWO_ULPS);
    }
  }

  @Test
  void directionsAreCosineAndSine() {
    Random random = new Random(4);
    double[] direction = new double[2];
    for (int i = 0; i < CASES; i++) {
      double x = i < 34 ? (i - 17) * Math.PI / 4 : (random.nextDouble() - 0.5) * 2e6;
      Angles.direction(x, direction);
      assertEquals(Angles.cos(x), direction[0]);
      assertEquals(Angles.sin(x), direction[1]);
    }
    Angles.direction(1e9, direction);
    assertEquals(StrictMath.cos(1e9), direction[0]);
    assertEquals(StrictMath.sin(1e9), direction[1]);
  }

  @Test
  void sineAndCosineOfQuadrants() {
    for (int k = -8; k <= 8; k++) {
      assertEquals(StrictMath.sin(k * Math.PI / 4), Angles.sin(k * Math.PI / 4), TWO_ULPS);
      assertEquals(StrictMath.cos(k * Math.PI / 4), Angles.cos(k * Math.PI / 4), TWO_ULPS);
    }
    assertEquals(StrictMath.sin(1e9), Angles.sin(1e9));
    assertEquals(StrictMath.cos(-1e9), Angles.cos(-1e9));
    assertEquals(Double.NaN, Angles.sin(Double.POSITIVE_INFINITY));
  }

  @Test
  void anglesAreThoseOfStrictMath() {
    Random random = new Random(2);
    for (int i = 0; i < CASES; i++) {
      double x = (random.nextDouble() - 0.5) * (i % 3 == 0 ? 1e-6 : 1);
      double y = (random.nextDouble() - 0.5) * (i % 3 == 1 ? 1e-6 : 1);
      assertEquals(StrictMath.atan2(y, x), Angles.atan2(y, x), Math.PI * TWO_ULPS);
    }
    double[] axis = {-2, 0, 2};
    for (double x : axis) {
      for (double y : axis) {
        if (x != 0 || y != 0) {
          assertEquals(StrictMath.atan2(y, x), Angles.atan2(y, x), TWO_ULPS, x + " " + y);
        }
      }
    }
  }

  @Test
  void logarithmsAreThoseOfStrictMath() {
    Random random = new Random(3);
    for (int i = 0; i < CASES; i++) {
      double x = random.nextDouble() * Math.scalb(1.0, random.nextInt(41) - 20) + 1e-30;
      double expected = StrictMath.log(x);
      assertEquals(expected, Angles.log(x), Math.max(Math.abs(expected), 0.01) * TWO_ULPS);
    }
    assertEquals(0.0, Angles.log(1));
    assertEquals(StrictMath.log(0x1p-24), Angles.log(0x1p-24), 20 * TWO_ULPS);
  }
}
