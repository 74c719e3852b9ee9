package org.jbox2d.fracture.materials;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.Site;

/**
 * Pieces that lie in courses, one beside the other: layers of bricks, strips of wood.
 *
 * <p>Sites lie on a grid, in columns along the course; cells of such a grid are rectangles,
 * whatever the distances of its rows and of its columns are. A piece is some neighbouring cells of
 * a course, so that the ends of pieces need not lie side by side in neighbouring courses:
 *
 * <pre>
 *   +-------+-------+----     Cells of one site each, the sites in the middle of a brick, would be
 *   |  .  . |  .  . |  .      hexagons or, for bricks twice as long as high, diamonds.
 *   +---+---+---+---+----
 *   | . |  .  . |  .  .
 *   +---+-------+--------
 * </pre>
 *
 * <p>Only as many pieces as the region of effect needs: a half disc of the material's radius behind
 * the contact and a half ellipse ahead, which reaches as far as the other body flies in {@link
 * #REACH_TIME}, but no further than {@link #MOST_REACH} radii. If that takes more than {@link
 * #MOST_SITES} sites the region shrinks. Pieces beside those that lie in it for the most part are
 * there too, so that those have their own shape.
 */
final class Courses {
  /** After so many sites no further course is begun. */
  static final int MOST_SITES = 256;

  /** The thesis' region reaches two steps ahead; as the step is not known, of 1/60 s. */
  private static final double REACH_TIME = 2.0 / 60;

  private static final double MOST_REACH = 3;

  /** Columns and courses beyond the region, to each side: enough for the longest piece. */
  private static final int RIM = 8;

  /** How the pieces are laid; columns and courses are counted from the origin. */
  interface Bond {
    /** Returns the middle of a course across the courses, in units of their mean height. */
    double middle(int course);

    /** Returns the first column of the piece in which a column of a course lies. */
    int first(int course, int column);

    /** Returns the first column of the next piece. */
    int next(int course, int column);
  }

  private final double originX;
  private final double originY;
  private final double cos;
  private final double sin;
  private final double columnWidth;
  private final double courseHeight;
  private double behind;
  private double ahead;

  /**
   * Courses in a frame of their own.
   *
   * @param angle of the courses to the body's x axis, rad
   * @param origin of the pattern, in the body's frame
   * @param columnWidth distance of sites along a course, m
   * @param courseHeight mean distance of courses, m
   */
  Courses(double angle, Vec2 origin, double columnWidth, double courseHeight) {
    originX = origin.x;
    originY = origin.y;
    cos = StrictMath.cos(angle);
    sin = StrictMath.sin(angle);
    this.columnWidth = columnWidth;
    this.courseHeight = courseHeight;
  }

  /** Returns the sites of the pieces that come into the region of effect. */
  Vec2[] around(Vec2 contact, Vec2 vector, double radius, Bond bond) {
    double speed = vector.length();
    behind = radius;
    ahead = Math.max(radius, Math.min(MOST_REACH * radius, speed * REACH_TIME));
    shrink();
    double x = along(contact.x - originX, contact.y - originY);
    double y = across(contact.x - originX, contact.y - originY);
    double ux = speed > 0 ? along(vector.x, vector.y) / speed : 0;
    double uy = speed > 0 ? across(vector.x, vector.y) / speed : 1;
    int columns = RIM + (int) Math.ceil(ahead / columnWidth);
    int courses = RIM + (int) Math.ceil(ahead / courseHeight);
    int column = (int) Math.floor(x / columnWidth);
    int course = (int) Math.floor(y / courseHeight);
    List<Vec2> sites = new ArrayList<>();
    int piece = 0;
    for (int i = 0; i <= 2 * courses && sites.size() < MOST_SITES; i++) {
      int row = (i & 1) == 0 ? course + i / 2 : course - (i + 1) / 2;
      int start = bond.first(row, column - columns);
      while (start <= column + columns) {
        int end = bond.next(row, start);
        double top = bond.middle(row) * courseHeight - y;
        if (comesIn(start * columnWidth - x, end * columnWidth - x, top, ux, uy)) {
          addPiece(sites, start, end, bond.middle(row) * courseHeight, piece++);
        }
        start = end;
      }
    }
    return sites.toArray(new Vec2[0]);
  }

  private void shrink() {
    double area = 0.5 * Math.PI * behind * (behind + ahead);
    double most = MOST_SITES * columnWidth * courseHeight;
    if (area > most) {
      double factor = Math.sqrt(most / area);
      behind *= factor;
      ahead *= factor;
    }
  }

  private double along(double x, double y) {
    return x * cos + y * sin;
  }

  private double across(double x, double y) {
    return y * cos - x * sin;
  }

  /**
   * Whether the axis of a piece, half as long again at both ends, comes into the region widened by
   * a course: then the piece or one beside it may lie in the region for the most part. Coordinates
   * are relative to the contact.
   */
  private boolean comesIn(double left, double right, double y, double ux, double uy) {
    double half = 0.5 * (right - left);
    double nearest = Math.max(left - half, Math.min(right + half, 0));
    return isIn(nearest, y, ux, uy) || isIn(left, y, ux, uy) || isIn(right, y, ux, uy);
  }

  private boolean isIn(double x, double y, double ux, double uy) {
    double forth = x * ux + y * uy;
    double aside = (x * uy - y * ux) / (behind + courseHeight);
    forth /= (forth > 0 ? ahead : behind) + courseHeight;
    return forth * forth + aside * aside <= 1;
  }

  private void addPiece(List<Vec2> sites, int start, int end, double y, int piece) {
    for (int column = start; column < end; column++) {
      double x = (column + 0.5) * columnWidth;
      sites.add(
          new Site(
              (float) (originX + x * cos - y * sin), (float) (originY + x * sin + y * cos), piece));
    }
  }
}
