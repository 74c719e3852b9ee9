package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Contact of a polygon and a circle by the Voronoi region of the circle's centre.
 *
 * <p>In the polygon's frame let s_i = n_i . (c - v_i) be the signed distance of the centre c to the
 * line of face i. The face with the greatest s_i owns the closest feature: inside the polygon it is
 * the face of least penetration; in a face region the closest point lies on it; in a vertex region
 * it is one of the vertex's two faces, because their normals enclose the direction to c (Ericson,
 * Real-Time Collision Detection, 2005, section 5.1).
 */
public final class PolygonCircle {

  /**
   * Part of {@link Settings#linearSlop} below which the direction from a vertex to the centre is
   * taken from the face instead: there rounding of the coordinates would choose the direction.
   */
  static final float DIRECTION_NOISE = 0.001f;

  private PolygonCircle() {}

  /** Writes the manifold of polygon A and circle B; no point if they are further than the skins. */
  public static void collide(
      Manifold manifold, PolygonShape polygon, Transform xfA, CircleShape circle, Transform xfB) {
    collide(manifold, polygon, xfA, circle, xfB, 0f, 0f);
  }

  /**
   * As above, for a polygon that may be a part of a compound.
   *
   * @param wayX how the circle has moved against the polygon in the last step, in the world, m
   * @param wayY see {@code wayX}
   */
  public static void collide(
      Manifold manifold,
      PolygonShape polygon,
      Transform xfA,
      CircleShape circle,
      Transform xfB,
      float wayX,
      float wayY) {
    manifold.pointCount = 0;
    manifold.corner = false;
    Vec2 p = circle.m_p;
    float gx = (xfB.p.x - xfA.p.x) + (xfB.q.c * p.x - xfB.q.s * p.y);
    float gy = (xfB.p.y - xfA.p.y) + (xfB.q.s * p.x + xfB.q.c * p.y);
    float cx = xfA.q.c * gx + xfA.q.s * gy;
    float cy = xfA.q.c * gy - xfA.q.s * gx;

    float radius = polygon.m_radius + circle.m_radius;
    Vec2[] vertices = polygon.m_vertices;
    Vec2[] normals = polygon.m_normals;
    int count = polygon.m_count;
    float separation = Float.NEGATIVE_INFINITY;
    int face = 0;
    for (int i = 0; i < count; i++) {
      Vec2 n = normals[i];
      Vec2 v = vertices[i];
      float s = n.x * (cx - v.x) + n.y * (cy - v.y);
      if (s > separation) {
        separation = s;
        face = i;
      }
    }
    if (!(separation <= radius) || count == 0) {
      return;
    }

    if (PartShape.isInner(polygon, face)) {
      float inX = xfA.q.c * wayX + xfA.q.s * wayY;
      float inY = xfA.q.c * wayY - xfA.q.s * wayX;
      PartShape part = (PartShape) polygon;
      if (PartCircle.collide(manifold, part, face, separation, cx, cy, p, inX, inY)) {
        return;
      }
    }
    Vec2 v1 = vertices[face];
    Vec2 v2 = vertices[face + 1 < count ? face + 1 : 0];
    if (separation > 0f) {
      float ex = v2.x - v1.x;
      float ey = v2.y - v1.y;
      Vec2 vertex = null;
      if ((cx - v1.x) * ex + (cy - v1.y) * ey <= 0f) {
        vertex = v1;
      } else if ((cx - v2.x) * ex + (cy - v2.y) * ey >= 0f) {
        vertex = v2;
      }
      if (vertex != null && vertexContact(manifold, vertex, cx, cy, radius, p)) {
        return;
      }
    }
    manifold.type = Manifold.ManifoldType.FACE_A;
    manifold.localNormal.set(normals[face]);
    CircleCircle.writeSinglePoint(manifold, v1, p);
    manifold.localPoint.set(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
  }

  /**
   * Handles a centre in a vertex region. The normal is stored explicitly, with the vertex as the
   * point of the plane, so that a later correction of positions sees the distance along it.
   *
   * @return false if the centre is so close to the vertex that the face has to give the normal
   */
  private static boolean vertexContact(
      Manifold manifold, Vec2 vertex, float cx, float cy, float radius, Vec2 localCenter) {
    float dx = cx - vertex.x;
    float dy = cy - vertex.y;
    float squared = dx * dx + dy * dy;
    if (squared > radius * radius) {
      return true;
    }
    float noise = DIRECTION_NOISE * Settings.linearSlop;
    if (squared <= noise * noise) {
      return false;
    }
    float inverse = 1f / (float) Math.sqrt(squared);
    manifold.type = Manifold.ManifoldType.FACE_A;
    manifold.localNormal.set(dx * inverse, dy * inverse);
    CircleCircle.writeSinglePoint(manifold, vertex, localCenter);
    manifold.corner = true;
    return true;
  }
}
