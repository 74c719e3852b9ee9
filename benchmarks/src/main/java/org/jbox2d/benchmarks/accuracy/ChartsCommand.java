package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Draws a run once more. */
@Command(
    name = "charts",
    mixinStandardHelpOptions = true,
    description = "Draws the charts of the results in a directory and writes their tables.")
final class ChartsCommand implements Callable<Integer> {
  @Option(names = "--directory", description = "Where accuracy.csv is and the charts go.")
  private Path directory = Path.of("docs/charts/accuracy");

  @Override
  public Integer call() throws IOException {
    Results results = Results.read(directory.resolve(Results.FILE));
    new AccuracyCharts(results, directory).draw();
    new Tables(results).write(directory.resolve("README.md"));
    return 0;
  }
}
