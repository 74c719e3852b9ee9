package org.jbox2d.common;

/** A stop watch for profiles; the simulation never reads it. */
public class Timer {

  private long startNanos;

  /** Starts the watch. */
  public Timer() {
    reset();
  }

  /** Starts the watch again from 0. */
  public void reset() {
    startNanos = System.nanoTime();
  }

  /** Milliseconds since the start. */
  public float getMilliseconds() {
    return (System.nanoTime() - startNanos) * 1e-6f;
  }
}
