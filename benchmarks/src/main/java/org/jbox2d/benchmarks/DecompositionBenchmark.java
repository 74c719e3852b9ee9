package org.jbox2d.benchmarks;

import java.util.concurrent.TimeUnit;
import org.jbox2d.benchmarks.charts.Inputs;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.hertelmehlhorn.ConvexDecomposition;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Convex decomposition of random simple polygons into parts of 8 vertices at most. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class DecompositionBenchmark {
  private static final int MOST_VERTICES = 8;

  /** Vertices of all the polygons together: of few polygons the processor learns each branch. */
  private static final int VERTICES = 10_000;

  /** Vertices of a polygon. */
  @Param({"32", "512"})
  public int vertices;

  private final ConvexDecomposition decomposition = new ConvexDecomposition();
  private Outline[] polygons;
  private int turn;

  /** Makes the polygons. */
  @Setup
  public void setUp() {
    polygons = new Outline[VERTICES / vertices];
    for (int i = 0; i < polygons.length; i++) {
      polygons[i] = Inputs.polygon(vertices, 1000L * vertices + i);
    }
  }

  /** Decomposes the next polygon. */
  @Benchmark
  public ConvexDecomposition.Result decompose() {
    turn = turn + 1 < polygons.length ? turn + 1 : 0;
    return decomposition.decompose(polygons[turn], MOST_VERTICES, 0);
  }
}
