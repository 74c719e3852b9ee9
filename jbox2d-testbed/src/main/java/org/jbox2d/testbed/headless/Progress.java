package org.jbox2d.testbed.headless;

import java.io.PrintWriter;
import java.util.Locale;

/** Says every few seconds how far a long run is. */
final class Progress {
  private static final double NANOS_PER_SECOND = 1e9;

  /** How often, s. Runs that take less say nothing. */
  private static final double INTERVAL = 2;

  private final PrintWriter err;
  private final int steps;
  private final long start = System.nanoTime();
  private double told;

  /**
   * Progress of a run.
   *
   * @param steps how many there will be; negative if that is not known
   */
  Progress(PrintWriter err, int steps) {
    this.err = err;
    this.steps = steps;
  }

  /** Takes note of a step. */
  void step(int done) {
    double seconds = (System.nanoTime() - start) / NANOS_PER_SECOND;
    if (seconds - told < INTERVAL) {
      return;
    }
    told = seconds;
    err.println(line(done, steps, seconds));
    err.flush();
  }

  static String line(int done, int steps, double seconds) {
    String rate = String.format(Locale.ROOT, "%.0f steps/s", done / seconds);
    if (steps < 0) {
      return "step " + done + ", " + rate;
    }
    return String.format(
        Locale.ROOT,
        "step %d of %d (%.0f %%), %s, %.0f s to go",
        done,
        steps,
        100.0 * done / steps,
        rate,
        seconds / done * (steps - done));
  }
}
