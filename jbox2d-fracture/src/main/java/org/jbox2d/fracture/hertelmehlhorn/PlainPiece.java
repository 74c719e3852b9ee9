package org.jbox2d.fracture.hertelmehlhorn;

import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Rings;

/**
 * Recognises outlines that are their only part as they are, which most pieces of a fracture are:
 * one counter-clockwise ring, strictly convex by so much that rounding to floats does not matter,
 * with nothing finer than the resolution. The part is the same, to the last bit, as without this
 * shortcut; what is near to a limit is left to that way.
 */
final class PlainPiece {
  /** Squares are compared with a margin of this share, far above their rounding. */
  private static final double CLEARLY = 1 + 1e-9;

  /** Share of what {@link Stretch} makes up for that the area may change by. */
  private static final double AREA_SHARE = 0.5;

  private double[] ring = new double[32];

  /** The outline as a part, rounded to floats, the last vertex first; or null. */
  ConvexParts of(Outline outline, int mostVertices, double resolution) {
    int n = outline.vertexCount();
    if (outline.ringCount() > 1 || n < 3 || n > mostVertices) {
      return null;
    }
    if (ring.length < 2 * n) {
      ring = new double[4 * n];
    }
    double tolerance = PartFilter.FLATNESS * take(outline, n);
    if (!turnsOnce(n, CLEARLY * tolerance * tolerance) || !isCoarse(n, resolution)) {
      return null;
    }
    double wanted = outline.ringArea(0);
    double change = Math.abs(Rings.signedArea(ring, 0, n) - wanted);
    if (!(change < AREA_SHARE * Stretch.AREA_TOLERANCE * wanted)) {
      return null;
    }
    double[] part = new double[2 * n];
    System.arraycopy(ring, 0, part, 0, 2 * n);
    return new ConvexParts(part, new int[] {0, n});
  }

  /** Rounds the vertices; returns the reach: their extent plus the distance from the origin. */
  private double take(Outline outline, int n) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      int from = i == 0 ? n - 1 : i - 1;
      double x = (float) outline.x(from);
      double y = (float) outline.y(from);
      ring[2 * i] = x;
      ring[2 * i + 1] = y;
      minX = Math.min(minX, x);
      minY = Math.min(minY, y);
      maxX = Math.max(maxX, x);
      maxY = Math.max(maxY, y);
    }
    double offset = Math.max(Math.max(-minX, maxX), Math.max(-minY, maxY));
    return Math.max(maxX - minX, maxY - minY) + offset;
  }

  /**
   * Whether each vertex sticks out to the right over the chord of its neighbours, by more than the
   * square root of a height, and the ring goes around once: only one edge goes up after one that
   * goes down. Infinite and other strange coordinates give false.
   */
  private boolean turnsOnce(int n, double squaredHeight) {
    double px = ring[2 * n - 2];
    double py = ring[2 * n - 1];
    double ux = px - ring[2 * n - 4];
    double uy = py - ring[2 * n - 3];
    boolean wasUp = uy > 0 | (uy == 0 & ux > 0);
    boolean sticksOut = true;
    int rises = 0;
    for (int i = 0; i < n; i++) {
      double qx = ring[2 * i];
      double qy = ring[2 * i + 1];
      double vx = qx - px;
      double vy = qy - py;
      double cross = ux * vy - uy * vx;
      double chordX = ux + vx;
      double chordY = uy + vy;
      double least = squaredHeight * (chordX * chordX + chordY * chordY);
      sticksOut &= cross > 0 & cross * cross > least;
      boolean up = vy > 0 | (vy == 0 & vx > 0);
      rises += up & !wasUp ? 1 : 0;
      wasUp = up;
      px = qx;
      py = qy;
      ux = vx;
      uy = vy;
    }
    return sticksOut & rises == 1;
  }

  /** Whether all vertices are farther from each other than the resolution. */
  private boolean isCoarse(int n, double resolution) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 1; i < n; i++) {
      double x = ring[2 * i];
      double y = ring[2 * i + 1];
      for (int k = 0; k < i; k++) {
        double dx = x - ring[2 * k];
        double dy = y - ring[2 * k + 1];
        nearest = Math.min(nearest, dx * dx + dy * dy);
      }
    }
    return nearest > resolution * resolution;
  }
}
