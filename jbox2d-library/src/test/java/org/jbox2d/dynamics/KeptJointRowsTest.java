package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.jbox2d.common.Settings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * While nothing changes that joints write into their rows of the solver, the rows are kept from
 * step to step, and the joints read their impulses there. A world that writes all rows in each step
 * goes the same way, bit by bit, whatever is done to joints and bodies.
 */
class KeptJointRowsTest {
  private static final int STEPS = 500;

  private final float slop = Settings.linearSlop;

  @AfterEach
  void restore() {
    Settings.linearSlop = slop;
  }

  static IntStream seeds() {
    return IntStream.rangeClosed(1, 40);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void writesAnewWhatHasChanged(int seed) {
    DisturbedJoints kept = new DisturbedJoints(seed);
    DisturbedJoints anew = new DisturbedJoints(seed);
    int same = 0;
    for (int i = 0; i < STEPS; i++) {
      if (i % 50 == 49) {
        Settings.linearSlop = slop * (1 + i % 3);
      }
      kept.disturb();
      anew.disturb();
      anew.exposeAll();
      anew.world.awake.changes++;
      int changes = kept.world.awake.changes;
      kept.step();
      anew.step();
      same += kept.world.awake.changes == changes ? 1 : 0;
      assertEquals(anew.hash(), kept.hash(), "step " + i);
    }
    assertEquals(anew.reactions(), kept.reactions());
    assertTrue(same > STEPS / 2, "rows may be kept in " + same + " steps");
  }
}
