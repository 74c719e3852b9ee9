package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;

/**
 * Contact of a part of a compound and a circle whose centre is beyond an inner edge, or leaves the
 * part soonest through one. See {@link PartPolygons}; for a point it is simpler: each point lies in
 * one part.
 */
final class PartCircle {
  private PartCircle() {}

  /**
   * Writes the manifold, if the inner edge makes a difference.
   *
   * @param edge inner edge to whose line the centre has the greatest signed distance
   * @param separation that distance, m
   * @param cx centre in the part's frame
   * @param localCenter centre in the circle's frame
   * @param inX how the circle has moved in the last step, in the part's frame, m
   * @param inY see {@code inX}
   * @return false if the part's vertices are to be looked at as without inner edges
   */
  static boolean collide(
      Manifold manifold,
      PartShape part,
      int edge,
      float separation,
      float cx,
      float cy,
      Vec2 localCenter,
      float inX,
      float inY) {
    if (separation > 0f) {
      return isNeighbours(part, edge, cx, cy);
    }
    buildOnOutline(manifold, part, cx, cy, localCenter, inX, inY);
    return manifold.pointCount > 0;
  }

  /**
   * Whether the nearest point of the part belongs to the inner edge alone, or to the vertex of two
   * of them: then the part across has the contact.
   */
  private static boolean isNeighbours(PartShape part, int edge, float cx, float cy) {
    int end = edge + 1 < part.m_count ? edge + 1 : 0;
    Vec2 v1 = part.m_vertices[edge];
    Vec2 v2 = part.m_vertices[end];
    float ex = v2.x - v1.x;
    float ey = v2.y - v1.y;
    if ((cx - v1.x) * ex + (cy - v1.y) * ey <= 0f) {
      return part.across(edge > 0 ? edge - 1 : part.m_count - 1) != null;
    }
    return (cx - v2.x) * ex + (cy - v2.y) * ey < 0f || part.across(end) != null;
  }

  /**
   * Takes the edge of the compound's outline through which the centre has come in the last step,
   * otherwise the nearest.
   */
  private static void buildOnOutline(
      Manifold manifold, PartShape of, float cx, float cy, Vec2 localCenter, float inX, float inY) {
    float least = Float.POSITIVE_INFINITY;
    for (int p = 0; p < of.partCount(); p++) {
      PartShape part = of.part(p);
      for (int i = 0; part != null && i < part.m_count; i++) {
        Vec2 v1 = part.m_vertices[i];
        Vec2 n = part.m_normals[i];
        float depth = n.x * (v1.x - cx) + n.y * (v1.y - cy);
        if (part.across(i) != null || depth < 0f) {
          continue;
        }
        Vec2 v2 = part.m_vertices[i + 1 < part.m_count ? i + 1 : 0];
        float beyond = beyond(v1, v2, n, cx, cy);
        float order =
            beyond > 0f
                ? (float) Math.sqrt(depth * depth + beyond * beyond)
                : PartPolygons.order(depth, -(n.x * inX + n.y * inY));
        if (order < least) {
          least = order;
          manifold.type = Manifold.ManifoldType.FACE_A;
          manifold.localNormal.set(n);
          CircleCircle.writeSinglePoint(manifold, v1, localCenter);
          manifold.localPoint.set(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
        }
      }
    }
  }

  /** How far a point lies beyond the ends of an edge, along it, m. */
  private static float beyond(Vec2 v1, Vec2 v2, Vec2 n, float cx, float cy) {
    float u = n.x * (cy - v1.y) - n.y * (cx - v1.x);
    float length = n.x * (v2.y - v1.y) - n.y * (v2.x - v1.x);
    return u < 0f ? -u : u > length ? u - length : 0f;
  }
}
