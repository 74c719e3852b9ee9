package org.jbox2d.benchmarks.accuracy;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.jbox2d.benchmarks.engines.Sim;

/**
 * A scene whose outcome is known.
 *
 * @param name name, as in results
 * @param seconds how long it runs
 * @param limit greatest error that passes
 * @param reason the truth, and why the limit is where it is
 * @param script how to build it
 */
public record Scene(String name, double seconds, double limit, String reason, Script script) {
  /**
   * No error is counted as less than that: nobody sees it, and without a floor a few exact results
   * would make up the geometric mean.
   */
  public static final double FLOOR = 1e-4;

  /** No error is counted as more than that: what has gone ten times wrong is lost. */
  public static final double CEILING = 10;

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** Builds a scene in an empty world. */
  @FunctionalInterface
  public interface Script {
    /** Adds all bodies and joints. */
    Run start(Sim sim);
  }

  /**
   * Runs the scene.
   *
   * @param sim an empty world
   * @param hz steps per second
   * @return the error, {@link #CEILING} at most
   */
  public double measure(Sim sim, int hz) {
    Run run = script.start(sim);
    double dt = 1.0 / hz;
    int steps = steps(hz);
    for (int i = 0; i < steps; i++) {
      run.before(i * dt);
      sim.step(dt);
      run.after((i + 1) * dt, dt);
    }
    double error = run.error(steps * dt);
    return Double.isNaN(error) ? CEILING : Math.min(CEILING, error);
  }

  /**
   * Runs the scene without looking at it.
   *
   * @param sim an empty world
   * @param hz steps per second
   * @return thread time that a simulated second took, ms, without building the scene
   */
  public double time(Sim sim, int hz) {
    Run run = script.start(sim);
    double dt = 1.0 / hz;
    int steps = steps(hz);
    long start = THREADS.getCurrentThreadCpuTime();
    for (int i = 0; i < steps; i++) {
      run.before(i * dt);
      sim.step(dt);
    }
    return (THREADS.getCurrentThreadCpuTime() - start) * 1e-6 / seconds;
  }

  /** Number of steps at a rate. */
  public int steps(int hz) {
    return (int) Math.round(seconds * hz);
  }
}
