package org.jbox2d.collision;

import org.jbox2d.common.Vec2;

/** A ray from {@link #p1} to {@code p1 + maxFraction (p2 - p1)}. */
public class RayCastInput {

  public final Vec2 p1 = new Vec2();
  public final Vec2 p2 = new Vec2();
  public float maxFraction;

  public RayCastInput() {}

  public void set(RayCastInput rci) {
    p1.set(rci.p1);
    p2.set(rci.p2);
    maxFraction = rci.maxFraction;
  }
}
