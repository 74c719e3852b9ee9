package org.jbox2d.fracture;

import java.util.Arrays;
import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.OutlineDefect;
import org.jbox2d.fracture.geometry.Rings;

/**
 * A simple polygon, convex or concave, given by its vertices in order, in either orientation. It
 * grows by {@link #add}; nothing is checked before {@link #validate}.
 *
 * <p>Vertices are kept by reference, as they were added; change none after the polygon has been
 * used.
 */
public class Polygon {
  private Vec2[] vertices;
  private int count;

  /** Creates a polygon without vertices. */
  public Polygon() {
    vertices = new Vec2[8];
  }

  /**
   * Creates a polygon of the given vertices.
   *
   * @throws IllegalArgumentException if the array or one of its elements is null
   */
  public Polygon(Vec2[] vertices) {
    if (vertices == null) {
      throw new IllegalArgumentException("vertices are null");
    }
    this.vertices = new Vec2[Math.max(vertices.length, 4)];
    for (Vec2 vertex : vertices) {
      add(vertex);
    }
  }

  /**
   * Appends a vertex.
   *
   * @throws IllegalArgumentException if it is null
   */
  public final void add(Vec2 vertex) {
    if (vertex == null) {
      throw new IllegalArgumentException("vertex " + count + " is null");
    }
    if (count == vertices.length) {
      vertices = Arrays.copyOf(vertices, 2 * count);
    }
    vertices[count++] = vertex;
  }

  /**
   * Vertex i, not a copy.
   *
   * @throws IndexOutOfBoundsException if i is not between 0 and {@link #size} - 1
   */
  public final Vec2 get(int i) {
    if (i < 0 || i >= count) {
      throw new IndexOutOfBoundsException("vertex " + i + " of " + count);
    }
    return vertices[i];
  }

  /** Number of vertices. */
  public final int size() {
    return count;
  }

  /** Area, not negative, in square metres. */
  public final double area() {
    return Math.abs(signedArea());
  }

  /** Whether the vertices run clockwise (y up); false for a polygon without area. */
  public final boolean isClockwise() {
    return signedArea() < 0;
  }

  private double signedArea() {
    return Rings.signedArea(coordinates(), 0, count);
  }

  /**
   * Centroid.
   *
   * @throws IllegalArgumentException if the polygon has no area
   */
  public final Vec2 centroid() {
    double[] moments = moments();
    return new Vec2((float) moments[1], (float) moments[2]);
  }

  /**
   * Second moment of area about the centroid, in m^4; times density it is the moment of inertia.
   *
   * @throws IllegalArgumentException if the polygon has no area
   */
  public final double secondMoment() {
    return moments()[3];
  }

  /**
   * Area, centroid and second moment about it. With a the cross product of the two ends p, q of an
   * edge relative to the first vertex: area = sum a/2, first moment = sum a (p + q)/6, second
   * moment = sum a (p.p + p.q + q.q)/12 (Green's theorem); then the second moment is moved to the
   * centroid by the parallel-axis theorem.
   */
  private double[] moments() {
    double twiceArea = 0;
    double sx = 0;
    double sy = 0;
    double second = 0;
    double ox = count == 0 ? 0 : vertices[0].x;
    double oy = count == 0 ? 0 : vertices[0].y;
    for (int i = 1; i + 1 < count; i++) {
      double px = vertices[i].x - ox;
      double py = vertices[i].y - oy;
      double qx = vertices[i + 1].x - ox;
      double qy = vertices[i + 1].y - oy;
      double cross = px * qy - py * qx;
      twiceArea += cross;
      sx += cross * (px + qx) / 6;
      sy += cross * (py + qy) / 6;
      second += cross * (px * (px + qx) + qx * qx + py * (py + qy) + qy * qy) / 12;
    }
    if (!(twiceArea != 0)) {
      throw new IllegalArgumentException("polygon of " + count + " vertices has no area");
    }
    double area = twiceArea / 2;
    double cx = sx / area;
    double cy = sy / area;
    double aboutCentroid = Math.abs(second - area * (cx * cx + cy * cy));
    return new double[] {Math.abs(area), ox + cx, oy + cy, aboutCentroid};
  }

  /**
   * Checks that this is a simple polygon: at least three vertices, all finite, none repeated, edges
   * that neither cross nor touch except neighbours in their common vertex, and an area. Either
   * orientation is fine, and so are collinear vertices.
   *
   * @throws IllegalArgumentException if not; the message names the vertex and what is wrong with it
   */
  public final void validate() {
    OutlineCheck check = OutlineCheck.of(outline());
    if (check.defect() != OutlineDefect.NONE) {
      throw new IllegalArgumentException(
          "polygon of " + count + " vertices is not valid: " + check.message());
    }
  }

  /**
   * The same polygon with vertices in counter-clockwise order, beginning with the same one; its
   * vertices are copies.
   */
  public final Polygon normalised() {
    Polygon copy = new Polygon();
    boolean reverse = isClockwise();
    for (int i = 0; i < count; i++) {
      Vec2 vertex = vertices[reverse && i > 0 ? count - i : i];
      copy.add(new Vec2(vertex.x, vertex.y));
    }
    return copy;
  }

  /** This polygon as an outline without holes. */
  final Outline outline() {
    return Outline.of(coordinates());
  }

  private double[] coordinates() {
    double[] xy = new double[2 * count];
    for (int i = 0; i < count; i++) {
      xy[2 * i] = vertices[i].x;
      xy[2 * i + 1] = vertices[i].y;
    }
    return xy;
  }
}
