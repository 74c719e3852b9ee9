package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * A convex part of a compound that knows which of its edges are inner ones, and what lies across.
 *
 * <pre>
 *       outline
 *     +-----------+--------+
 *     |   part 0  |        |
 *     |           | part 1 |      |: inner edge of 0, across it 1, and the other way round
 *     +-----------+        |
 *                 +--------+
 * </pre>
 *
 * <p>An inner edge separates its part from other bodies as any edge does, but it is no surface: a
 * body pushed out of the part through it is pushed into the next one. See {@link PartPolygons}.
 *
 * <p>A clone is a polygon for itself, all edges of which count.
 */
public final class PartShape extends PolygonShape {
  /**
   * How far the ends of an edge may be from the next part's edge for the two to be the same, as a
   * share of {@link Settings#linearSlop}: far above the rounding of vertices that are meant to be
   * the same, far below the shortest edge.
   */
  private static final float SEAM_TOLERANCE = 0.1f;

  /** All parts of the compound, {@code null} for those that are no polygon or have gone. */
  private final PartShape[] parts;

  private final int index;

  /** As long as the vertices, however many of them are in use: users may edit the shape. */
  private final PartShape[] across;

  private PartShape(PolygonShape polygon, PartShape[] parts, int index) {
    m_count = polygon.m_count;
    for (int i = 0; i < m_count; i++) {
      m_vertices[i].set(polygon.m_vertices[i]);
      m_normals[i].set(polygon.m_normals[i]);
    }
    m_centroid.set(polygon.m_centroid);
    m_radius = polygon.m_radius;
    this.parts = parts;
    this.index = index;
    across = new PartShape[m_vertices.length];
  }

  /**
   * Copies the polygons among the shapes of a compound as parts that know their neighbours.
   *
   * @return a part for each polygon, {@code null} for every other shape; or {@code null} if no two
   *     of them share an edge
   */
  public static PartShape[] link(Shape[] shapes) {
    if (shapes.length < 2) {
      return null;
    }
    PartShape[] parts = new PartShape[shapes.length];
    for (int i = 0; i < parts.length; i++) {
      if (shapes[i] instanceof PolygonShape
          && ((PolygonShape) shapes[i]).m_count <= Settings.maxPolygonVertices) {
        parts[i] = new PartShape((PolygonShape) shapes[i], parts, i);
      }
    }
    float[] bounds = boundsOf(parts);
    boolean linked = false;
    for (int i = 0; i < parts.length; i++) {
      for (int j = i + 1; j < parts.length; j++) {
        if (parts[i] != null && parts[j] != null && near(bounds, 4 * i, 4 * j)) {
          linked |= parts[i].findAcross(parts[j], bounds, 4 * j);
          linked |= parts[j].findAcross(parts[i], bounds, 4 * i);
        }
      }
    }
    return linked ? parts : null;
  }

  /** Least and greatest coordinates of each part, with the tolerance around them. */
  private static float[] boundsOf(PartShape[] parts) {
    float[] bounds = new float[4 * parts.length];
    float tolerance = SEAM_TOLERANCE * Settings.linearSlop;
    for (int i = 0; i < parts.length; i++) {
      if (parts[i] == null) {
        continue;
      }
      float minX = Float.POSITIVE_INFINITY;
      float minY = Float.POSITIVE_INFINITY;
      float maxX = Float.NEGATIVE_INFINITY;
      float maxY = Float.NEGATIVE_INFINITY;
      for (int k = 0; k < parts[i].m_count; k++) {
        Vec2 v = parts[i].m_vertices[k];
        minX = Math.min(minX, v.x);
        minY = Math.min(minY, v.y);
        maxX = Math.max(maxX, v.x);
        maxY = Math.max(maxY, v.y);
      }
      bounds[4 * i] = minX - tolerance;
      bounds[4 * i + 1] = minY - tolerance;
      bounds[4 * i + 2] = maxX + tolerance;
      bounds[4 * i + 3] = maxY + tolerance;
    }
    return bounds;
  }

