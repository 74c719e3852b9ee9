package org.jbox2d.benchmarks;

import java.util.concurrent.TimeUnit;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.scenes.SceneSpec;
import org.jbox2d.benchmarks.scenes.SteppedScene;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** A step of each scene in each engine. {@link Ratios} compares engines within one run. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class SceneBenchmark {
  @Param({
    "large_pyramid",
    "debris",
    "joint_grid",
    "smash",
    "spinner",
    "rain",
    "many_pyramids",
    "tumbler",
    "bullet_hail",
    "create_destroy",
    "raycast",
    "sleeping"
  })
  public String scene;

  @Param({"sequential", "soft", "adaptive", "jbox2d-2.2.1.1", "dyn4j-6.0.0", "gdx-box2d-1.14.2"})
  public String solver;

  private SteppedScene running;

  /** Builds the scene and lets it get under way. */
  @Setup(Level.Trial)
  public void build() {
    SceneSpec spec = SceneSpec.of(scene);
    running = spec.build(Contender.of(solver));
    for (int i = 0; i < spec.warmSteps; i++) {
      running.step();
    }
  }

  /** Frees what an engine holds outside the heap. */
  @TearDown(Level.Trial)
  public void close() {
    running.close();
  }

  /** One frame. */
  @Benchmark
  public void step() {
    running.step();
  }
}
