package org.jbox2d.benchmarks.engines;

import java.util.ArrayList;
import java.util.List;

/**
 * How hard a solver works, and how often.
 *
 * @param level 0 to 3: each doubles the iterations, or the substeps
 * @param hz steps per second
 */
public record Setting(int level, int hz) {
  /** What the comparison is made at: 8/3 iterations or 4 substeps, and 60 Hz. */
  public static final Setting STANDARD = new Setting(1, 60);

  private static final int LEVELS = 4;
  private static final int[] POSITION = {2, 3, 6, 12};
  private static final int[] RATES = {30, 60, 120, 240};

  /** All settings of the sweep. */
  public static List<Setting> all() {
    List<Setting> result = new ArrayList<>();
    for (int level = 0; level < LEVELS; level++) {
      for (int hz : RATES) {
        result.add(new Setting(level, hz));
      }
    }
    return result;
  }

  /** Velocity iterations of an iterating solver. */
  public int velocityIterations() {
    return 4 << level;
  }

  /** Position iterations of an iterating solver. */
  public int positionIterations() {
    return POSITION[level];
  }

  /** Substeps of a substepping solver. */
  public int substeps() {
    return 2 << level;
  }

  /** Least substeps of an adaptive solver. */
  public int leastSubsteps() {
    return 1 << level;
  }

  /** Greatest number of substeps of an adaptive solver. */
  public int mostSubsteps() {
    return 16 << level;
  }
}
