package org.jbox2d.benchmarks;

import java.util.concurrent.TimeUnit;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The first five seconds of each scene of the testbed, fractures and all, from the same beginning
 * each time.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2)
@Measurement(iterations = 5)
@Fork(1)
public class TestbedBenchmark {
  private static final float SECONDS = 5f;

  /** A name of {@link Scenes#all()}; all of them are listed here. */
  @Param({
    "main",
    "cube",
    "circle",
    "rotated-body",
    "static-body",
    "material-uniform",
    "material-diffusion",
    "material-glass",
    "glass-pane",
    "brick-wall",
    "tower",
    "planks",
    "vase",
    "holes",
    "asteroid",
    "tower-blast",
    "breaking-bridge",
    "rain-on-roofs",
    "avalanche",
    "pyramid",
    "dominoes",
    "newtons-cradle",
    "bridge",
    "tumbler",
    "debris-pile",
    "card-house",
    "car",
    "ragdolls",
    "chains",
    "conveyor",
    "one-sided",
    "bullets"
  })
  public String scene;

  private Simulation simulation;

  /** Builds the scene. */
  @org.openjdk.jmh.annotations.Setup(Level.Invocation)
  public void build() {
    simulation = new Simulation(Setup.of(Scenes.named(scene), 1));
  }

  /** Five seconds of it. */
  @Benchmark
  public long run() {
    int steps = Math.round(SECONDS * simulation.hz());
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
    return simulation.hash();
  }
}
