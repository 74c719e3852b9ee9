package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;

/**
 * Sites spread evenly over a square around the contact (thesis, section 7.2.1): {@code v_i = (p(),
 * p()) s sqrt(k) + d} with k sites, p() uniform in (-1/2, 1/2).
 *
 * <p>The thesis' text gives a side of {@code s sqrt(k)}, its code 100 sites over a side of {@code
 * 2.5 s}: the shattering that scenes give is that of the code. Both are the same formula with the
 * site distance {@code s / 4}, which is what is used here.
 */
public class Uniform extends Material {
  /** Number of sites. */
  private static final int SITES = 100;

  /** Mean distance of neighbouring sites in units of the shattering. */
  private static final float SPACING = 0.25f;

  /** The default values of {@link Material}. */
  public Uniform() {}

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    float side = SPACING * m_shattering * (float) Math.sqrt(SITES);
    Vec2[] sites = new Vec2[SITES];
    for (int i = 0; i < SITES; i++) {
      float x = random.centred() * side;
      float y = random.centred() * side;
      sites[i] = new Vec2(contactPoint.x + x, contactPoint.y + y);
    }
    return sites;
  }
}
