package org.jbox2d.benchmarks.accuracy;

import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.jbox2d.benchmarks.engines.Sim;

/** Measures errors and times. */
final class Meter {
  /** Thread time of the timed runs of one scene, solver and setting that is enough, ms. */
  private static final double ENOUGH = 100;

  private Meter() {}

  static double error(Scene scene, Contender solver, Setting setting) {
    try (Sim sim = solver.open(setting)) {
      return scene.measure(sim, setting.hz());
    }
  }

  static double time(Scene scene, Contender solver, Setting setting) {
    try (Sim sim = solver.open(setting)) {
      return scene.time(sim, setting.hz());
    }
  }

  /**
   * Error, and the shortest time of some runs after the one that gave the error: fewer if the scene
   * is a long one.
   */
  static Result result(Scene scene, Contender solver, Setting setting, int repeats) {
    double error = error(scene, solver, setting);
    double cost = Double.POSITIVE_INFINITY;
    double spent = 0;
    for (int i = 0; i < repeats && spent < ENOUGH; i++) {
      double time = time(scene, solver, setting);
      spent += time * scene.seconds();
      cost = Math.min(cost, time);
    }
    return new Result(scene, solver, setting, error, cost);
  }
}
