package org.jbox2d.testbed.simulation;

import static org.jbox2d.testbed.parameters.Parameter.Group.SOLVER;

import java.util.List;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.testbed.parameters.Parameter;

/** The choice of how contacts and joints are solved. */
public final class SolverChoice {
  /** The parameter by which a solver is chosen. */
  public static final Parameter PARAMETER =
      Parameter.choice(
          SOLVER,
          "solver",
          List.of("sequential-impulses", "soft-step", "adaptive"),
          0,
          "How contacts and joints are solved.");

  private static final int SOFT_STEP = PARAMETER.choices().indexOf("soft-step");
  private static final int ADAPTIVE = PARAMETER.choices().indexOf("adaptive");

  private static final Parameter SUBSTEPS =
      Parameter.whole(
          SOLVER, "substeps", 1, 32, Solver.DEFAULT_SUBSTEPS, "Those of the soft step.");

  private SolverChoice() {}

  static List<Knob> knobs() {
    return List.of(
        new Knob(
            PARAMETER,
            (run, value) -> run.world().setSolver(solver((int) value, run.value(SUBSTEPS)))),
        new Knob(
            SUBSTEPS,
            (run, value) -> run.world().setSolver(solver((int) run.value(PARAMETER), value))));
  }

  private static Solver solver(int choice, double substeps) {
    if (choice == SOFT_STEP) {
      return Solver.softStep((int) substeps);
    }
    return choice == ADAPTIVE ? Solver.adaptive() : Solver.sequentialImpulses();
  }
}
