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
}
