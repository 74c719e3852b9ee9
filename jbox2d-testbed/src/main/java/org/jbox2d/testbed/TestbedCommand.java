package org.jbox2d.testbed;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jbox2d.testbed.headless.HeadlessRunner;
import org.jbox2d.testbed.headless.RunRequest;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.ui.TestbedWindow;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The command line: decides between the window and a run without one. */
@Command(
    name = "jbox2d-testbed",
    mixinStandardHelpOptions = true,
    version = "JBox2D testbed 0.1.0-SNAPSHOT",
    description = {
      "Shows bodies that break, in a window or without one.",
      "Without a display, or with an option that needs no window (--headless, --steps, --png,"
          + " --csv, --gif, --hash, --profile), runs a scene and reports."
    },
    exitCodeListHeading = "Exit codes:%n",
    exitCodeList = {"0:done", "1:a file could not be written", "2:the command line is wrong"})
final class TestbedCommand implements Callable<Integer> {
  private static final int DEFAULT_STEPS = 600;
  private static final int MAX_STEPS = 100_000_000;
  private static final Path DEFAULT_PNG = Path.of("jbox2d-testbed.png");

  @Spec private CommandSpec spec;

  @Option(names = "--headless", description = "Open no window.")
  private boolean headless;

  @Option(names = "--list", description = "Print the scenes and what they show.")
  private boolean list;

  @Option(names = "--scene", paramLabel = "NAME", description = "The scene; main if not given.")
  private String sceneName;

  @Option(names = "--steps", paramLabel = "N", description = "Number of steps; 600 if not given.")
  private Integer steps;

  @Option(
      names = "--hz",
      paramLabel = "HZ",
      description = "Steps per second; the scene's own if not given.")
  private Float hz;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Seed of the fractures; ${DEFAULT-VALUE} if not given.")
  private long seed = 1;

  @Option(names = "--png", paramLabel = "FILE", description = "Write a picture of the end.")
  private Path png;

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Write a line of figures for each step.")
  private Path csv;

  @Option(names = "--gif", paramLabel = "FILE", description = "Write an animation.")
  private Path gif;

  @Option(names = "--hash", description = "Print the hash of the end alone, nothing else.")
  private boolean hash;

  @Option(names = "--profile", description = "Print how long the phases of a step took.")
  private boolean profile;

  private TestbedCommand() {}

  /** Returns the command with its way of reporting mistakes: one line, and exit code 2. */
  static CommandLine commandLine() {
    CommandLine line = new CommandLine(new TestbedCommand());
    line.setParameterExceptionHandler(
        (e, args) -> {
          e.getCommandLine().getErr().println(e.getMessage() + " (--help lists the options)");
          return CommandLine.ExitCode.USAGE;
        });
    return line;
  }

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    if (list) {
      printScenes(out);
      return CommandLine.ExitCode.OK;
    }
    Scene scene = scene();
    boolean noDisplay = GraphicsEnvironment.isHeadless();
    if (!noDisplay && !needsNoWindow()) {
      TestbedWindow.open(scene, hz(scene), seed);
      return CommandLine.ExitCode.OK;
    }
    boolean asked = needsNoWindow();
    RunRequest request = request(scene, asked ? png : DEFAULT_PNG);
    if (!asked) {
      out.println("No display: running scene '" + scene.name() + "' without a window.");
      out.flush();
    }
    return runHeadless(request, out);
  }

  private boolean needsNoWindow() {
    return headless
        || hash
        || profile
        || steps != null
        || png != null
        || csv != null
        || gif != null;
  }

  private RunRequest request(Scene scene, Path picture) {
    return new RunRequest(
        scene,
        steps(),
        hz(scene),
        seed,
        writable("--png", picture),
        writable("--csv", csv),
        writable("--gif", gif),
        profile,
        hash);
  }

  private int runHeadless(RunRequest request, PrintWriter out) {
    System.setProperty("java.awt.headless", "true");
    try {
      HeadlessRunner.run(request, out);
      return CommandLine.ExitCode.OK;
    } catch (IOException e) {
      spec.commandLine().getErr().println("could not write: " + e.getMessage());
      return CommandLine.ExitCode.SOFTWARE;
    }
  }

  private Scene scene() {
    if (sceneName == null) {
      return Scenes.first();
    }
    try {
      return Scenes.named(sceneName);
    } catch (IllegalArgumentException e) {
      throw wrong(e.getMessage());
    }
  }

  private int steps() {
    if (steps == null) {
      return DEFAULT_STEPS;
    }
    if (steps < 0 || steps > MAX_STEPS) {
      throw wrong("--steps must be 0 to " + MAX_STEPS + ", is " + steps);
    }
    return steps;
  }

  private float hz(Scene scene) {
    if (hz == null) {
      return scene.hz();
    }
    if (!(hz > 0f) || Float.isInfinite(hz)) {
      throw wrong("--hz must be a positive number such as 60, is " + hz);
    }
    return hz;
  }

  private Path writable(String option, Path file) {
    if (file == null) {
      return null;
    }
    Path parent = file.toAbsolutePath().getParent();
    if (parent == null || !Files.isDirectory(parent)) {
      throw wrong(option + " must be in a directory that exists, is " + file);
    }
    if (Files.isDirectory(file)) {
      throw wrong(option + " must be a file, is the directory " + file);
    }
    return file;
  }

  private ParameterException wrong(String message) {
    return new ParameterException(spec.commandLine(), message);
  }

  private static void printScenes(PrintWriter out) {
    int width = 0;
    for (Scene scene : Scenes.all()) {
      width = Math.max(width, scene.name().length());
    }
    for (Scene scene : Scenes.all()) {
      String gap = " ".repeat(width - scene.name().length() + 2);
      out.println(scene.name() + gap + scene.shows());
    }
    out.flush();
  }
}
