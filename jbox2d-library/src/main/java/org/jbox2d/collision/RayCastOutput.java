package org.jbox2d.collision;

import org.jbox2d.common.Vec2;

/**
 * A ray hits at {@code p1 + fraction (p2 - p1)}, where the surface has the unit normal {@link
 * #normal}.
 */
public class RayCastOutput {

  public final Vec2 normal = new Vec2();
  public float fraction;

  public RayCastOutput() {}

  public void set(RayCastOutput rco) {
    normal.set(rco.normal);
    fraction = rco.fraction;
  }
}
