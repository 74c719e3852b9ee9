package org.jbox2d.benchmarks.accuracy;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jbox2d.benchmarks.charts.Drawing;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws the results of a run. */
final class AccuracyCharts {
  private static final Color[] COLOURS = {
    new Color(0x1F5FA8),
    new Color(0x8A3FA0),
    new Color(0xC2185B),
    new Color(0xD9661F),
    new Color(0x3B8F4A),
    new Color(0x7A6A53)
  };

  /** Scenes whose error is drawn against the rate of steps. */
  private static final List<String> CONVERGENCE =
      List.of("double_pendulum", "pendulum_period", "rod_fall", "free_fall");

  /** What is drawn. */
  static final List<String> NAMES = names();

  private static final Color FRONT = new Color(0xB0B0B0);

  private static final String COST = "thread time of a simulated second, ms (geometric mean)";

  private final Results results;
  private final Path directory;

  AccuracyCharts(Results results, Path directory) {
    this.results = results;
    this.directory = directory;
  }

  private static List<String> names() {
    List<String> names = new ArrayList<>();
    names.add("error-against-cost");
    names.add("failures-against-cost");
    names.add("failures");
    CONVERGENCE.forEach(scene -> names.add("convergence-" + scene));
    return names;
  }

  static Color colour(Contender solver) {
    return COLOURS[solver.ordinal() % COLOURS.length];
  }

  /** A colour of its own for a scene; lighter for each further solver. */
  static Color shade(int scene, Contender solver) {
    Color base = COLOURS[scene % COLOURS.length];
    int k = 60 * solver.ordinal();
    return new Color(
        Math.min(255, base.getRed() + k),
        Math.min(255, base.getGreen() + k),
        Math.min(255, base.getBlue() + k));
  }

  void draw() throws IOException {
    List<Summary> all = results.summaries();
    errorAgainstCost(all);
    failuresAgainstCost(all);
    for (String scene : CONVERGENCE) {
      convergence(scene);
    }
    new HeatMap(results.rows()).write(directory.resolve("failures.svg"));
  }

  /** The summaries that no other one beats in both. */
  static List<Summary> front(List<Summary> all) {
    List<Summary> sorted = new ArrayList<>(all);
    sorted.sort(Comparator.comparingDouble(Summary::cost).thenComparingDouble(Summary::error));
    List<Summary> front = new ArrayList<>();
    for (Summary s : sorted) {
      if (front.isEmpty() || s.error() < front.get(front.size() - 1).error()) {
        front.add(s);
      }
    }
    return front;
  }

  private void errorAgainstCost(List<Summary> all) throws IOException {
    Drawing drawing =
        new Drawing("Error against cost, all settings", COST, "error (geometric mean)");
    drawing.logLog().numbers("0.###", "0.####").legend(LegendPosition.OutsideE);
    List<Summary> front = front(all);
    double[] x = front.stream().mapToDouble(Summary::cost).toArray();
    double[] y = front.stream().mapToDouble(Summary::error).toArray();
    drawing.curve("Pareto front", x, y, FRONT);
    for (Contender solver : Contender.values()) {
      List<Summary> own = all.stream().filter(s -> s.solver() == solver).toList();
      if (!own.isEmpty()) {
        drawing.points(
            solver.label,
            own.stream().mapToDouble(Summary::cost).toArray(),
            own.stream().mapToDouble(Summary::error).toArray(),
            colour(solver),
            solver.ours ? SeriesMarkers.CIRCLE : SeriesMarkers.SQUARE);
      }
    }
    drawing.write(directory.resolve("error-against-cost.svg"));
  }

  private void failuresAgainstCost(List<Summary> all) throws IOException {
    Drawing drawing =
        new Drawing("Failed scenes against cost, all settings", COST, "scenes above their limit");
    drawing.numbers("0.###", "0").legend(LegendPosition.OutsideE);
    for (Contender solver : Contender.values()) {
      List<Summary> own = all.stream().filter(s -> s.solver() == solver).toList();
      if (!own.isEmpty()) {
        drawing.points(
            solver.label,
            own.stream().mapToDouble(Summary::cost).toArray(),
            own.stream().mapToDouble(Summary::failed).toArray(),
            colour(solver),
            solver.ours ? SeriesMarkers.CIRCLE : SeriesMarkers.SQUARE);
      }
    }
    drawing.write(directory.resolve("failures-against-cost.svg"));
  }

  private void convergence(String scene) throws IOException {
    Drawing drawing =
        new Drawing("Error against steps per second: " + scene, "steps per second", "error");
    drawing.logLog().numbers("0", "0.######").legend(LegendPosition.OutsideE);
    for (Contender solver : Contender.values()) {
      List<Result> own =
          results.rows().stream()
              .filter(r -> r.solver() == solver && r.scene().name().equals(scene))
              .filter(r -> r.setting().level() == Setting.STANDARD.level())
              .sorted(Comparator.comparingInt(r -> r.setting().hz()))
              .toList();
      if (!own.isEmpty()) {
        drawing.line(
            solver.label,
            own.stream().mapToDouble(r -> r.setting().hz()).toArray(),
            own.stream().mapToDouble(r -> Math.max(1e-7, r.error())).toArray(),
            colour(solver),
            !solver.ours);
      }
    }
    drawing.write(directory.resolve("convergence-" + scene + ".svg"));
  }
}
