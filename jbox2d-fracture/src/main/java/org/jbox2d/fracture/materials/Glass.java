package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;
import org.jbox2d.fracture.geometry.Angles;

/**
 * Sites on circles around the contact, with a little noise (thesis, section 7.2.3): {@code rad_i =
 * i s + p() s c}, i = 1..n, at random angles.
 */
public class Glass extends Material {
  private static final int CIRCLES = 4;
  private static final int SITES_PER_CIRCLE = 30;

  /** c: noise of the radius in units of the shattering. */
  private static final float NOISE = 1f / 20f;

  /** Shattering 1, radius 4, else the default values of {@link Material}. */
  public Glass() {
    m_shattering = 1f;
    m_radius = 4f;
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    Vec2[] sites = new Vec2[CIRCLES * SITES_PER_CIRCLE];
    double[] direction = new double[2];
    for (int i = 0; i < sites.length; i++) {
      int circle = 1 + i / SITES_PER_CIRCLE;
      Angles.direction(2 * Math.PI * random.centred(), direction);
      double radius = circle * m_shattering + random.centred() * m_shattering * NOISE;
      sites[i] =
          new Vec2(
              contactPoint.x + (float) (direction[1] * radius),
              contactPoint.y + (float) (direction[0] * radius));
    }
    return sites;
  }
}
