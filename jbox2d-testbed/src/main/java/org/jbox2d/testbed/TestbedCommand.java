package org.jbox2d.testbed;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jbox2d.testbed.headless.HeadlessRunner;
import org.jbox2d.testbed.headless.RunRequest;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;
import org.jbox2d.testbed.recording.Divergence;
import org.jbox2d.testbed.recording.RecordingException;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.SolverChoice;
import org.jbox2d.testbed.ui.Screenshots;
import org.jbox2d.testbed.ui.TestbedWindow;
import org.jbox2d.testbed.ui.WindowSettings;
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
          + " --csv, --gif, --hash, --profile, --record, --replay), runs a scene and reports."
    },
    exitCodeListHeading = "Exit codes:%n",
    exitCodeList = {
      "0:done",
      "1:a file could not be read or written",
      "2:the command line is wrong",
      "3:a replay went another way than its recording"
    })
final class TestbedCommand implements Callable<Integer> {
  private static final int DEFAULT_STEPS = 600;
  private static final int MAX_STEPS = 100_000_000;
  private static final int DIVERGED = 3;
  private static final Path DEFAULT_PNG = Path.of("jbox2d-testbed.png");

  @Spec private CommandSpec spec;

  @Option(names = "--headless", description = "Open no window.")
  private boolean headless;

  @Option(names = "--list", description = "Print the scenes and what they show.")
  private boolean list;

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "The scene; if not given, main, or in the window the last one.")
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
      description = "Seed of the fractures; 1 if not given.")
  private Long seed;

  @Option(
      names = "--solver",
      paramLabel = "NAME",
      description = "How contacts and joints are solved; the same as --set solver=NAME.")
  private String solver;

  @Option(
      names = "--set",
      paramLabel = "NAME=VALUE",
      description = "Set a parameter of scene, material, solver or tools; --parameters lists them.")
  private List<String> settings = new ArrayList<>();

  @Option(
      names = "--parameters",
      description = "Print the parameters of the scene: range, unit, default, meaning.")
  private boolean parameters;

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description = "Write what is needed to repeat the run, and hashes to check it by.")
  private Path record;

  @Option(
      names = "--replay",
      paramLabel = "FILE",
      description = "Repeat a recording and compare each step; the first that differs is told.")
  private Path replay;

  @Option(
      names = "--screenshots",
      paramLabel = "DIR",
      description = "Write pictures of the window in five scenes; needs a display.")
  private Path screenshots;

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
    // Asked for first: a run without a window tells AWT that there is no display, for good.
    boolean noDisplay = GraphicsEnvironment.isHeadless();
    if (list) {
      printScenes(out);
      return CommandLine.ExitCode.OK;
    }
    if (screenshots != null) {
      return writeScreenshots(out);
    }
    if (replay != null) {
      return replay(out);
    }
    Setup setup = setup();
    if (parameters) {
      ParameterTable.print(setup, out);
      return CommandLine.ExitCode.OK;
    }
    boolean asked = needsNoWindow();
    if (!noDisplay && !asked) {
      TestbedWindow.open(setup, WindowSettings.ofUser());
      return CommandLine.ExitCode.OK;
    }
    RunRequest request = request(setup, asked ? png : DEFAULT_PNG);
    if (!asked) {
      out.println("No display: running scene '" + setup.scene().name() + "' without a window.");
      out.flush();
    }
    return runHeadless(request, out);
  }

  private int writeScreenshots(PrintWriter out) {
    if (GraphicsEnvironment.isHeadless()) {
      throw wrong("--screenshots needs a display; xvfb-run gives a virtual one");
    }
    try {
      Screenshots.write(screenshots);
    } catch (IOException e) {
      spec.commandLine().getErr().println("could not write: " + e.getMessage());
      return CommandLine.ExitCode.SOFTWARE;
    }
    out.println("screenshots written to " + screenshots.toAbsolutePath().normalize());
    out.flush();
    return CommandLine.ExitCode.OK;
  }

  private boolean needsNoWindow() {
    return headless
        || hash
        || profile
        || steps != null
        || record != null
        || png != null
        || csv != null
        || gif != null;
  }

  private int replay(PrintWriter out) {
    if (sceneName != null || hz != null || seed != null || steps != null || solver != null) {
      throw wrong(
          "--replay takes scene, rate, seed, solver and steps from the recording; leave --scene,"
              + " --hz, --seed, --solver and --steps out");
    }
    if (!settings.isEmpty()) {
      throw wrong("--replay takes all parameters from the recording; leave --set out");
    }
    if (!Files.isRegularFile(replay)) {
      throw wrong("--replay must be a file that --record has written, is " + replay);
    }
    return runHeadless(request(null, png), out);
  }

  private RunRequest request(Setup setup, Path picture) {
    return new RunRequest(
        setup,
        steps(),
        replay,
        writable("--record", record),
        writable("--png", picture),
        writable("--csv", csv),
        writable("--gif", gif),
        profile,
        hash);
  }

  private int runHeadless(RunRequest request, PrintWriter out) {
    System.setProperty("java.awt.headless", "true");
    PrintWriter err = spec.commandLine().getErr();
    try {
      Divergence divergence = HeadlessRunner.run(request, out, err);
      if (divergence != null) {
        err.println(request.replay() + ": " + divergence);
        return DIVERGED;
      }
      return CommandLine.ExitCode.OK;
    } catch (RecordingException e) {
      err.println("could not read: " + e.getMessage());
      return CommandLine.ExitCode.SOFTWARE;
    } catch (IOException e) {
      err.println("could not read or write: " + e.getMessage());
      return CommandLine.ExitCode.SOFTWARE;
    }
  }

  /** What the command line asks for, checked by building it. */
  private Setup setup() {
    Scene scene = scene();
    Setup setup = new Setup(scene, hz(scene), seed == null ? 1 : seed, Values.NONE);
    List<String> all = new ArrayList<>(settings);
    if (solver != null) {
      all.add(SolverChoice.PARAMETER.name() + "=" + solver);
    }
    Simulation built = new Simulation(setup);
    for (String setting : all) {
      int equals = setting.indexOf('=');
      if (equals < 1) {
        throw wrong("--set must be NAME=VALUE such as rigidity=20, is " + setting);
      }
      try {
        Parameter parameter = built.parameter(setting.substring(0, equals));
        setup = setup.with(parameter.name(), parameter.parse(setting.substring(equals + 1)));
      } catch (IllegalArgumentException e) {
        throw wrong(e.getMessage());
      }
    }
    return setup;
  }

  private Scene scene() {
    if (sceneName == null) {
      boolean window = !GraphicsEnvironment.isHeadless() && !needsNoWindow() && !parameters;
      // A window opens where it was left; a run without one must not depend on that.
      return window && settings.isEmpty() ? WindowSettings.ofUser().scene() : Scenes.first();
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
