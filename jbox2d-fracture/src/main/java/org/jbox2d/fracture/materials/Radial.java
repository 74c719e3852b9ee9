package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;
import org.jbox2d.fracture.geometry.Angles;

/**
 * Glass hit hard: straight cracks run out from the contact, and rings of cracks join them, the
 * closer the nearer to it.
 *
 * <p>The sites lie on n rays, on each at the same radii {@code rho_k}. Two sites of the same radius
 * have a bisector through the contact: a spoke. Two neighbours on a ray have one across the ray at
 * {@code (rho_k + rho_(k+1)) / 2}: a chord of a ring. With
 *
 * <pre>
 *   n = 2 pi r / s,   q = 1 + 2 pi / n,   R_k = r / q^k,   rho_k = 2 R_k / (1 + q)
 * </pre>
 *
 * (r {@link #m_radius}, s {@link #m_shattering}, ring k = 0, 1, .. inwards) the pieces are s wide
 * at the edge of the region that breaks away, the outermost ring; they are about as long as wide,
 * as both grow in proportion to the distance from the contact; and the rings end where the pieces
 * are an eighth of that. Rays and rings are moved by up to {@link #NOISE} of a half distance, a
 * whole ray or ring at a time, so that the spokes stay straight. Beyond the outermost ring there is
 * one more ring of sites: its cells reach outwards without end and mostly stay.
 *
 * <p>That the two kinds of cracks appear in this way in glass plates struck by a projectile, more
 * spokes at a harder blow: N. Vandenberghe, R. Vermorel and E. Villermaux, "Star-shaped crack
 * pattern of broken windows", Physical Review Letters 110 (2013) 174302. The formulas are our own.
 */
public class Radial extends Material {
  private static final int LEAST_SPOKES = 5;
  private static final int MOST_SPOKES = 24;

  /** The innermost ring's radius in units of the outermost one's, at most. */
  private static final double INNERMOST = 1.0 / 8;

  /** More rings than this do not show, as their pieces are merged. */
  private static final int MOST_RINGS = 9;

  /** How far rays and rings are moved, in units of the distance of neighbours, either way. */
  private static final double NOISE = 0.2;

  /** Shattering 1.5, radius 4, else the default values of {@link Material}. */
  public Radial() {
    m_shattering = 1.5f;
    m_radius = 4f;
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    double wanted = 2 * Math.PI * m_radius / m_shattering;
    int spokes = (int) Math.max(LEAST_SPOKES, Math.min(MOST_SPOKES, Math.rint(wanted)));
    double ratio = 1 + 2 * Math.PI / spokes;
    double[] angles = angles(spokes, random);
    double[] radii = radii(ratio, random);
    Vec2[] sites = new Vec2[spokes * radii.length];
    for (int i = 0; i < spokes; i++) {
      double x = Angles.cos(angles[i]);
      double y = Angles.sin(angles[i]);
      for (int k = 0; k < radii.length; k++) {
        sites[i * radii.length + k] =
            new Vec2(
                contactPoint.x + (float) (x * radii[k]), contactPoint.y + (float) (y * radii[k]));
      }
    }
    return sites;
  }

  private static double[] angles(int spokes, SiteRandom random) {
    double pitch = 2 * Math.PI / spokes;
    double turn = random.unit();
    double[] angles = new double[spokes];
    for (int i = 0; i < spokes; i++) {
      angles[i] = pitch * (i + turn + 2 * NOISE * random.centred());
    }
    return angles;
  }

  /**
   * Radii of the sites, outwards. All but the two outermost are moved: the ring between those two
   * is the region's edge.
   */
  private double[] radii(double ratio, SiteRandom random) {
    int rings = 2 + (int) Math.ceil(StrictMath.log(1 / INNERMOST) / StrictMath.log(ratio));
    double[] radii = new double[Math.min(MOST_RINGS, rings)];
    double radius = 2 * m_radius * ratio / (1 + ratio);
    for (int k = radii.length - 1; k >= 0; k--) {
      double noise = k < radii.length - 2 ? 2 * NOISE * (ratio - 1) * random.centred() : 0;
      radii[k] = radius * (1 + noise);
      radius /= ratio;
    }
    return radii;
  }
}
