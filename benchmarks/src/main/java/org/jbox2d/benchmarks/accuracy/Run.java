package org.jbox2d.benchmarks.accuracy;

/** A scene under way: what it does and sees at each step, and how wrong it was in the end. */
@FunctionalInterface
public interface Run {
  /** Acts before a step that starts at a time, s. */
  default void before(double time) {}

  /** Looks after a step of a length, s, that ended at a time. It must not change the world. */
  default void after(double time, double dt) {}

  /** The error at the end: relative, zero for the truth. */
  double error(double time);
}
