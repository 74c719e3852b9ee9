package org.jbox2d.benchmarks.accuracy;

/** Solutions in double precision that scenes are compared with. */
final class Truth {
  /** Steps of the reference integration of a second: its error is below 1e-12 here. */
  private static final int STEPS = 4096;

  private static final int BISECTIONS = 200;

  private Truth() {}

  /** Derivative of a state. */
  @FunctionalInterface
  interface Slope {
    /** Writes the derivative of a state. */
    void of(double[] state, double[] derivative);
  }

  /** Integrates by the classical Runge-Kutta method of fourth order, from 0 to a time. */
  static double[] integrate(double[] start, double time, Slope slope) {
    double[] y = start.clone();
    int n = (int) Math.ceil(time * STEPS);
    double h = time / n;
    double[] k = new double[y.length];
    double[] at = new double[y.length];
    double[] sum = new double[y.length];
    double[] stage = {0, 0.5, 0.5, 1};
    double[] weight = {1, 2, 2, 1};
    for (int i = 0; i < n; i++) {
      java.util.Arrays.fill(sum, 0);
      for (int s = 0; s < 4; s++) {
        for (int j = 0; j < y.length; j++) {
          at[j] = y[j] + stage[s] * h * k[j];
        }
        slope.of(at, k);
        for (int j = 0; j < y.length; j++) {
          sum[j] += weight[s] * k[j];
        }
      }
      for (int j = 0; j < y.length; j++) {
        y[j] += h / 6 * sum[j];
      }
    }
    return y;
  }

  /**
   * Period of a pendulum of any amplitude: 4 K(sin(a/2)) / w0, with the complete elliptic integral
   * by the arithmetic-geometric mean: K(k) = pi / (2 agm(1, sqrt(1 - k^2))).
   *
   * @param w0 angular frequency of small swings, rad/s
   * @param amplitude greatest angle, rad
   */
  static double period(double w0, double amplitude) {
    double a = 1;
    double b = StrictMath.cos(amplitude / 2);
    while (Math.abs(a - b) > 1e-15) {
      double mean = (a + b) / 2;
      b = Math.sqrt(a * b);
      a = mean;
    }
    return 2 * Math.PI / (w0 * a);
  }

  /** Angles of the links of a hanging chain of equal uniform links; see {@link #loadedChain}. */
  static double[] hangingChain(int links, double span) {
    return loadedChain(links, span, 0);
  }

  /**
   * Angles of the links of a hanging chain of equal uniform links between two places of one height,
   * with a load at the hinge in its middle. With the horizontal pull H over a link's weight, n
   * links and a load of P links' weight, the moments about the middle of link i of the left half
   * balance at tan(angle) = -(n/2 - i - 1/2 + P/2) / H; H is where the chain spans the distance.
   *
   * @param links number of links of length 1, even if there is a load
   * @param span distance of the ends
   * @param load weight of the load over that of a link
   */
  static double[] loadedChain(int links, double span, double load) {
    double low = 0;
    double high = 1e9;
    double[] angles = new double[links];
    for (int k = 0; k < BISECTIONS; k++) {
      double pull = 0.5 * (low + high);
      double width = 0;
      for (int i = 0; i < links; i++) {
        double below = 0.5 * links - i - 0.5;
        double weight = below + 0.5 * load * Math.signum(below);
        angles[i] = -StrictMath.atan2(weight, pull);
        width += StrictMath.cos(angles[i]);
      }
      if (width < span) {
        low = pull;
      } else {
        high = pull;
      }
    }
    return angles;
  }

  /** The difference of angles, within half a turn. */
  static double turn(double difference) {
    return StrictMath.IEEEremainder(difference, 2 * Math.PI);
  }
}
