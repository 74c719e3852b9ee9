package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Finds the cheapest way to an error. */
@Command(
    name = "recommend",
    mixinStandardHelpOptions = true,
    description = "The cheapest solver and setting of this engine that meets an error in a scene.")
final class RecommendCommand implements Callable<Integer> {
  @Option(names = "--scene", required = true, description = "Name of the scene.")
  private String scene;

  @Option(names = "--error", required = true, description = "Greatest error that will do.")
  private double error;

  @Option(names = "--results", description = "Results of a run; those of the last if left out.")
  private Path file;

  @Option(names = "--measure", description = "Measure now instead of reading results.")
  private boolean measure;

  @Override
  public Integer call() throws IOException {
    Scene wanted = Suite.named(scene);
    Results results =
        measure ? measured(wanted) : file == null ? Results.last() : Results.read(file);
    Optional<Result> best = cheapest(results, wanted, error);
    System.out.println(
        best.map(RecommendCommand::describe).orElse("no setting meets " + error + " in " + scene));
    return best.isPresent() ? 0 : 1;
  }

  static Optional<Result> cheapest(Results results, Scene scene, double error) {
    return results.rows().stream()
        .filter(r -> r.solver().ours && r.scene().name().equals(scene.name()))
        .filter(r -> r.error() <= error)
        .min(Comparator.comparingDouble(Result::cost));
  }

  static String describe(Result r) {
    return String.format(
        Locale.ROOT,
        "%s, %s, %d Hz: error %.3g, %.3g ms a simulated second",
        r.solver().label,
        r.solver().describe(r.setting()),
        r.setting().hz(),
        r.error(),
        r.cost());
  }

  private static Results measured(Scene scene) {
    Results results = new Results();
    for (Contender solver : Contender.values()) {
      for (Setting setting : Setting.all()) {
        if (solver.ours && solver.has(setting)) {
          results.add(Meter.result(scene, solver, setting, 5));
        }
      }
    }
    return results;
  }
}
