package org.jbox2d.collision;

import org.jbox2d.common.Vec2;

/** Result of {@link Distance}. */
public class DistanceOutput {

  /** Closest point of A, in world coordinates. */
  public final Vec2 pointA = new Vec2();

  /** Closest point of B, in world coordinates. */
  public final Vec2 pointB = new Vec2();

  /** Distance in metres, zero if the shapes overlap. */
  public float distance;

  /** Support steps that were needed, at most {@link Distance#MAX_ITERS}. */
  public int iterations;

  public DistanceOutput() {}
}
