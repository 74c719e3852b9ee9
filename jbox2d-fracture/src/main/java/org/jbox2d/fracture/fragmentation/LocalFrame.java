package org.jbox2d.fracture.fragmentation;

import org.jbox2d.fracture.geometry.Outline;

/**
 * Coordinates in which an outline is broken: the origin is the middle of its bounding box, the unit
 * a power of two not below its extent. So tolerances are relative to the outline, however small,
 * large or far from the origin it is.
 */
final class LocalFrame {
  /**
   * Least distance of two points, in the local unit: far above the rounding of constructed points
   * (a few 2^-52), far below what a float of the same magnitude can show (2^-24).
   */
  private static final double LEAST_SNAP = 0x1p-36;

  /**
   * Points of the result must stay apart when they are rounded in the input's coordinates: so many
   * units in the last place.
   */
  private static final double SNAP_ULPS = 8;

  private double originX;
  private double originY;
  private double scale;

  /** The local unit in that of the input: 1 / scale, which is exact for a power of two. */
  private double unit;

  private double snap;
  private double minX;
  private double minY;
  private double maxX;
  private double maxY;

  void choose(Outline outline) {
    minX = Double.POSITIVE_INFINITY;
    minY = Double.POSITIVE_INFINITY;
    maxX = Double.NEGATIVE_INFINITY;
    maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < outline.vertexCount(); i++) {
      minX = Math.min(minX, outline.x(i));
      maxX = Math.max(maxX, outline.x(i));
      minY = Math.min(minY, outline.y(i));
      maxY = Math.max(maxY, outline.y(i));
    }
    double extent = Math.max(maxX - minX, maxY - minY);
    // A float has few enough digits that most differences to it are exact.
    originX = (float) (0.5 * (minX + maxX));
    originY = (float) (0.5 * (minY + maxY));
    unit = Math.scalb(1.0, Math.getExponent(extent) + 1);
    scale = 1 / unit;
    double far =
        Math.max(
            Math.max(Math.abs(minX), Math.abs(maxX)), Math.max(Math.abs(minY), Math.abs(maxY)));
    snap = Math.max(LEAST_SNAP, SNAP_ULPS * Math.ulp(far) * scale);
    minX = toLocalX(minX);
    maxX = toLocalX(maxX);
    minY = toLocalY(minY);
    maxY = toLocalY(maxY);
  }

  double toLocalX(double x) {
    return (x - originX) * scale;
  }

  double toLocalY(double y) {
    return (y - originY) * scale;
  }

  double toInputX(double x) {
    return x * unit + originX;
  }

  double toInputY(double y) {
    return y * unit + originY;
  }

  /** Local units to a unit of the input. */
  double scale() {
    return scale;
  }

  /** The local unit in that of the input. */
  double unit() {
    return unit;
  }

  /** Distance, in the local unit, below which points are one. */
  double snap() {
    return snap;
  }

  /** Left end of the outline, in local coordinates. */
  double minX() {
    return minX;
  }

  double minY() {
    return minY;
  }

  double maxX() {
    return maxX;
  }

  double maxY() {
    return maxY;
  }
}
