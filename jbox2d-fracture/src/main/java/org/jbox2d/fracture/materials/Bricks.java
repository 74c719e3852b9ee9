package org.jbox2d.fracture.materials;

import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Material;

/**
 * Masonry: bricks in a running bond, each course moved by half a brick against the one below. The
 * bond is fixed in the body, with a corner of a brick at the body's origin; as pieces keep the
 * frame of the body they come from, what remains goes on in the same bond.
 *
 * <p>A brick is {@link #m_shattering} long, and that over the {@link #setSlenderness slenderness}
 * high. Brick j of course i covers {@code j s + (i mod 2) s/2 <= x < (j + 1) s + (i mod 2) s/2},
 * {@code i h <= y < (i + 1) h}, {@code h = s / e}, in a frame turned by {@link #setAngle the
 * angle}. It has two sites, in the middles of its halves.
 */
public class Bricks extends Material {
  private static final int COLUMNS_PER_BRICK = 2;
  private static final float DEFAULT_SLENDERNESS = 2f;

  /** The bond: a brick is two columns; every other course begins a column later. */
  private static final Courses.Bond RUNNING =
      new Courses.Bond() {
        @Override
        public double middle(int course) {
          return course + 0.5;
        }

        @Override
        public int first(int course, int column) {
          int shift = course & 1;
          return Math.floorDiv(column - shift, COLUMNS_PER_BRICK) * COLUMNS_PER_BRICK + shift;
        }

        @Override
        public int next(int course, int column) {
          return column + COLUMNS_PER_BRICK;
        }
      };

  private float angle;
  private float slenderness = DEFAULT_SLENDERNESS;

  /** Bricks of 1 m x 0.5 m along the body's x axis; else the default values of {@link Material}. */
  public Bricks() {
    m_shattering = 1f;
  }

  /** Returns the angle of the courses to the body's x axis, rad. */
  public float getAngle() {
    return angle;
  }

  /**
   * Sets the angle of the courses to the body's x axis, rad; 0 by default.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public void setAngle(float angle) {
    this.angle = Limits.angle(angle);
  }

  /** Returns the length of a brick in units of its height. */
  public float getSlenderness() {
    return slenderness;
  }

  /**
   * Sets the length of a brick in units of its height; 2 by default.
   *
   * @throws IllegalArgumentException if it is not between 1 and 100
   */
  public void setSlenderness(float slenderness) {
    this.slenderness = Limits.slenderness(slenderness);
  }

  @Override
  public Vec2[] focee(Vec2 contactPoint, Vec2 contactVector) {
    double width = (double) m_shattering / COLUMNS_PER_BRICK;
    double height = (double) m_shattering / slenderness;
    return new Courses(angle, new Vec2(), width, height)
        .around(contactPoint, contactVector, m_radius, RUNNING);
  }
}
