package org.jbox2d.benchmarks.accuracy;

import picocli.CommandLine;
import picocli.CommandLine.Command;

/**
 * The suite of accuracy and stability: {@code java -cp benchmarks/target/benchmarks.jar
 * org.jbox2d.benchmarks.accuracy.Accuracy quick}.
 */
@Command(
    name = "accuracy",
    mixinStandardHelpOptions = true,
    description = "Scenes whose outcome is known, in this engine and its peers.",
    subcommands = {
      QuickCommand.class,
      RunCommand.class,
      BodiesCommand.class,
      ChartsCommand.class,
      RecommendCommand.class
    })
public final class Accuracy {
  private Accuracy() {}

  /** Runs a command. */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true");
    System.exit(new CommandLine(new Accuracy()).execute(args));
  }
}
