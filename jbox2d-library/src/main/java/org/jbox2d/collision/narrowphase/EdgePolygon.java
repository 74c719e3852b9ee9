package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Contact of an edge, alone or as a link of a chain, and a convex polygon.
 *
 * <p>An edge is a polygon of two faces: face 0 runs from vertex 1 to vertex 2, face 1 back, and
 * each looks to the right of its direction. First the side is chosen on which the polygon lies;
 * from there on start, end and ghosts are named along the face that looks at the polygon. Then the
 * edge's face and the polygon's faces compete as in {@link PolygonPolygon}.
 *
 * <p>Ghost vertices restrict the normals, in terms of the Gauss map of the chain. At a convex
 * corner the chain owns all directions between the normals of its two edges:
 *
 * <pre>
 *        n0 ^    ^ n1
 *           |   /            a polygon face whose opposite k lies
 *    0------1  /               between n0 and n1   touches the corner
 *            \/                beyond n0           touches the neighbour only
 *             \ 2
 * </pre>
 *
 * <p>A flat or concave corner owns no direction but the edge's own. There the polygon's face gives
 * way to the edge's face, so that a chain of collinear links gives the same normals as one long
 * edge, and nothing catches on inner vertices. An end without a ghost accepts every direction.
 *
 * <p>All products are taken in the polygon's frame. Fields hold the edge in that frame during one
 * call.
 */
public final class EdgePolygon {

  /** As in {@link PolygonPolygon}: part of the linear slop, and part of the separation. */
  private static final float FACE_MARGIN = 0.1f;

  private static final float RELATIVE_MARGIN = 0.02f;

  /** What becomes of a polygon face that separates better than the edge. */
  private enum Verdict {
    /** It is the reference face. */
    ADMIT,
    /** The edge's own face is the reference instead. */
    SNAP,
    /** The neighbour has this contact. */
    SKIP
  }

  /** Rotation (c, -s; s, c) and translation from the edge's frame to the polygon's. */
  private float c;

  private float s;
  private float tx;
  private float ty;

  /** The face looking at the polygon: 0 or 1, its start, unit direction, normal and length. */
  private int face;

  private float startX;
  private float startY;
  private float endX;
  private float endY;
  private float dirX;
  private float dirY;
  private float normalX;
  private float normalY;
  private float length;

  /** Writes the manifold of an edge and a polygon; no point if they are further than the skins. */
  public void collide(
      Manifold manifold, EdgeShape edge, Transform xfA, PolygonShape polygon, Transform xfB) {
    manifold.pointCount = 0;
    float radius = edge.m_radius + polygon.m_radius;
    placeEdge(edge, xfA, xfB);
    if (length > 0f && !isRight(edge, polygon)) {
      reverse();
    }

    // Stage 1: the edge's face. A point edge has none and loses to every polygon face.
    float edgeSeparation = length > 0f ? edgeSeparation(polygon) : Float.NEGATIVE_INFINITY;
    if (!(edgeSeparation <= radius)) {
      return;
    }

    // Stage 2: the polygon's faces.
    Vec2[] v = polygon.m_vertices;
    Vec2[] n = polygon.m_normals;
    float best = Float.NEGATIVE_INFINITY;
    int bestFace = 0;
    for (int i = 0; i < polygon.m_count; i++) {
      float nx = n[i].x;
      float ny = n[i].y;
      float fromStart = nx * startX + ny * startY;
      float fromEnd = nx * endX + ny * endY;
      float separation = Math.min(fromStart, fromEnd) - (nx * v[i].x + ny * v[i].y);
      if (separation > best) {
        best = separation;
        bestFace = i;
      }
    }
    if (!(best <= radius) || best == Float.NEGATIVE_INFINITY) {
      return;
    }

    // Stage 3: who is the reference.
    float margin = FACE_MARGIN * Settings.linearSlop + RELATIVE_MARGIN * Math.abs(edgeSeparation);
    Verdict verdict = Verdict.SNAP;
    if (length == 0f) {
      verdict = Verdict.ADMIT;
    } else if (best > edgeSeparation + margin && PartShape.isInner(polygon, bestFace)) {
      // Out of the part through an inner edge is into the part across; beyond it, that has it.
      verdict = best > 0f ? Verdict.SKIP : Verdict.SNAP;
    } else if (best > edgeSeparation + margin) {
      verdict = judge(edge, -n[bestFace].x, -n[bestFace].y);
    }
    if (verdict == Verdict.SNAP) {
      buildOnEdge(manifold, edge, polygon, radius);
    } else if (verdict == Verdict.ADMIT) {
      buildOnPolygon(manifold, edge, polygon, bestFace, radius);
    }
  }

