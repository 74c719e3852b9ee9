package org.jbox2d.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TruthTest {
  /** K(sin 45 degrees) = Gamma(1/4)^2 / (4 sqrt(pi)). */
  @Test
  void periodAtARightAngle() {
    assertEquals(4 * 1.854_074_677_301_372, Truth.period(1, Math.PI / 2), 1e-12);
    assertEquals(2 * Math.PI, Truth.period(1, 0), 1e-12);
  }

  @Test
  void integratesAnOscillation() {
    double[] end =
        Truth.integrate(
            new double[] {1, 0},
            3,
            (y, d) -> {
              d[0] = y[1];
              d[1] = -y[0];
            });
    assertEquals(StrictMath.cos(3), end[0], 1e-12);
    assertEquals(-StrictMath.sin(3), end[1], 1e-12);
  }

  @Test
  void hangingChainSpansAndIsInBalance() {
    double[] angles = Truth.hangingChain(20, 12);
    double width = 0;
    double drop = 0;
    for (double angle : angles) {
      width += StrictMath.cos(angle);
      drop += StrictMath.sin(angle);
    }
    assertEquals(12, width, 1e-9);
    assertEquals(0, drop, 1e-9);
    // The tangents of neighbours differ by the same amount: equal weights, one horizontal pull.
    double step = StrictMath.tan(angles[1]) - StrictMath.tan(angles[0]);
    assertEquals(step, StrictMath.tan(angles[11]) - StrictMath.tan(angles[10]), 1e-9);
  }

  @Test
  void turnsAreWithinHalfATurn() {
    assertEquals(0.5, Truth.turn(0.5 + 6 * Math.PI), 1e-12);
    assertEquals(-0.5, Truth.turn(-0.5 - 4 * Math.PI), 1e-12);
  }

  /** The load is borne by half on each side: the slopes beside it differ by load over pull. */
  @Test
  void aLoadBendsTheChainInItsMiddle() {
    double[] free = Truth.loadedChain(20, 19, 0);
    double[] loaded = Truth.loadedChain(20, 19, 20);
    double pull = 1 / (StrictMath.tan(loaded[1]) - StrictMath.tan(loaded[0]));
    assertEquals(21 / pull, StrictMath.tan(loaded[10]) - StrictMath.tan(loaded[9]), 1e-9);
    assertEquals(Truth.hangingChain(20, 19)[3], free[3]);
  }
}
