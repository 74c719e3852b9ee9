package org.jbox2d.testbed;

import picocli.CommandLine;

/** Entry point of the testbed. */
public final class Main {
  private Main() {}

  /** Runs the testbed; leaves the virtual machine running if it has opened a window. */
  public static void main(String[] args) {
    int code = TestbedCommand.commandLine().execute(args);
    if (code != CommandLine.ExitCode.OK) {
      System.exit(code);
    }
  }
}