  /** Brings the edge into the polygon's frame, as face 0. */
  private void placeEdge(EdgeShape edge, Transform xfA, Transform xfB) {
    float cB = xfB.q.c;
    float sB = xfB.q.s;
    float gx = xfA.p.x - xfB.p.x;
    float gy = xfA.p.y - xfB.p.y;
    c = cB * xfA.q.c + sB * xfA.q.s;
    s = cB * xfA.q.s - sB * xfA.q.c;
    tx = cB * gx + sB * gy;
    ty = cB * gy - sB * gx;

    Vec2 v1 = edge.m_vertex1;
    Vec2 v2 = edge.m_vertex2;
    float ex = v2.x - v1.x;
    float ey = v2.y - v1.y;
    length = (float) Math.sqrt(ex * ex + ey * ey);
    float inverse = length > 0f ? 1f / length : 0f;
    ex *= inverse;
    ey *= inverse;
    face = 0;
    startX = toPolygonX(v1);
    startY = toPolygonY(v1);
    endX = toPolygonX(v2);
    endY = toPolygonY(v2);
    dirX = c * ex - s * ey;
    dirY = s * ex + c * ey;
    normalX = dirY;
    normalY = -dirX;
  }

  private float toPolygonX(Vec2 v) {
    return c * v.x - s * v.y + tx;
  }

  private float toPolygonY(Vec2 v) {
    return s * v.x + c * v.y + ty;
  }

  /** Turns to face 1. */
  private void reverse() {
    face = 1;
    float x = startX;
    float y = startY;
    startX = endX;
    startY = endY;
    endX = x;
    endY = y;
    dirX = -dirX;
    dirY = -dirY;
    normalX = -normalX;
    normalY = -normalY;
  }

  /**
   * Whether the polygon's middle lies to the right of the chain. At a corner that is convex as seen
   * from the right the right side is the union of both edges' half planes, at a concave one their
   * intersection.
   */
  private boolean isRight(EdgeShape edge, PolygonShape polygon) {
    float sumX = 0f;
    float sumY = 0f;
    for (int j = 0; j < polygon.m_count; j++) {
      sumX += polygon.m_vertices[j].x;
      sumY += polygon.m_vertices[j].y;
    }
    float middleX = sumX / polygon.m_count;
    float middleY = sumY / polygon.m_count;
    boolean concaves = normalX * (middleX - startX) + normalY * (middleY - startY) >= 0f;
    boolean convexes = false;
    if (edge.m_hasVertex0) {
      float ex = startX - toPolygonX(edge.m_vertex0);
      float ey = startY - toPolygonY(edge.m_vertex0);
      boolean right = ey * (middleX - startX) - ex * (middleY - startY) >= 0f;
      boolean convex = ex * dirY - ey * dirX > 0f;
      convexes = convex && right;
      concaves &= convex || right;
    }
    if (edge.m_hasVertex3) {
      float ex = toPolygonX(edge.m_vertex3) - endX;
      float ey = toPolygonY(edge.m_vertex3) - endY;
      boolean right = ey * (middleX - endX) - ex * (middleY - endY) >= 0f;
      boolean convex = dirX * ey - dirY * ex > 0f;
      convexes |= convex && right;
      concaves &= convex || right;
    }
    return concaves || convexes;
  }

  private float edgeSeparation(PolygonShape polygon) {
    float least = Float.POSITIVE_INFINITY;
    for (int j = 0; j < polygon.m_count; j++) {
      Vec2 v = polygon.m_vertices[j];
      float d = normalX * (v.x - startX) + normalY * (v.y - startY);
      if (d < least) {
        least = d;
      }
    }
    return least;
  }

