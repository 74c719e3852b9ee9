package org.jbox2d.fracture.geometry;

/**
 * A polygon with holes: rings of interleaved coordinates, the outer ring first. No ring repeats its
 * first vertex at its end.
 *
 * <p>An outline is <em>normal</em> if its outer ring runs counter-clockwise and its holes
 * clockwise, so that the interior is left of every edge. The arrays are shared, not copied: do not
 * change them.
 */
public final class Outline {
  private final double[] xy;
  private final int[] ringStart;

  /** Whether it has been found valid, and convex: of use to {@link OutlineCheck} alone. */
  boolean foundValid;

  boolean foundConvex;

  /**
   * Creates an outline.
   *
   * @param xy interleaved coordinates of all rings
   * @param ringStart index of the first vertex of each ring, and the number of vertices as its last
   *     element
   * @throws IllegalArgumentException if the ring starts do not ascend from 0 to the number of
   *     vertices
   */
  public Outline(double[] xy, int[] ringStart) {
    int rings = ringStart.length - 1;
    if (rings < 1 || ringStart[0] != 0 || 2 * ringStart[rings] > xy.length) {
      throw new IllegalArgumentException(
          "ring starts do not fit the " + xy.length / 2 + " vertices given");
    }
    for (int r = 0; r < rings; r++) {
      if (ringStart[r] > ringStart[r + 1]) {
        throw new IllegalArgumentException("ring " + r + " has a negative number of vertices");
      }
    }
    this.xy = xy;
    this.ringStart = ringStart;
  }

  /** An outline without holes. */
  public static Outline of(double... ring) {
    return new Outline(ring, new int[] {0, ring.length / 2});
  }

  /** An outline with holes; each argument is one ring of interleaved coordinates. */
  public static Outline ofRings(double[]... rings) {
    int[] start = new int[rings.length + 1];
    for (int r = 0; r < rings.length; r++) {
      start[r + 1] = start[r] + rings[r].length / 2;
    }
    double[] all = new double[2 * start[rings.length]];
    for (int r = 0; r < rings.length; r++) {
      System.arraycopy(rings[r], 0, all, 2 * start[r], 2 * (start[r + 1] - start[r]));
    }
    return new Outline(all, start);
  }

  /** Interleaved coordinates of all rings; not a copy. */
  public double[] coordinates() {
    return xy;
  }

  /** Starts of the rings, with the number of vertices as last element; not a copy. */
  public int[] ringStarts() {
    return ringStart;
  }

  /** Number of rings: one more than there are holes. */
  public int ringCount() {
    return ringStart.length - 1;
  }

  /** Number of vertices of all rings. */
  public int vertexCount() {
    return ringStart[ringStart.length - 1];
  }

  /** First vertex of ring r. */
  public int ringStart(int r) {
    return ringStart[r];
  }

  /** One past the last vertex of ring r. */
  public int ringEnd(int r) {
    return ringStart[r + 1];
  }

  /** x of vertex i. */
  public double x(int i) {
    return xy[2 * i];
  }

  /** y of vertex i. */
  public double y(int i) {
    return xy[2 * i + 1];
  }

  /** Area of the outer ring less the areas of the holes, whatever the orientations. */
  public double area() {
    double area = Math.abs(ringArea(0));
    for (int r = 1; r < ringCount(); r++) {
      area -= Math.abs(ringArea(r));
    }
    return area;
  }

  /** Signed area of ring r: positive if it runs counter-clockwise. */
  public double ringArea(int r) {
    return Rings.signedArea(xy, ringStart[r], ringStart[r + 1]);
  }

  /** Whether the interior is left of every edge. */
  public boolean isNormal() {
    for (int r = 0; r < ringCount(); r++) {
      if ((ringArea(r) > 0) != (r == 0)) {
        return false;
      }
    }
    return true;
  }

  /**
   * This outline if it is normal, else a copy whose wrong rings are reversed (their first vertex
   * stays first).
   */
  public Outline normal() {
    if (isNormal()) {
      return this;
    }
    double[] copy = xy.clone();
    for (int r = 0; r < ringCount(); r++) {
      if ((ringArea(r) > 0) != (r == 0)) {
        Rings.reverse(copy, ringStart[r] + 1, ringStart[r + 1]);
      }
    }
    return new Outline(copy, ringStart);
  }
}
