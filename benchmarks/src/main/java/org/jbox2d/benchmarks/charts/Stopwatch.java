package org.jbox2d.benchmarks.charts;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.function.IntSupplier;

/**
 * Times tasks against each other. They take turns, so that what else the machine does hits all
 * alike; a figure is the median over the turns of the processor time the thread used. Garbage
 * collection, which runs on other threads, is not in it.
 */
final class Stopwatch {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final long warmNanos;
  private final long turnNanos;
  private final int turns;

  /** Sum of all the tasks returned: kept, or the compiler might drop their work. */
  private volatile int sink;

  /**
   * Creates a stopwatch.
   *
   * @param warmNanos time each task runs before it is measured
   * @param turnNanos time of a turn: a task shorter than that runs several times in one
   * @param turns number of turns, one or more
   */
  Stopwatch(long warmNanos, long turnNanos, int turns) {
    this.warmNanos = warmNanos;
    this.turnNanos = turnNanos;
    this.turns = turns;
  }

  /** Microseconds of one run of each task. */
  double[] microseconds(IntSupplier... tasks) {
    int[] runs = new int[tasks.length];
    for (int t = 0; t < tasks.length; t++) {
      runs[t] = warm(tasks[t]);
    }
    double[][] samples = new double[tasks.length][turns];
    for (int turn = 0; turn < turns; turn++) {
      for (int t = 0; t < tasks.length; t++) {
        samples[t][turn] = 1e-3 * turn(tasks[t], runs[t]) / runs[t];
      }
    }
    double[] medians = new double[tasks.length];
    for (int t = 0; t < tasks.length; t++) {
      Arrays.sort(samples[t]);
      medians[t] = samples[t][turns / 2];
    }
    return medians;
  }

  /** Runs a task until it is warm; returns the number of runs that fill a turn. */
  private int warm(IntSupplier task) {
    int runs = 1;
    long total = 0;
    while (true) {
      long spent = turn(task, runs);
      total += spent;
      if (spent < turnNanos) {
        runs *= 2;
      } else if (total >= warmNanos) {
        return runs;
      } else if (spent > 2 * turnNanos && runs > 1) {
        runs /= 2;
      }
    }
  }

  private long turn(IntSupplier task, int runs) {
    long start = THREADS.getCurrentThreadCpuTime();
    int sum = sink;
    for (int r = 0; r < runs; r++) {
      sum += task.getAsInt();
    }
    sink = sum;
    return THREADS.getCurrentThreadCpuTime() - start;
  }
}
