package org.jbox2d.benchmarks;

import java.util.Collections;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.jbox2d.benchmarks.charts.Inputs;
import org.jbox2d.fracture.fragmentation.Fragmentation;
import org.jbox2d.fracture.fragmentation.Fragmenter;
import org.jbox2d.fracture.fragmentation.PieceLimits;
import org.jbox2d.fracture.fragmentation.RegionOfEffect;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The geometry of a fracture: Voronoi diagrams and fragmentation. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FractureBenchmark {
  private final double[] sites100 = sites(100);
  private final double[] sites256 = sites(256);
  private final double[] sites10000 = sites(10_000);
  private final VoronoiDiagram voronoi = new VoronoiDiagram();
  private final Fragmenter fragmenter = new Fragmenter();
  private final Outline box = Outline.of(0, 0, 1, 0, 1, 1, 0, 1);
  private final Outline star = Inputs.star(64);

  private static double[] sites(int n) {
    Random random = new Random(n);
    double[] xy = new double[2 * n];
    for (int i = 0; i < xy.length; i++) {
      xy[i] = random.nextDouble();
    }
    return xy;
  }

  /** Diagram of 100 sites in a square. */
  @Benchmark
  public VoronoiDiagram voronoi100() {
    voronoi.compute(sites100, 100, 0, 0, 1, 1);
    return voronoi;
  }

  /** Diagram of 256 sites in a square. */
  @Benchmark
  public VoronoiDiagram voronoi256() {
    voronoi.compute(sites256, 256, 0, 0, 1, 1);
    return voronoi;
  }

  /** Diagram of 10,000 sites in a square. */
  @Benchmark
  public VoronoiDiagram voronoi10000() {
    voronoi.compute(sites10000, 10_000, 0, 0, 1, 1);
    return voronoi;
  }

  /** A star of 64 vertices falls apart into 100 cells. */
  @Benchmark
  public Fragmentation fragmentStar100() {
    return fragmenter.fragment(
        star, sites100, 100, Collections.<RegionOfEffect>emptyList(), PieceLimits.NONE);
  }

  /** A square falls apart into 100 cells. */
  @Benchmark
  public Fragmentation fragmentBox100() {
    return fragmenter.fragment(
        box, sites100, 100, Collections.<RegionOfEffect>emptyList(), PieceLimits.NONE);
  }
}
