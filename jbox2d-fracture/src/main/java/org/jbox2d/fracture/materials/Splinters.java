package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.SiteRandom;

/**
 * Wood: long splinters along a grain whose direction is fixed in the body.
 *
 * <p>A splinter is about {@link #m_shattering} long, between a half and three halves of it, and
 * that over the {@link #setSlenderness slenderness} broad, give or take a third. Strips lie side by
 * side across the grain, their middles at {@code (i + c p()) s / e}; a strip breaks across at
 * {@code (j + p() / 2) s} in steps of {@code s / 4}; p() is uniform in (-1/2, 1/2) and c = 1/3. So
 * the ends of neighbours do not lie side by side. Why cells of one site each would not do: Voronoi
 * cells of sites in neighbouring rows that are not opposite each other lie askew to the grain;
 * {@link Courses} unites cells.
 */
public class Splinters extends Material {
  private static final int COLUMNS = 4;
  private static final float DEFAULT_SLENDERNESS = 8f;

  /**
   * c: how far the middle of a strip is moved, in units of the mean breadth, both ways together.
   */
  private static final double NOISE = 1.0 / 3;

  private float angle;
  private float slenderness = DEFAULT_SLENDERNESS;

  /**
   * Splinters of 2 m x 0.25 m along the body's x axis; else the default values of {@link Material}.
   */
  public Splinters() {
    m_shattering = 2f;
  }

  /** Returns the angle of the grain to the body's x axis, rad. */
  public float getAngle() {
    return angle;
  }

  /**
   * Sets the angle of the grain to the body's x axis, rad; 0 by default.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public void setAngle(float angle) {
    this.angle = Limits.angle(angle);
  }

  /** Returns the length of a splinter in units of its breadth. */
  public float getSlenderness() {
    return slenderness;
  }

  /**
   * Sets the length of a splinter in units of its breadth; 8 by default.
   *
   * @throws IllegalArgumentException if it is not between 1 and 100
   */
  public void setSlenderness(float slenderness) {
    this.slenderness = Limits.slenderness(slenderness);
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    return focee(contactPoint, contactVector, randomOf(contactPoint, contactVector));
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector, SiteRandom random) {
    double width = (double) m_shattering / COLUMNS;
    double height = (double) m_shattering / slenderness;
    return new Courses(angle, contactPoint, width, height)
        .around(contactPoint, contactVector, m_radius, new Grain(random.nextLong()));
  }

  /** Strips of random breadth, broken at random places: functions of their numbers and a seed. */
  private static final class Grain implements Courses.Bond {
    private final long seed;

    Grain(long seed) {
      this.seed = seed;
    }

    private SiteRandom random(int course, int splinter) {
      return new SiteRandom(SiteRandom.mix(seed, SiteRandom.mix(course, splinter)));
    }

    @Override
    public double middle(int course) {
      return course + NOISE * random(course, Integer.MIN_VALUE).centred();
    }

    private int end(int course, int splinter) {
      return COLUMNS * splinter
          + (int) Math.rint(0.5 * COLUMNS * random(course, splinter).centred());
    }

    @Override
    public int first(int course, int column) {
      int splinter = Math.floorDiv(column, COLUMNS) + 1;
      while (end(course, splinter) > column) {
        splinter--;
      }
      return end(course, splinter);
    }

    @Override
    public int next(int course, int column) {
      int splinter = Math.floorDiv(column, COLUMNS) - 1;
      while (end(course, splinter) <= column) {
        splinter++;
      }
      return end(course, splinter);
    }
  }
}
