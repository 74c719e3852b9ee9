package org.jbox2d.testbed.scenes;

/** What a scene does besides being stepped, such as rain that falls; holds the state of one run. */
@FunctionalInterface
public interface Script {
  /** Does nothing. */
  Script NONE = step -> {};

  /**
   * Acts on the world before a step.
   *
   * @param step number of steps done so far
   */
  void before(int step);
}
