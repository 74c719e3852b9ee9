package org.jbox2d.testbed.simulation;

import org.jbox2d.testbed.parameters.Values;
import org.jbox2d.testbed.scenes.Scene;

/**
 * All that a run begins with; the same setup and the same inputs give the same run, to the bit.
 *
 * @param scene what is built
 * @param hz steps per second, positive
 * @param seed seed of the fractures
 * @param values parameters that differ from their defaults
 */
public record Setup(Scene scene, float hz, long seed, Values values) {
  /** Checks the rate. */
  public Setup {
    if (!(hz > 0f) || Float.isInfinite(hz)) {
      throw new IllegalArgumentException("hz must be positive and finite, is " + hz);
    }
  }

  /** A scene as it is meant. */
  public static Setup of(Scene scene, long seed) {
    return new Setup(scene, scene.hz(), seed, Values.NONE);
  }

  /** Returns this setup with one value set. */
  public Setup with(String parameter, double value) {
    return new Setup(scene, hz, seed, values.with(parameter, value));
  }
}
