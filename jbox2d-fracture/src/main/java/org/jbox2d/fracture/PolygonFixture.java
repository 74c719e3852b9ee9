package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.CompoundShape;
import org.jbox2d.fracture.assembly.PartShapes;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.OutlineDefect;

/**
 * A simple polygon, convex or concave, with or without holes, as a shape of a body: {@code
 * body.createFixture(def, polygonFixture)} makes a fixture of each convex part; they remember that
 * they belong together and break as one.
 */
public class PolygonFixture extends Polygon implements CompoundShape {
  private final Outline outline;
  private Shape[] parts;

  /**
   * A polygon of the given vertices, in either orientation. They are copied.
   *
   * @throws IllegalArgumentException if it is not a simple polygon; the message says why
   */
  public PolygonFixture(Vec2[] vertices) {
    this(vertices, new Vec2[0][]);
  }

  /** A copy of a polygon; as {@link #PolygonFixture(Vec2[])}. */
  public PolygonFixture(Polygon polygon) {
    this(verticesOf(polygon));
  }

  /**
   * A polygon with holes; rings in either orientation. They are copied.
   *
   * @throws IllegalArgumentException if a ring is not simple, or the holes do not lie apart inside
   *     the outer ring
   */
  public PolygonFixture(Vec2[] outer, Vec2[]... holes) {
    super(copyOf(outer));
    List<double[]> rings = new ArrayList<>();
    rings.add(coordinates(outer));
    for (Vec2[] hole : holes) {
      rings.add(coordinates(copyOf(hole)));
    }
    Outline given = Outline.ofRings(rings.toArray(new double[0][]));
    OutlineCheck check = OutlineCheck.of(given);
    if (check.defect() != OutlineDefect.NONE) {
      throw new IllegalArgumentException("polygon is not valid: " + check.message());
    }
    outline = given.normal();
  }

  private static Vec2[] verticesOf(Polygon polygon) {
    Vec2[] vertices = new Vec2[polygon.size()];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = polygon.get(i);
    }
    return vertices;
  }

  private static Vec2[] copyOf(Vec2[] vertices) {
    if (vertices == null) {
      throw new IllegalArgumentException("vertices are null");
    }
    Vec2[] copy = new Vec2[vertices.length];
    for (int i = 0; i < copy.length; i++) {
      if (vertices[i] == null) {
        throw new IllegalArgumentException("vertex " + i + " is null");
      }
      copy[i] = new Vec2(vertices[i].x, vertices[i].y);
    }
    return copy;
  }

  private static double[] coordinates(Vec2[] vertices) {
    double[] xy = new double[2 * vertices.length];
    for (int i = 0; i < vertices.length; i++) {
      xy[2 * i] = vertices[i].x;
      xy[2 * i + 1] = vertices[i].y;
    }
    return xy;
  }

  /** Engine-internal: the outline, counter-clockwise, holes clockwise. */
  public Outline normalOutline() {
    return outline;
  }

  /**
   * Returns the convex parts.
   *
   * @throws IllegalArgumentException if the polygon is too fine for the engine to have any part of
   *     it
   */
  @Override
  public Shape[] getParts() {
    if (parts == null) {
      parts = new PartShapes().of(outline, Settings.polygonRadius);
    }
    return parts.clone();
  }
}
