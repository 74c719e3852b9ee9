package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Contact of an edge and a circle by the Voronoi region of the circle's centre, on both sides of
 * the edge.
 *
 * <p>Ghost vertices keep a chain smooth: a vertex with a neighbouring edge is only touched if the
 * centre is not beside the inner part of that neighbour. If it is, the neighbour has the contact,
 * with its face normal.
 */
public final class EdgeCircle {

  private EdgeCircle() {}

  /** Writes the manifold of edge A and circle B; no point if they are further than the skins. */
  public static void collide(
      Manifold manifold, EdgeShape edge, Transform xfA, CircleShape circle, Transform xfB) {
    manifold.pointCount = 0;
    manifold.corner = false;
    Vec2 p = circle.m_p;
    float gx = (xfB.p.x - xfA.p.x) + (xfB.q.c * p.x - xfB.q.s * p.y);
    float gy = (xfB.p.y - xfA.p.y) + (xfB.q.s * p.x + xfB.q.c * p.y);
    float cx = xfA.q.c * gx + xfA.q.s * gy;
    float cy = xfA.q.c * gy - xfA.q.s * gx;

    float radius = edge.m_radius + circle.m_radius;
    Vec2 v1 = edge.m_vertex1;
    Vec2 v2 = edge.m_vertex2;
    float ex = v2.x - v1.x;
    float ey = v2.y - v1.y;
    if ((cx - v1.x) * ex + (cy - v1.y) * ey <= 0f) {
      if (!edge.m_hasVertex0 || !isBeside(v1, edge.m_vertex0, cx, cy)) {
        vertexContact(manifold, v1, cx, cy, radius, p);
      }
      return;
    }
    if ((cx - v2.x) * ex + (cy - v2.y) * ey >= 0f) {
      if (!edge.m_hasVertex3 || !isBeside(v2, edge.m_vertex3, cx, cy)) {
        vertexContact(manifold, v2, cx, cy, radius, p);
      }
      return;
    }

    // Here the edge has a length: a point edge ends in the first vertex region.
    float inverse = 1f / (float) Math.sqrt(ex * ex + ey * ey);
    float nx = -ey * inverse;
    float ny = ex * inverse;
    float s = nx * (cx - v1.x) + ny * (cy - v1.y);
    if (!(Math.abs(s) <= radius)) {
      return;
    }
    manifold.type = Manifold.ManifoldType.FACE_A;
    if (s < 0f) {
      manifold.localNormal.set(-nx, -ny);
    } else {
      manifold.localNormal.set(nx, ny);
    }
    CircleCircle.writeSinglePoint(manifold, v1, p);
  }

  /** Whether the centre projects on to the inner side of the neighbouring edge from {@code v}. */
  private static boolean isBeside(Vec2 v, Vec2 ghost, float cx, float cy) {
    return (cx - v.x) * (ghost.x - v.x) + (cy - v.y) * (ghost.y - v.y) > 0f;
  }

  private static void vertexContact(
      Manifold manifold, Vec2 vertex, float cx, float cy, float radius, Vec2 localCenter) {
    float dx = cx - vertex.x;
    float dy = cy - vertex.y;
    if (dx * dx + dy * dy <= radius * radius) {
      CircleCircle.writeRoundContact(manifold, vertex, localCenter);
      manifold.corner = true;
    }
  }
}
