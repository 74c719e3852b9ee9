package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;

/** Writes the results of a run as tables for people. */
final class Tables {
  private final Results results;
  private final List<Contender> solvers = new ArrayList<>();

  Tables(Results results) {
    this.results = results;
    for (Result r : results.rows()) {
      if (!solvers.contains(r.solver())) {
        solvers.add(r.solver());
      }
    }
    solvers.sort(null);
  }

  void write(Path file) throws IOException {
    StringBuilder out = new StringBuilder();
    out.append("# Results of the suite\n\n");
    out.append("Written by `Accuracy run` from [accuracy.csv](accuracy.csv); ");
    out.append("[../../accuracy.md](../../accuracy.md) says what it means.\n\n");
    out.append("## At 60 Hz\n\nScenes failed, geometric mean of the errors, and of the ");
    out.append("thread time of a simulated second.\n\n");
    summaries(out, true);
    out.append("\n## At all rates\n\n");
    summaries(out, false);
    out.append("\n## Error of each scene at 60 Hz and 8/3 iterations or 4 substeps\n\n");
    out.append("What fails is bold.\n\n");
    scenes(out);
    out.append("\n## What the scenes show\n\n| scene | limit | truth, and why the limit |\n");
    out.append("|---|--:|---|\n");
    List<Scene> all = new ArrayList<>(Suite.common());
    all.addAll(Suite.fracture());
    for (Scene scene : all) {
      out.append(
          String.format(
              Locale.ROOT, "| %s | %s | %s |\n", scene.name(), scene.limit(), scene.reason()));
    }
    out.append("\n## Charts\n\n");
    for (String name : AccuracyCharts.NAMES) {
      out.append("![](").append(name).append(".svg)\n");
    }
    out.append("\nTime of a step against the number of bodies, by `Accuracy bodies`: ");
    out.append("[bodies.csv](bodies.csv).\n\n");
    for (String name : BodiesCommand.NAMES) {
      out.append("![](").append(name).append(".svg)\n");
    }
    Files.writeString(file, out.toString());
  }

  private void summaries(StringBuilder out, boolean standardRate) {
    out.append("| solver | setting | Hz | failed | error | cost, ms |\n");
    out.append("|---|---|--:|--:|--:|--:|\n");
    for (Summary s : results.summaries()) {
      if ((s.setting().hz() == Setting.STANDARD.hz()) == standardRate) {
        out.append(s.row()).append('\n');
      }
    }
  }

  private void scenes(StringBuilder out) {
    out.append("| scene | limit |");
    solvers.forEach(s -> out.append(' ').append(s.label).append(" |"));
    out.append("\n|---|--:|").append("--:|".repeat(solvers.size())).append('\n');
    List<Scene> all = results.rows().stream().map(Result::scene).distinct().toList();
    for (Scene scene : all) {
      out.append(String.format(Locale.ROOT, "| %s | %s |", scene.name(), scene.limit()));
      for (Contender solver : solvers) {
        out.append(' ').append(cell(scene, solver)).append(" |");
      }
      out.append('\n');
    }
  }

  private String cell(Scene scene, Contender solver) {
    for (Result r : results.rows()) {
      if (r.scene() == scene && r.solver() == solver && r.setting().equals(Setting.STANDARD)) {
        double shown = Math.max(Scene.FLOOR, r.error());
        String figure = String.format(Locale.ROOT, shown < 0.001 ? "%.4f" : "%.3f", shown);
        return r.failed() ? "**" + figure + "**" : figure;
      }
    }
    return "";
  }
}
