package org.jbox2d.benchmarks.accuracy;

import java.util.List;
import java.util.Locale;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;

/**
 * A solver at a setting over all scenes.
 *
 * @param solver the solver
 * @param setting its setting
 * @param scenes number of scenes
 * @param failed number of scenes with an error above the limit
 * @param error geometric mean of the errors, each of {@link Scene#FLOOR} at least
 * @param cost geometric mean of the costs, ms of thread time a simulated second
 */
record Summary(
    Contender solver, Setting setting, int scenes, int failed, double error, double cost) {
  /** Sums up results of one solver and setting. */
  static Summary of(List<Result> results) {
    double error = 0;
    double cost = 0;
    int failed = 0;
    for (Result r : results) {
      error += StrictMath.log(Math.max(Scene.FLOOR, r.error()));
      cost += StrictMath.log(r.cost());
      failed += r.failed() ? 1 : 0;
    }
    int n = results.size();
    Result any = results.get(0);
    return new Summary(
        any.solver(),
        any.setting(),
        n,
        failed,
        StrictMath.exp(error / n),
        StrictMath.exp(cost / n));
  }

  /** For people. */
  String line() {
    return String.format(
        Locale.ROOT,
        "%-17s %-12s %3d Hz: %2d of %d failed, error %.3g, %.4f ms a simulated second",
        solver.label,
        solver.describe(setting),
        setting.hz(),
        failed,
        scenes,
        error,
        cost);
  }

  /** As a row of a table: failed, error, cost. */
  String row() {
    return String.format(
        Locale.ROOT,
        "| %s | %s | %d | %d | %.4f | %.3f |",
        solver.label,
        solver.describe(setting),
        setting.hz(),
        failed,
        error,
        cost);
  }
}
