package org.jbox2d.benchmarks.accuracy;

import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;

/**
 * What a solver at a setting makes of a scene.
 *
 * @param scene the scene
 * @param solver the solver
 * @param setting its setting
 * @param error the error
 * @param cost thread time of a simulated second, ms
 */
public record Result(Scene scene, Contender solver, Setting setting, double error, double cost) {
  /** Whether the error is above the scene's limit. */
  public boolean failed() {
    return error > scene.limit();
  }
}
