package org.jbox2d.dynamics;

import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;

/**
 * How thin a body is and how far it reaches, by which the continuous phase tells whether it moves
 * fast.
 *
 * <p>The thickness is the least distance from a shape's centre to its surface, over all fixtures:
 * the radius of a circle, the distance from centroid to nearest side of a polygon, the skin of a
 * segment. The reach is the distance from the centre of mass to the farthest point of the surface.
 */
final class BodyExtents {
  private BodyExtents() {}

  /** Computes {@link Body#thickness} and {@link Body#reach}. */
  static void compute(Body b) {
    float thickness = Float.MAX_VALUE;
    float reach = 0f;
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      thickness = Math.min(thickness, thickness(f.m_shape));
      reach = Math.max(reach, reach(f.m_shape, b.m_sweep.localCenter) + f.m_shape.m_radius);
    }
    b.thickness = thickness;
    b.reach = reach;
  }

  private static float thickness(Shape shape) {
    if (!(shape instanceof PolygonShape)) {
      return shape.m_radius;
    }
    PolygonShape polygon = (PolygonShape) shape;
    Vec2 centre = polygon.m_centroid;
    float least = Float.MAX_VALUE;
    for (int i = 0; i < polygon.m_count; i++) {
      Vec2 n = polygon.m_normals[i];
      Vec2 v = polygon.m_vertices[i];
      least = Math.min(least, n.x * (v.x - centre.x) + n.y * (v.y - centre.y));
    }
    return least + polygon.m_radius;
  }

  private static float reach(Shape shape, Vec2 from) {
    switch (shape.getType()) {
      case CIRCLE:
        return distance(((CircleShape) shape).m_p, from);
      case POLYGON:
        PolygonShape polygon = (PolygonShape) shape;
        return reach(polygon.m_vertices, polygon.m_count, from);
      case CHAIN:
        ChainShape chain = (ChainShape) shape;
        return reach(chain.m_vertices, chain.m_count, from);
      default:
        EdgeShape edge = (EdgeShape) shape;
        return Math.max(distance(edge.m_vertex1, from), distance(edge.m_vertex2, from));
    }
  }

  private static float reach(Vec2[] vertices, int count, Vec2 from) {
    float most = 0f;
    for (int i = 0; i < count; i++) {
      most = Math.max(most, distance(vertices[i], from));
    }
    return most;
  }

  private static float distance(Vec2 p, Vec2 q) {
    float dx = p.x - q.x;
    float dy = p.y - q.y;
    return (float) Math.sqrt(dx * dx + dy * dy);
  }
}
