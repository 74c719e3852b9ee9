package org.jbox2d.benchmarks.accuracy;

import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.jbox2d.benchmarks.engines.Sim;

/** Measures errors and times. */
final class Meter {
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

  /** Error, and the shortest time of some runs after the one that gave the error. */
  static Result result(Scene scene, Contender solver, Setting setting, int repeats) {
    double error = error(scene, solver, setting);
    double cost = Double.POSITIVE_INFINITY;
    for (int i = 0; i < repeats; i++) {
      cost = Math.min(cost, time(scene, solver, setting));
    }
    return new Result(scene, solver, setting, error, cost);
  }
}
