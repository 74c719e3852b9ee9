package org.jbox2d.testbed.simulation;

import org.jbox2d.dynamics.Profile;
import org.jbox2d.dynamics.ProfileTimes;

/**
 * How long the phases of a step took, ms.
 *
 * @param step the whole, with the scene's script
 * @param collide narrow phase
 * @param solve contacts and joints
 * @param broadphase broad phase
 * @param continuous continuous collision
 */
public record Phases(
    double step, double collide, double solve, double broadphase, double continuous) {

  static Phases of(Profile profile, double step) {
    ProfileTimes t = profile;
    return new Phases(step, t.collide, t.solve, t.broadphase, t.solveTOI);
  }

  /** Returns what is left: fractures, and the scene's script. */
  public double breaking() {
    return Math.max(0, step - collide - solve - broadphase - continuous);
  }
}
