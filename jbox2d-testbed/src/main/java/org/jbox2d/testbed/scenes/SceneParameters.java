package org.jbox2d.testbed.scenes;

import org.jbox2d.testbed.parameters.Parameter;

/** Parameters that several scenes have. */
final class SceneParameters {
  /** The engine moves nothing farther than 2 m in a step: at 60 Hz that is this speed, m/s. */
  private static final double FASTEST = 120;

  private SceneParameters() {}

  static Parameter real(
      String name, String unit, double least, double most, double initial, String doc) {
    return Parameter.real(Parameter.Group.SCENE, name, unit, least, most, initial, doc);
  }

  static Parameter whole(String name, int least, int most, int initial, String doc) {
    return Parameter.whole(Parameter.Group.SCENE, name, least, most, initial, doc);
  }

  /** The speed of what is thrown. */
  static Parameter speed(double initial) {
    return real("speed", "m/s", 1, FASTEST, initial, "Speed of what is thrown.");
  }

  /** The density of what is thrown. */
  static Parameter density(double initial) {
    return real("density", "kg/m^2", 0.1, 50, initial, "Density of what is thrown.");
  }
}
