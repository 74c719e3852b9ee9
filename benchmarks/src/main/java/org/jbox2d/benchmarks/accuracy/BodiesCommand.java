package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.jbox2d.benchmarks.charts.Drawing;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.scenes.Breaking;
import org.jbox2d.benchmarks.scenes.Jointed;
import org.jbox2d.benchmarks.scenes.Piles;
import org.jbox2d.benchmarks.scenes.SteppedScene;
import org.knowm.xchart.style.Styler.LegendPosition;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** How the time of a step grows with the bodies. */
@Command(
    name = "bodies",
    mixinStandardHelpOptions = true,
    description = "Thread time of a step against the number of bodies, 100 to 20,000.")
final class BodiesCommand implements Callable<Integer> {
  private static final int[] SIZES = {100, 300, 1000, 3000, 10_000, 20_000};

  /** Steps before the measured ones, and those: fewer from LARGE bodies on. */
  private static final int WARM_STEPS = 120;

  private static final int STEPS = 40;
  private static final int LARGE = 10_000;
  private static final int WARM_STEPS_OF_LARGE = 40;
  private static final int STEPS_OF_LARGE = 12;

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  @Option(names = "--directory", description = "Where to write.")
  private Path directory = Path.of("docs/charts/accuracy");

  @Option(names = "--solver", split = ",", description = "Labels of solvers; all if left out.")
  private List<String> solvers = new ArrayList<>();

  @Option(names = "--most", description = "Greatest number of bodies.")
  private int most = SIZES[SIZES.length - 1];

  /** A scene of about so many bodies. */
  private enum Shape {
    PYRAMID("pyramid", false, (sim, n) -> Piles.pyramid(sim, (int) Math.round(Math.sqrt(2.0 * n)))),
    DEBRIS("debris", false, Piles::debris),
    JOINT_GRID(
        "joint_grid", false, (sim, n) -> Jointed.jointGrid(sim, (int) Math.round(Math.sqrt(n)))),
    FRACTURE("fracture", true, Breaking::new);

    final String label;
    final boolean oursAlone;
    final BiFunction<Sim, Integer, SteppedScene> builder;

    Shape(String label, boolean oursAlone, BiFunction<Sim, Integer, SteppedScene> builder) {
      this.label = label;
      this.oursAlone = oursAlone;
      this.builder = builder;
    }
  }

  /** What is drawn. */
  static final List<String> NAMES =
      Stream.concat(
              Arrays.stream(Shape.values()).map(shape -> "bodies-" + shape.label),
              Stream.of("bodies-each"))
          .toList();

  @Override
  public Integer call() throws IOException {
    PrintStream out = System.out;
    Files.createDirectories(directory);
    List<String> lines = new ArrayList<>(List.of("scene,solver,bodies,step_ms"));
    Drawing each =
        new Drawing("Time of a step for each body", "bodies", "thread time, microseconds a body");
    each.numbers("#,##0", "0.#").legend(LegendPosition.OutsideE);
    for (Shape shape : Shape.values()) {
      Drawing drawing =
          new Drawing("Step time: " + shape.label, "bodies", "thread time of a step, ms");
      drawing.logLog().numbers("#,##0", "0.###");
      for (Contender solver : Contender.chosen(solvers)) {
        if (shape.oursAlone && !solver.ours) {
          continue;
        }
        List<double[]> points = new ArrayList<>();
        for (int size : SIZES) {
          if (size <= most) {
            double[] point = point(shape, solver, size);
            points.add(point);
            String line =
                String.format(
                    Locale.ROOT, "%s,%s,%.0f,%.4g", shape.label, solver.label, point[0], point[1]);
            out.println(line);
            lines.add(line);
          }
        }
        double[] x = points.stream().mapToDouble(p -> p[0]).toArray();
        double[] y = points.stream().mapToDouble(p -> p[1]).toArray();
        drawing.line(solver.label, x, y, AccuracyCharts.colour(solver), !solver.ours);
        if (solver.ours) {
          double[] micros = points.stream().mapToDouble(p -> 1000 * p[1] / p[0]).toArray();
          String name = shape.label + ", " + solver.label;
          each.line(name, x, micros, AccuracyCharts.shade(shape.ordinal(), solver), false);
        }
      }
      drawing.write(directory.resolve("bodies-" + shape.label + ".svg"));
    }
    each.write(directory.resolve("bodies-each.svg"));
    Files.writeString(directory.resolve("bodies.csv"), String.join("\n", lines) + "\n");
    return 0;
  }

  /** Number of bodies and median time of a step, ms. */
  private double[] point(Shape shape, Contender solver, int size) {
    try (SteppedScene scene = shape.builder.apply(solver.open(Setting.STANDARD), size)) {
      int warm = size < LARGE ? WARM_STEPS : WARM_STEPS_OF_LARGE;
      for (int i = 0; i < warm; i++) {
        scene.step();
      }
      int n = size < LARGE ? STEPS : STEPS_OF_LARGE;
      long[] nanos = new long[n];
      for (int i = 0; i < n; i++) {
        long before = THREADS.getCurrentThreadCpuTime();
        scene.step();
        nanos[i] = THREADS.getCurrentThreadCpuTime() - before;
      }
      Arrays.sort(nanos);
      return new double[] {scene.bodyCount(), nanos[n / 2] * 1e-6};
    }
  }
}
