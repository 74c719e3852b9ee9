package org.jbox2d.dynamics;

/**
 * The times of the last step in milliseconds, under the names that release 2.2.1.1 of JBox2D gave
 * them in {@code Profile}.
 */
public class ProfileTimes {
  /** The whole step. */
  public float step;

  /** Narrow phase and contact events. */
  public float collide;

  /** Everything that solves. */
  public float solve;

  /** Building islands and constraints. */
  public float solveInit;

  /** Velocity iterations. */
  public float solveVelocity;

  /** Position iterations. */
  public float solvePosition;

  /** Broad phase. */
  public float broadphase;

  /** Continuous collision. */
  public float solveTOI;

  /** All 0. */
  protected ProfileTimes() {}
}
