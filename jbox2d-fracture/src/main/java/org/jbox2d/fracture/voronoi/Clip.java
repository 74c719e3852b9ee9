package org.jbox2d.fracture.voronoi;

/** The rectangle a diagram is clipped to. */
final class Clip {
  /**
   * Where an edge leaves the rectangle this close to one of its ends, in units of the rectangle's
   * extent, it ends there: rounding of the intersection, a few units in the last place, must not
   * give an edge of its own.
   */
  private static final double SAME_POINT = 0x1p-46;

  double minX;
  double minY;
  double maxX;
  double maxY;

  /** Distance below which points near the border are one. */
  double samePoint;

  /**
   * Takes up a rectangle.
   *
   * @throws IllegalArgumentException if it is empty or not finite
   */
  void set(double left, double low, double right, double high) {
    if (!(left < right && low < high && (right - left) * 0 == 0 && (high - low) * 0 == 0)) {
      throw new IllegalArgumentException(
          "rectangle is empty: (" + left + ", " + low + ") to (" + right + ", " + high + ")");
    }
    minX = left;
    minY = low;
    maxX = right;
    maxY = high;
    samePoint = SAME_POINT * Math.max(maxX - minX, maxY - minY);
    middleX = 0.5 * (minX + maxX);
    middleY = 0.5 * (minY + maxY);
    halfWidth = 0.5 * (maxX - minX);
    halfHeight = 0.5 * (maxY - minY);
    double far =
        Math.max(
            Math.max(Math.abs(minX), Math.abs(maxX)), Math.max(Math.abs(minY), Math.abs(maxY)));
    nearBorder = 2 * samePoint + 4 * Math.ulp(far);
  }

  private double middleX;
  private double middleY;
  private double halfWidth;
  private double halfHeight;

  /** What is nearer to the border than twice {@link #samePoint} is so by this much at most. */
  private double nearBorder;

  boolean contains(double x, double y) {
    return x >= minX && x <= maxX && y >= minY && y <= maxY;
  }

  /** x, or that of a vertical side as good as there: so that no edge is too short to leave. */
  double ontoBorderX(double x) {
    return Math.abs(Math.abs(x - middleX) - halfWidth) <= nearBorder
        ? ontoBorder(x, minX, maxX)
        : x;
  }

  /** y, or that of a horizontal side as good as there. */
  double ontoBorderY(double y) {
    return Math.abs(Math.abs(y - middleY) - halfHeight) <= nearBorder
        ? ontoBorder(y, minY, maxY)
        : y;
  }

  private double ontoBorder(double value, double low, double high) {
    if (Math.abs(value - low) <= 2 * samePoint) {
      return low;
    }
    return Math.abs(value - high) <= 2 * samePoint ? high : value;
  }

  /** x of corner c; they count from the lower left one counter-clockwise. */
  double cornerX(int c) {
    return c == 0 || c == 3 ? minX : maxX;
  }

  double cornerY(int c) {
    return c < 2 ? minY : maxY;
  }

  /**
   * Position of a point of the border, counter-clockwise from the lower left corner, a side
   * counting 1.
   */
  double position(double x, double y) {
    double fx = (x - minX) / (maxX - minX);
    double fy = (y - minY) / (maxY - minY);
    if (y == minY) {
      return fx;
    }
    if (x == maxX) {
      return 1 + fy;
    }
    if (y == maxY) {
      return 3 - fx;
    }
    return 4 - fy;
  }
}
