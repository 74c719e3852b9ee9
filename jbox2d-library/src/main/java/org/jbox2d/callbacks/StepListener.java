package org.jbox2d.callbacks;

import org.jbox2d.dynamics.World;

/** Hears when a step has ended. */
@FunctionalInterface
public interface StepListener {
  /**
   * A step has ended: the world is no longer locked, and deferred work is done. Bodies may be made
   * and destroyed.
   *
   * @param world the world that was stepped
   * @param dt length of the step, s
   */
  void stepped(World world, float dt);
}
