package org.jbox2d.dynamics;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;

/**
 * Checks of what enters the engine. Each failure is an IllegalArgumentException that names the
 * value.
 */
final class Checks {
  private Checks() {}

  static void notNull(Object value, String name) {
    if (value == null) {
      throw new IllegalArgumentException(name + " is null");
    }
  }

  static void finite(float value, String name) {
    if (!Float.isFinite(value)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void finite(Vec2 value, String name) {
    notNull(value, name);
    if (!Float.isFinite(value.x) || !Float.isFinite(value.y)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void notNegative(float value, String name) {
    if (!(value >= 0f) || Float.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be finite and not negative, is " + value);
    }
  }

  /** Bounds may be infinite, which means that all lies within. */
  static void bounds(AABB value, String name) {
    notNull(value, name);
    float sum =
        Math.abs(value.lowerBound.x)
            + Math.abs(value.lowerBound.y)
            + Math.abs(value.upperBound.x)
            + Math.abs(value.upperBound.y);
    if (Float.isNaN(sum)) {
      throw new IllegalArgumentException(name + " must not be NaN, is " + value);
    }
  }

  /**
   * As {@link #shape}, of a part of a compound. Puts names together only when something is wrong: a
   * fracture makes dozens of parts, and to name their vertices would take longer than to make them.
   */
  static void part(Shape[] parts, int i) {
    if (!(parts[i] instanceof PolygonShape) || !isSound((PolygonShape) parts[i])) {
      shape(parts[i], "CompoundShape.getParts()[" + i + "]");
    }
  }

  private static boolean isSound(PolygonShape polygon) {
    Vec2[] vertices = polygon.m_vertices;
    int count = polygon.m_count;
    if (vertices == null || count < 3 || count > vertices.length) {
      return false;
    }
    boolean sound = polygon.m_radius >= 0f && polygon.m_radius <= Float.MAX_VALUE;
    for (int i = 0; i < count && sound; i++) {
      Vec2 v = vertices[i];
      sound = v != null && Float.isFinite(v.x) && Float.isFinite(v.y);
    }
    return sound;
  }

  static void shape(Shape shape, String name) {
    notNull(shape, name);
    notNegative(shape.m_radius, name + ".m_radius");
    switch (shape.m_type) {
      case CIRCLE:
        if (!(shape.m_radius > 0f)) {
          throw new IllegalArgumentException(
              name + ": the radius of a circle must be positive, is " + shape.m_radius);
        }
        finite(((CircleShape) shape).m_p, name + ".m_p");
        break;
      case EDGE:
        edge((EdgeShape) shape, name);
        break;
      case POLYGON:
        PolygonShape polygon = (PolygonShape) shape;
        vertices(polygon.m_vertices, polygon.m_count, 3, name);
        break;
      case CHAIN:
        ChainShape chain = (ChainShape) shape;
        vertices(chain.m_vertices, chain.m_count, 2, name);
        break;
      default:
        throw new IllegalArgumentException(name + " has an unknown type " + shape.m_type);
    }
  }

  private static void edge(EdgeShape edge, String name) {
    finite(edge.m_vertex1, name + ".m_vertex1");
    finite(edge.m_vertex2, name + ".m_vertex2");
    if (edge.m_hasVertex0) {
      finite(edge.m_vertex0, name + ".m_vertex0");
    }
    if (edge.m_hasVertex3) {
      finite(edge.m_vertex3, name + ".m_vertex3");
    }
  }

  private static void vertices(Vec2[] vertices, int count, int least, String name) {
    if (vertices == null || count < least || count > vertices.length) {
      throw new IllegalArgumentException(
          name + " must have at least " + least + " vertices, has " + count);
    }
    for (int i = 0; i < count; i++) {
      finite(vertices[i], name + ".m_vertices[" + i + "]");
    }
  }
}
