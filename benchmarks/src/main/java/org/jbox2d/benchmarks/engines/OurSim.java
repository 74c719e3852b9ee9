package org.jbox2d.benchmarks.engines;

import org.jbox2d.benchmarks.engines.box2d.Box2dSim;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;

/** A world of this project. */
public final class OurSim extends Box2dSim {
  /** A world that is solved by sequential impulses. */
  public OurSim(int velocityIterations, int positionIterations) {
    super(velocityIterations, positionIterations);
  }

  /** A world with another solver, whose settings are its own. */
  public OurSim(Solver solver) {
    super(Setting.STANDARD.velocityIterations(), Setting.STANDARD.positionIterations());
    world.setSolver(solver);
  }

  /** The world, for what other engines do not have. */
  public World world() {
    return world;
  }
}
