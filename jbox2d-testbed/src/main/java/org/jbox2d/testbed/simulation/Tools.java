package org.jbox2d.testbed.simulation;

import static org.jbox2d.testbed.parameters.Parameter.Group.TOOLS;

import java.util.List;
import org.jbox2d.testbed.parameters.Parameter;

/** Parameters of what the user throws and sets off. */
final class Tools {
  static final Parameter SHOT_SPEED =
      Parameter.real(TOOLS, "shot-speed", "m/s", 1, 200, 80, "Speed of a disc that is thrown.");
  static final Parameter SHOT_RADIUS =
      Parameter.real(TOOLS, "shot-radius", "m", 0.1, 5, 0.8, "Radius of a disc that is thrown.");
  static final Parameter SHOT_DENSITY =
      Parameter.real(
          TOOLS, "shot-density", "kg/m^2", 0.1, 100, 5, "Density of a disc that is thrown.");
  static final Parameter BLAST_RADIUS =
      Parameter.real(TOOLS, "blast-radius", "m", 1, 60, 12, "How far an explosion reaches.");
  static final Parameter BLAST_IMPULSE =
      Parameter.real(
          TOOLS,
          "blast-impulse",
          "N s/m",
          0,
          2000,
          150,
          "Impulse of an explosion on a metre of surface, 1 m from it.");

  static final List<Parameter> ALL =
      List.of(SHOT_SPEED, SHOT_RADIUS, SHOT_DENSITY, BLAST_RADIUS, BLAST_IMPULSE);

  private Tools() {}
}
