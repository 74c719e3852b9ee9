package org.jbox2d.benchmarks;

import com.sun.management.ThreadMXBean;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import org.jbox2d.benchmarks.peers.Engine;

/**
 * Compares our step with that of the original engine, in one run: {@code java -cp
 * benchmarks/target/benchmarks.jar org.jbox2d.benchmarks.Ratios [scene...]}.
 *
 * <p>Both engines step the same scene in turns of a few steps, so that what else the machine does
 * hits both alike. A figure is the median of the processor time that the thread used for a step;
 * garbage collection, which runs on other threads, is not in it. For scenes in which it is fit to
 * compare, dyn4j runs along when {@code --dyn4j} is given.
 */
public final class Ratios {
  /** Steps of one engine before it is the other's turn. */
  private static final int TURN = 4;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private Ratios() {}

  /** Runs the scenes named, or all. */
  public static void main(String[] args) {
    boolean dyn4j = Arrays.asList(args).contains("--dyn4j");
    String[] names = Arrays.stream(args).filter(a -> !a.startsWith("--")).toArray(String[]::new);
    SceneSpec[] specs =
        names.length == 0
            ? SceneSpec.values()
            : Arrays.stream(names).map(SceneSpec::of).toArray(SceneSpec[]::new);
    PrintStream out = System.out;
    out.println(
        "| scene (bodies) | ours, ms | JBox2D 2.2.1.1, ms | ratio | ours, B/step |"
            + (dyn4j ? " dyn4j, ms | ratio |" : ""));
    out.println("|---|--:|--:|--:|--:|" + (dyn4j ? "--:|--:|" : ""));
    for (SceneSpec spec : specs) {
      Lane ours = new Lane(Engine.OURS, spec);
      Lane original = new Lane(Engine.JBOX2D, spec);
      Lane third = dyn4j && spec.bodiesAlone ? new Lane(Engine.DYN4J, spec) : null;
      run(spec, third == null ? new Lane[] {ours, original} : new Lane[] {ours, original, third});
      out.print(row(spec, ours, original));
      if (third != null) {
        out.printf(Locale.ROOT, " %.3f | %.2f |", third.median(), third.median() / ours.median());
      }
      out.println();
    }
  }

  private static void run(SceneSpec spec, Lane[] lanes) {
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

  private static String row(SceneSpec spec, Lane ours, Lane original) {
    return String.format(
        Locale.ROOT,
        "| %s (%d) | %.3f | %.3f | %.2f | %d |",
        spec.label,
        ours.scene.bodyCount(),
        ours.median(),
        original.median(),
        original.median() / ours.median(),
        ours.allocated / spec.measuredSteps);
  }

  /** One engine's run of a scene. */
  private static final class Lane {
    final SteppedScene scene;
    final long[] nanos;
    int measured;
    long allocated;

    Lane(Engine engine, SceneSpec spec) {
      scene = engine.build(spec.label);
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