  private static boolean near(float[] bounds, int i, int j) {
    return bounds[i] <= bounds[j + 2]
        && bounds[j] <= bounds[i + 2]
        && bounds[i + 1] <= bounds[j + 3]
        && bounds[j + 1] <= bounds[i + 3];
  }

  /** Finds the edges that lie on an edge of another part: inside its bounds, and opposite to it. */
  private boolean findAcross(PartShape other, float[] bounds, int j) {
    boolean found = false;
    for (int i = 0; i < m_count; i++) {
      Vec2 from = m_vertices[i];
      Vec2 to = m_vertices[next(i)];
      if (across[i] != null || !isInside(from, bounds, j) || !isInside(to, bounds, j)) {
        continue;
      }
      Vec2 n = m_normals[i];
      for (int k = 0; k < other.m_count && across[i] == null; k++) {
        Vec2 otherNormal = other.m_normals[k];
        if (n.x * otherNormal.x + n.y * otherNormal.y < 0f && other.covers(k, from, to)) {
          across[i] = other;
          found = true;
        }
      }
    }
    return found;
  }

  /** A point on an edge is inside the bounds but for one more tolerance. */
  private static boolean isInside(Vec2 v, float[] bounds, int j) {
    float tolerance = SEAM_TOLERANCE * Settings.linearSlop;
    return v.x >= bounds[j] - tolerance
        && v.x <= bounds[j + 2] + tolerance
        && v.y >= bounds[j + 1] - tolerance
        && v.y <= bounds[j + 3] + tolerance;
  }

  /** Whether edge k, run backwards, contains the way from {@code from} to {@code to}. */
  private boolean covers(int k, Vec2 from, Vec2 to) {
    Vec2 start = m_vertices[k];
    Vec2 end = m_vertices[next(k)];
    if (start.x == to.x && start.y == to.y && end.x == from.x && end.y == from.y) {
      return true;
    }
    Vec2 n = m_normals[k];
    float tolerance = SEAM_TOLERANCE * Settings.linearSlop;
    float heightFrom = n.x * (from.x - start.x) + n.y * (from.y - start.y);
    float heightTo = n.x * (to.x - start.x) + n.y * (to.y - start.y);
    if (!(Math.abs(heightFrom) <= tolerance && Math.abs(heightTo) <= tolerance)) {
      return false;
    }
    // Along the edge, whose direction is (-n.y, n.x).
    float uFrom = n.x * (from.y - start.y) - n.y * (from.x - start.x);
    float uTo = n.x * (to.y - start.y) - n.y * (to.x - start.x);
    float length = n.x * (end.y - start.y) - n.y * (end.x - start.x);
    return uTo < uFrom && uTo >= -tolerance && uFrom <= length + tolerance;
  }

  private int next(int i) {
    return i + 1 < m_count ? i + 1 : 0;
  }

  /** The part leaves its compound: edges that were inner ones for its sake are so no longer. */
  public void leave() {
    parts[index] = null;
    for (PartShape part : parts) {
      for (int i = 0; part != null && i < part.m_count; i++) {
        if (part.across[i] == this) {
          part.across[i] = null;
        }
      }
    }
  }

  /** What lies across an edge; {@code null} on the outline. */
  PartShape across(int edge) {
    return across[edge];
  }

  /** Whether an edge of a polygon is the inner edge of a part. */
  static boolean isInner(PolygonShape polygon, int edge) {
    return polygon instanceof PartShape && ((PartShape) polygon).across[edge] != null;
  }

  /** Number of the part in its compound. */
  int index() {
    return index;
  }

  /** Number of parts that the compound has had. */
  int partCount() {
    return parts.length;
  }

  /** A part of the same compound; {@code null} if it has gone. */
  PartShape part(int i) {
    return parts[i];
  }
}
