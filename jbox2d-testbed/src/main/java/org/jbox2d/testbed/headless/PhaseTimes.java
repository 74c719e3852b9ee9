package org.jbox2d.testbed.headless;

import java.io.PrintWriter;
import java.util.Locale;
import org.jbox2d.dynamics.Profile;
import org.jbox2d.dynamics.ProfileTimes;

/** How long the phases of a step took, on average and at most. */
final class PhaseTimes {
  private static final String[] NAMES = {
    "step", "collide", "solve", "solveInit", "solveVelocity", "solvePosition", "broadphase", "TOI"
  };

  private final double[] sum = new double[NAMES.length];
  private final double[] most = new double[NAMES.length];
  private int steps;

  /** Takes the last step's times. */
  void add(Profile profile) {
    ProfileTimes t = profile;
    steps++;
    add(0, t.step);
    add(1, t.collide);
    add(2, t.solve);
    add(3, t.solveInit);
    add(4, t.solveVelocity);
    add(5, t.solvePosition);
    add(6, t.broadphase);
    add(7, t.solveTOI);
  }

  private void add(int phase, float millis) {
    sum[phase] += millis;
    most[phase] = Math.max(most[phase], millis);
  }

  void print(PrintWriter out) {
    for (int i = 0; i < NAMES.length; i++) {
      double mean = steps > 0 ? sum[i] / steps : 0;
      out.printf(Locale.ROOT, "  %-14s mean %8.4f ms, most %8.4f ms%n", NAMES[i], mean, most[i]);
    }
  }
}
