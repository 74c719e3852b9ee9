package org.jbox2d.testbed.simulation;

import static org.jbox2d.testbed.parameters.Parameter.Group.SOLVER;

import java.util.List;
import org.jbox2d.testbed.parameters.Parameter;

/** The choice of how contacts and joints are solved. */
public final class SolverChoice {
  /** The parameter by which a solver is chosen. */
  public static final Parameter PARAMETER =
      Parameter.choice(
          SOLVER,
          "solver",
          List.of("sequential-impulses"),
          0,
          "How contacts and joints are solved.");

  private SolverChoice() {}

  static List<Knob> knobs() {
    return List.of(new Knob(PARAMETER, (run, value) -> {}));
  }
}
