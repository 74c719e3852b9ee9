package org.jbox2d.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jbox2d.benchmarks.engines.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Draws a run once more. */
@Command(
    name = "charts",
    mixinStandardHelpOptions = true,
    description = "Draws the charts of the results in a directory and prints their tables.")
final class ChartsCommand implements Callable<Integer> {
  @Option(names = "--directory", description = "Where accuracy.csv is and the charts go.")
  private Path directory = Path.of("docs/charts/accuracy");

  @Override
  public Integer call() throws IOException {
    Results results = Results.read(directory.resolve(Results.FILE));
    new AccuracyCharts(results, directory).draw();
    System.out.println("| solver | setting | Hz | failed | error | cost, ms/s |");
    System.out.println("|---|---|--:|--:|--:|--:|");
    for (Summary s : results.summaries()) {
      if (s.setting().hz() == Setting.STANDARD.hz()) {
        System.out.println(s.row());
      }
    }
    return 0;
  }
}
