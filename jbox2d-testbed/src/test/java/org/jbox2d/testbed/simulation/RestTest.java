package org.jbox2d.testbed.simulation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;

/**
 * What has been broken comes to rest: heaps of hundreds of splinters, of which one or two always
 * creep, fall asleep all the same.
 */
class RestTest {
  private static final List<String> SCENES =
      List.of("main", "cube", "circle", "rotated-body", "static-body");

  /** Before, in these scenes, there may be something yet to break, s. */
  private static final double EARLIEST = 8;

  private static final double LATEST = 30;

  /** A ball may roll on for as long as it likes. */
  private static final double ASLEEP = 0.95;

  /** Of the runs; in one or another a piece rocks on an edge, which nothing in the model damps. */
  private static final int MOST_AWAKE = 2;

  @Test
  void fragmentsFallAsleep() {
    List<String> awake = new ArrayList<>();
    for (String scene : SCENES) {
      for (int solver = 0; solver < SolverChoice.PARAMETER.choices().size(); solver++) {
        Setup setup = Setup.of(Scenes.named(scene), 1).with(SolverChoice.PARAMETER.name(), solver);
        Simulation run = new Simulation(setup);
        while (run.time() < EARLIEST || (run.time() < LATEST && asleep(run) < ASLEEP)) {
          run.step();
        }
        assertTrue(run.fractureCount() > 0, scene);
        if (asleep(run) < ASLEEP) {
          awake.add(scene + " " + SolverChoice.PARAMETER.choices().get(solver));
        }
      }
    }
    assertTrue(awake.size() <= MOST_AWAKE, awake.toString());
  }

  /**
   * A substep that followed a blow forgot the impulses of all contacts of an island in which there
   * was a joint; so a heap in which two hinges lay trembled for ever, in each of eight runs.
   */
  @Test
  void heapsInWhichHingesLieFallAsleep() {
    List<String> awake = new ArrayList<>();
    for (int seed = 1; seed <= 2; seed++) {
      for (int solver = 1; solver < SolverChoice.PARAMETER.choices().size(); solver++) {
        Setup setup =
            Setup.of(Scenes.named("rain-on-roofs"), seed)
                .with(SolverChoice.PARAMETER.name(), solver);
        Simulation run = new Simulation(setup);
        while (run.time() < EARLIEST || (run.time() < LATEST && asleep(run) < ASLEEP)) {
          run.step();
        }
        assertTrue(run.world().getJointCount() > 0);
        if (asleep(run) < ASLEEP) {
          awake.add(SolverChoice.PARAMETER.choices().get(solver) + " " + seed);
        }
      }
    }
    assertTrue(awake.size() <= 1, awake.toString());
  }

  private static double asleep(Simulation run) {
    int bodies = 0;
    int asleep = 0;
    for (Body b = run.world().getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() == BodyType.DYNAMIC) {
        bodies++;
        asleep += b.isAwake() ? 0 : 1;
      }
    }
    return (double) asleep / bodies;
  }
}
