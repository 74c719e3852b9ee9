package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;
import org.jbox2d.fracture.geometry.Angles;

/**
 * Sites in logarithmic polar coordinates around the contact, the denser the nearer, stretched along
 * the impact (thesis, section 7.2.2):
 *
 * <pre>
 *   angle = 2 pi p(),  rad = -ln(r()) s,  v_i = T (sin(angle) rad, cos(angle) rad c)
 * </pre>
 *
 * T turns +y to the impact vector and moves to the contact. For an impact vector of zero nothing is
 * stretched.
 */
public class Diffusion extends Material {
  private static final int SITES = 128;

  /** c: how far the sites are stretched along the impact. */
  private static final float STRETCH = 4f;

  /** The default values of {@link Material}. */
  public Diffusion() {}

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    float speed = contactVector.length();
    float ux = speed > 0f ? contactVector.x / speed : 0f;
    float uy = speed > 0f ? contactVector.y / speed : 1f;
    float stretch = speed > 0f ? STRETCH : 1f;
    Vec2[] sites = new Vec2[SITES];
    double[] direction = new double[2];
    for (int i = 0; i < SITES; i++) {
      Angles.direction(2 * Math.PI * random.centred(), direction);
      double radius = -Angles.log(random.positiveUnit()) * m_shattering;
      float across = (float) (direction[1] * radius);
      float along = (float) (direction[0] * radius) * stretch;
      sites[i] =
          new Vec2(
              contactPoint.x + across * uy + along * ux, contactPoint.y - across * ux + along * uy);
    }
    return sites;
  }
}
