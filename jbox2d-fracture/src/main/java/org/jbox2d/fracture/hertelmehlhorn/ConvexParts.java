package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Rings;

/** Convex polygons, each a counter-clockwise list of vertices. */
public final class ConvexParts {
  private final double[] xy;
  private final int[] start;

  ConvexParts(double[] xy, int[] start) {
    this.xy = xy;
    this.start = start;
  }

  /** Number of parts. */
  public int count() {
    return start.length - 1;
  }

  /** Number of vertices of all parts. */
  int vertexCount() {
    return start[start.length - 1];
  }

  /** Number of vertices of part p. */
  public int size(int p) {
    return start[p + 1] - start[p];
  }

  /** x of vertex i of part p. */
  public double x(int p, int i) {
    return xy[2 * (start[p] + i)];
  }

  /** y of vertex i of part p. */
  public double y(int p, int i) {
    return xy[2 * (start[p] + i) + 1];
  }

  /** Area of part p. */
  public double area(int p) {
    return Rings.signedArea(xy, start[p], start[p + 1]);
  }

  /** Sum of the areas. */
  public double totalArea() {
    double sum = 0;
    for (int p = 0; p < count(); p++) {
      sum += area(p);
    }
    return sum;
  }

  /** Interleaved coordinates of part p; a copy. */
  public double[] coordinates(int p) {
    return Arrays.copyOfRange(xy, 2 * start[p], 2 * start[p + 1]);
  }
}
