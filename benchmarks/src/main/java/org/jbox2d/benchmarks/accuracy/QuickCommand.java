package org.jbox2d.benchmarks.accuracy;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Each solver at one setting, with an error for each scene. */
@Command(
    name = "quick",
    mixinStandardHelpOptions = true,
    description = "Errors of each scene and solver at one setting; ! marks those above the limit.")
final class QuickCommand implements Callable<Integer> {
  @Option(names = "--scene", description = "Regular expression of the scenes' names.")
  private String scenes = ".*";

  @Option(names = "--solver", split = ",", description = "Labels of solvers; all if left out.")
  private List<String> solvers = new ArrayList<>();

  @Option(names = "--level", description = "0 to 3: 4/2, 8/3, 16/6, 32/12, or 2 to 16 substeps.")
  private int level = Setting.STANDARD.level();

  @Option(names = "--hz", description = "Steps per second.")
  private int hz = Setting.STANDARD.hz();

  @Option(names = "--repeats", description = "Timed runs of each; the shortest counts.")
  private int repeats = 5;

  @Override
  public Integer call() {
    PrintStream out = System.out;
    List<Contender> chosen = Contender.chosen(solvers);
    Map<Contender, List<Result>> results = new EnumMap<>(Contender.class);
    out.printf("%-20s %8s", "scene", "limit");
    for (Contender solver : chosen) {
      results.put(solver, new ArrayList<>());
      out.printf(" %17s", solver.label);
    }
    out.println();
    for (Scene scene : Suite.common()) {
      if (scene.name().matches(scenes)) {
        row(scene, chosen, results, out);
      }
    }
    for (Scene scene : Suite.fracture()) {
      if (scene.name().matches(scenes)) {
        row(scene, chosen, null, out);
      }
    }
    for (Contender solver : chosen) {
      if (!results.get(solver).isEmpty()) {
        out.println(Summary.of(results.get(solver)).line());
      }
    }
    return 0;
  }

  /** Prints errors; collects results unless only some of the solvers run the scene. */
  private void row(
      Scene scene, List<Contender> chosen, Map<Contender, List<Result>> results, PrintStream out) {
    Setting setting = new Setting(level, hz);
    out.printf(Locale.ROOT, "%-20s %8.3g", scene.name(), scene.limit());
    for (Contender solver : chosen) {
      if (results == null && !solver.ours) {
        out.printf(" %16s ", "-");
        continue;
      }
      Result r = Meter.result(scene, solver, setting, repeats);
      if (results != null) {
        results.get(solver).add(r);
      }
      out.printf(Locale.ROOT, " %16.3g%s", r.error(), r.failed() ? "!" : " ");
    }
    out.println();
  }
}
