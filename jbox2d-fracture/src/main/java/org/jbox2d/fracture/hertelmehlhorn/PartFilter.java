package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Rings;

/**
 * Takes from convex parts what an engine would not tell apart: vertices nearer than the resolution
 * to an earlier one, and vertices that hardly stick out. A part without area, or with fewer than
 * three vertices left, is dropped. Area that is lost by that is made up for by stretching all parts
 * together.
 */
final class PartFilter {
  /**
   * A vertex must stick out over the chord of its neighbours by this share of the part's reach (its
   * extent plus its distance from the origin): twice what the engine asks for, which is four units
   * in the last place of a float.
   */
  static final double FLATNESS = 8 * 0x1p-23;

  private final Stretch stretch = new Stretch();
  private double[] ring = new double[32];
  private double[] out = new double[64];
  private int size;

  /**
   * The parts that are left.
   *
   * @param area what they are to have together
   */
  ConvexParts filter(ConvexParts parts, double resolution, double area) {
    int[] starts = new int[parts.count() + 1];
    int count = 0;
    int total = 0;
    for (int p = 0; p < parts.count(); p++) {
      take(parts, p, resolution);
      dropFlat();
      if (size >= 3 && Rings.signedArea(ring, 0, size) > 0) {
        if (out.length < 2 * (total + size)) {
          out = Arrays.copyOf(out, 4 * (total + size));
        }
        System.arraycopy(ring, 0, out, 2 * total, 2 * size);
        total += size;
        starts[++count] = total;
      }
    }
    ConvexParts left =
        count == parts.count() && total == parts.vertexCount()
            ? parts
            : new ConvexParts(Arrays.copyOf(out, 2 * total), Arrays.copyOf(starts, count + 1));
    double farthest = OutlineSimplifier.FARTHEST * resolution;
    if (!stretch.choose(out, total, left.totalArea(), area, farthest) || stretch.growth() < 0) {
      return left;
    }
    stretch.apply(out, total);
    return new ConvexParts(Arrays.copyOf(out, 2 * total), Arrays.copyOf(starts, count + 1));
  }

  private void take(ConvexParts parts, int p, double resolution) {
    int n = parts.size(p);
    if (ring.length < 2 * n) {
      ring = new double[4 * n];
    }
    size = 0;
    for (int i = 0; i < n; i++) {
      double x = parts.x(p, i);
      double y = parts.y(p, i);
      boolean near = false;
      for (int k = 0; k < size && !near; k++) {
        double dx = x - ring[2 * k];
        double dy = y - ring[2 * k + 1];
        near = dx * dx + dy * dy < resolution * resolution;
      }
      if (!near) {
        ring[2 * size] = x;
        ring[2 * size + 1] = y;
        size++;
      }
    }
  }

  private void dropFlat() {
    double tolerance = FLATNESS * reach();
    while (size >= 3) {
      int flattest = 0;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < size; i++) {
        double height = height(i);
        if (height < least) {
          least = height;
          flattest = i;
        }
      }
      if (least > tolerance) {
        return;
      }
      System.arraycopy(ring, 2 * flattest + 2, ring, 2 * flattest, 2 * (size - flattest - 1));
      size--;
    }
  }

  private double reach() {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      minX = Math.min(minX, ring[2 * i]);
      maxX = Math.max(maxX, ring[2 * i]);
      minY = Math.min(minY, ring[2 * i + 1]);
      maxY = Math.max(maxY, ring[2 * i + 1]);
    }
    double offset = Math.max(Math.max(-minX, maxX), Math.max(-minY, maxY));
    return Math.max(maxX - minX, maxY - minY) + offset;
  }

  private double height(int i) {
    int before = i == 0 ? size - 1 : i - 1;
    int after = i == size - 1 ? 0 : i + 1;
    double ux = ring[2 * i] - ring[2 * before];
    double uy = ring[2 * i + 1] - ring[2 * before + 1];
    double vx = ring[2 * after] - ring[2 * before];
    double vy = ring[2 * after + 1] - ring[2 * before + 1];
    return (ux * vy - uy * vx) / Math.sqrt(vx * vx + vy * vy);
  }
}
