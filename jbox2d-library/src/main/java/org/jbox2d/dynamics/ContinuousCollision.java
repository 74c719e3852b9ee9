package org.jbox2d.dynamics;

import org.jbox2d.dynamics.solver.StepConfig;

/** Keeps fast bodies from passing through others within a step. */
final class ContinuousCollision {
  private final World world;

  ContinuousCollision(World world) {
    this.world = world;
  }

  void solve(StepConfig step) {}
}
