package org.jbox2d.benchmarks;

import com.sun.management.ThreadMXBean;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.scenes.SceneSpec;
import org.jbox2d.benchmarks.scenes.SteppedScene;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Compares the steps of engines and solvers, in one run: {@code java -cp
 * benchmarks/target/benchmarks.jar org.jbox2d.benchmarks.Ratios [scene...]}.
 *
 * <p>All step the same scene in turns of a few steps, so that what else the machine does hits all
 * alike. A figure is the median of the processor time that the thread used for a step; garbage
 * collection, which runs on other threads, is not in it.
 */
@Command(
    name = "ratios",
    mixinStandardHelpOptions = true,
    description = "Thread time of a step, ms, and in brackets how many times JBox2D's speed.")
public final class Ratios implements Callable<Integer> {
  /** Steps of one engine before it is the other's turn. */
  private static final int TURN = 4;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  @Option(names = "--solver", split = ",", description = "Labels of solvers; all if left out.")
  private List<String> solvers = new ArrayList<>();

  @Parameters(description = "Scenes; all if left out.")
  private List<String> scenes = new ArrayList<>();

  private Ratios() {}

  /** Runs the scenes named, or all. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new Ratios()).execute(args));
  }

  @Override
  public Integer call() {
    List<SceneSpec> specs =
        scenes.isEmpty()
            ? List.of(SceneSpec.values())
            : scenes.stream().map(SceneSpec::of).toList();
    List<Contender> chosen = Contender.chosen(solvers);
    PrintStream out = System.out;
    out.print("| scene (bodies) |");
    for (Contender solver : chosen) {
      out.print(" " + solver.label + " |" + (solver.ours ? " B/step |" : ""));
    }
    out.print("\n|---|");
    for (Contender solver : chosen) {
      out.print(solver.ours ? "--:|--:|" : "--:|");
    }
    out.println();
    for (SceneSpec spec : specs) {
      List<Lane> lanes = chosen.stream().map(solver -> new Lane(solver, spec)).toList();
      run(spec, lanes);
      out.println(row(spec, lanes));
      lanes.forEach(lane -> lane.scene.close());
    }
    return 0;
  }

  private static void run(SceneSpec spec, List<Lane> lanes) {
    for (int done = 0; done < spec.warmSteps; done += TURN) {
      for (Lane lane : lanes) {
        lane.warm(Math.min(TURN, spec.warmSteps - done));
      }
    }
    for (int done = 0; done < spec.measuredSteps; done += TURN) {
      for (Lane lane : lanes) {
        lane.measure(Math.min(TURN, spec.measuredSteps - done));
      }
    }
  }

  private static String row(SceneSpec spec, List<Lane> lanes) {
    double original = Double.NaN;
    for (Lane lane : lanes) {
      original = lane.solver == Contender.JBOX2D ? lane.median() : original;
    }
    StringBuilder row = new StringBuilder("| ").append(spec.label);
    row.append(" (").append(lanes.get(0).scene.bodyCount()).append(") |");
    for (Lane lane : lanes) {
      double own = lane.median();
      row.append(String.format(Locale.ROOT, " %.3f (%.2f) |", own, original / own));
      if (lane.solver.ours) {
        row.append(' ').append(lane.allocated / spec.measuredSteps).append(" |");
      }
    }
    return row.toString();
  }

  /** One engine's run of a scene. */
  private static final class Lane {
    final Contender solver;
    final SteppedScene scene;
    final long[] nanos;
    int measured;
    long allocated;

    Lane(Contender solver, SceneSpec spec) {
      this.solver = solver;
      scene = spec.build(solver);
      nanos = new long[spec.measuredSteps];
    }

    void warm(int steps) {
      for (int i = 0; i < steps; i++) {
        scene.step();
      }
    }

    void measure(int steps) {
      for (int i = 0; i < steps; i++) {
        long bytes = THREADS.getCurrentThreadAllocatedBytes();
        long start = THREADS.getCurrentThreadCpuTime();
        scene.step();
        nanos[measured++] = THREADS.getCurrentThreadCpuTime() - start;
        allocated += THREADS.getCurrentThreadAllocatedBytes() - bytes;
      }
    }

    double median() {
      long[] sorted = Arrays.copyOf(nanos, measured);
      Arrays.sort(sorted);
      return sorted[measured / 2] * 1e-6;
    }
  }
}