  /** Judges k, the direction from the edge to the polygon that a polygon face asks for. */
  private Verdict judge(EdgeShape edge, float kx, float ky) {
    boolean towardsStart = kx * dirX + ky * dirY < 0f;
    boolean atVertex1 = towardsStart == (face == 0);
    if (atVertex1 ? !edge.m_hasVertex0 : !edge.m_hasVertex3) {
      return Verdict.ADMIT;
    }
    Vec2 ghost = atVertex1 ? edge.m_vertex0 : edge.m_vertex3;
    // The neighbour's direction, in the sense in which the chain is walked.
    float fx = towardsStart ? startX - toPolygonX(ghost) : toPolygonX(ghost) - endX;
    float fy = towardsStart ? startY - toPolygonY(ghost) : toPolygonY(ghost) - endY;
    float norm = (float) Math.sqrt(fx * fx + fy * fy);
    if (!(norm > 0f)) {
      return Verdict.ADMIT;
    }
    fx /= norm;
    fy /= norm;
    // Sines of the turn at the corner, and of the way from the neighbour's normal (fy, -fx) to k;
    // both count positive towards this edge at its start, away from it at its end.
    float turn = fx * dirY - fy * dirX;
    float inside = fy * ky + fx * kx;
    if (!towardsStart) {
      turn = -turn;
      inside = -inside;
    }
    if (turn <= Settings.angularSlop) {
      return Verdict.SNAP;
    }
    return inside >= -Settings.angularSlop ? Verdict.ADMIT : Verdict.SKIP;
  }

  private void buildOnEdge(Manifold manifold, EdgeShape edge, PolygonShape polygon, float radius) {
    int incFace = FaceQuery.incidentFace(polygon, normalX, normalY);
    Vec2 p = polygon.m_vertices[incFace];
    Vec2 q = polygon.m_vertices[incFace + 1 < polygon.m_count ? incFace + 1 : 0];
    float px = p.x - startX;
    float py = p.y - startY;
    float qx = q.x - startX;
    float qy = q.y - startY;

    manifold.type = Manifold.ManifoldType.FACE_A;
    Vec2 start = face == 0 ? edge.m_vertex1 : edge.m_vertex2;
    Vec2 end = face == 0 ? edge.m_vertex2 : edge.m_vertex1;
    manifold.localNormal.set((end.y - start.y) / length, (start.x - end.x) / length);
    manifold.localPoint.set(start);
    FaceClip.clip(
        manifold,
        false,
        face,
        2,
        length,
        incFace,
        polygon.m_count,
        p,
        q,
        dirX * px + dirY * py,
        normalX * px + normalY * py,
        dirX * qx + dirY * qy,
        normalX * qx + normalY * qy,
        radius);
  }

  private void buildOnPolygon(
      Manifold manifold, EdgeShape edge, PolygonShape polygon, int refFace, float radius) {
    Vec2 n = polygon.m_normals[refFace];
    Vec2 v1 = polygon.m_vertices[refFace];
    Vec2 v2 = polygon.m_vertices[refFace + 1 < polygon.m_count ? refFace + 1 : 0];
    float px = startX - v1.x;
    float py = startY - v1.y;
    float qx = endX - v1.x;
    float qy = endY - v1.y;

    manifold.type = Manifold.ManifoldType.FACE_B;
    manifold.localNormal.set(n);
    manifold.localPoint.set(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
    FaceClip.clip(
        manifold,
        true,
        refFace,
        polygon.m_count,
        n.x * (v2.y - v1.y) - n.y * (v2.x - v1.x),
        face,
        2,
        face == 0 ? edge.m_vertex1 : edge.m_vertex2,
        face == 0 ? edge.m_vertex2 : edge.m_vertex1,
        n.x * py - n.y * px,
        n.x * px + n.y * py,
        n.x * qy - n.y * qx,
        n.x * qx + n.y * qy,
        radius);
  }
}
