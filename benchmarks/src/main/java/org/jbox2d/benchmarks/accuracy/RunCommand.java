package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** All solvers at all settings. */
@Command(
    name = "run",
    mixinStandardHelpOptions = true,
    description = "Runs all scenes at all settings, writes accuracy.csv and draws the charts.")
final class RunCommand implements Callable<Integer> {
  @Option(names = "--directory", description = "Where to write.")
  private Path directory = Path.of("docs/charts/accuracy");

  @Option(names = "--scene", description = "Regular expression of the scenes' names.")
  private String scenes = ".*";

  @Option(names = "--solver", split = ",", description = "Labels of solvers; all if left out.")
  private List<String> solvers = new ArrayList<>();

  @Option(names = "--repeats", description = "Timed runs of each; the shortest counts.")
  private int repeats = 3;

  @Option(
      names = "--warm",
      description = "Rounds through all scenes before the first that is timed.")
  private int rounds = 8;

  @Option(names = "--standard", description = "60 Hz and 8/3 or 4 substeps alone.")
  private boolean standard;

  @Override
  public Integer call() throws IOException {
    PrintStream out = System.out;
    List<Contender> chosen = Contender.chosen(solvers);
    List<Setting> settings = standard ? List.of(Setting.STANDARD) : Setting.all();
    List<Scene> all = new ArrayList<>(Suite.common());
    all.addAll(Suite.fracture());
    all.removeIf(scene -> !scene.name().matches(scenes));
    for (int i = 0; i < rounds; i++) {
      warm(all, chosen);
    }
    Results results = new Results();
    for (Scene scene : all) {
      for (Contender solver : chosen) {
        if (Suite.canRun(solver, scene)) {
          for (Setting setting : settings) {
            if (solver.has(setting)) {
              results.add(Meter.result(scene, solver, setting, repeats));
            }
          }
        }
      }
      out.println(scene.name());
    }
    Files.createDirectories(directory);
    results.write(directory.resolve(Results.FILE));
    results.summaries().forEach(s -> out.println(s.line()));
    if (!standard) {
      new AccuracyCharts(results, directory).draw();
      new Tables(results).write(directory.resolve("README.md"));
    }
    return 0;
  }

  /**
   * Once through everything. After one round much of what a step does in a scene of one or two
   * bodies, some thousand steps in all, is still run by the quick compiler's code, at three times
   * its time; after eight the times have settled.
   */
  private static void warm(List<Scene> all, List<Contender> chosen) {
    for (Scene scene : all) {
      for (Contender solver : chosen) {
        if (Suite.canRun(solver, scene)) {
          Meter.time(scene, solver, Setting.STANDARD);
        }
      }
    }
  }
}
