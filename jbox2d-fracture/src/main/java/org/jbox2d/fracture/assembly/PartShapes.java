package org.jbox2d.fracture.assembly;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.hertelmehlhorn.ConvexDecomposition;
import org.jbox2d.fracture.hertelmehlhorn.ConvexParts;

/** Makes the convex shapes of which an outline consists. Owns workspaces that are used again. */
public final class PartShapes {
  /**
   * Vertices nearer than this many slops become one. The engine's polygons merge what is nearer
   * than half a slop; a little above that, so that rounding to floats does not bring vertices under
   * it.
   */
  private static final double RESOLUTION_IN_SLOPS = 0.501;

  /**
   * Radius of the parts of pieces, in slops. Neighbouring pieces share their edges, so their skins
   * overlap: with a skin of half a slop they overlap by one slop, which is just what a resting
   * contact keeps. They touch when born, and nothing pushes them apart.
   */
  public static final float PIECE_SKIN_IN_SLOPS = 0.5f;

  private final ConvexDecomposition decomposition = new ConvexDecomposition();

  /** What a shape is set to, which copies it. */
  private Vec2[] vertices = new Vec2[0];

  /**
   * Returns the convex parts of an outline.
   *
   * @param skin radius of the parts, m
   * @throws IllegalArgumentException if there are none that the engine accepts; the message says
   *     why
   */
  public Shape[] of(Outline outline, float skin) {
    ConvexDecomposition.Result result =
        decomposition.decompose(outline, Settings.maxPolygonVertices, resolution());
    if (result.status() != ConvexDecomposition.Status.DECOMPOSED) {
      throw new IllegalArgumentException(result.status() + ": " + result.reason());
    }
    ConvexParts parts = result.parts();
    Shape[] shapes = new Shape[parts.count()];
    for (int p = 0; p < shapes.length; p++) {
      shapes[p] = shapeOf(parts, p, skin);
    }
    return shapes;
  }

  /** Returns the distance below which vertices become one, m. */
  static double resolution() {
    return RESOLUTION_IN_SLOPS * Settings.linearSlop;
  }

  private PolygonShape shapeOf(ConvexParts parts, int p, float skin) {
    int size = parts.size(p);
    if (vertices.length < size) {
      vertices = new Vec2[size];
      for (int i = 0; i < size; i++) {
        vertices[i] = new Vec2();
      }
    }
    for (int i = 0; i < size; i++) {
      vertices[i].set((float) parts.x(p, i), (float) parts.y(p, i));
    }
    PolygonShape shape = new PolygonShape();
    shape.set(vertices, size);
    shape.m_radius = skin;
    return shape;
  }

  /** Returns the area of a shape, m^2. */
  static double area(Shape shape) {
    MassData data = new MassData();
    shape.computeMass(data, 1f);
    return data.mass;
  }

  /** Returns the sum of the areas of shapes, m^2. */
  static double area(Shape[] shapes) {
    double sum = 0;
    for (Shape shape : shapes) {
      sum += area(shape);
    }
    return sum;
  }
}
