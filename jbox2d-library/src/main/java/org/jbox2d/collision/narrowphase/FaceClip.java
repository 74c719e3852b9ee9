package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.ContactID;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * Cuts an incident edge to the width of a reference face and writes the contact points.
 *
 * <p>The caller gives the incident edge P Q in the coordinates of the reference face: u along the
 * face from its start, h above it along the outward normal, both in metres.
 *
 * <pre>
 *          h
 *          |      Q
 *          |     /          P is cut at u = 0, Q stays
 *     P    |    /
 *      \___|___/
 *          |  x
 *   -------0============L------- u
 *             reference face
 * </pre>
 *
 * <p>A cut is linear in u, so the points are interpolated on the incident edge in its own local
 * coordinates; an end that is not cut is the vertex itself, without rounding. Each point must be no
 * higher than the sum of the skin radii.
 *
 * <p>If the whole edge lies beyond one end of the face, two vertices are opposite each other. Then
 * the nearer end is the only candidate, and it counts if it lies inside the round end of the skin:
 * max(h, 0)^2 + e^2 at most R^2, with e its distance beyond the end. If the edge crosses the end, a
 * vertex in the round end is taken where it is clearly lower than the cut. A square end would let a
 * box that slides over butted tiles catch on the next tile: with the default settings bodies rest
 * at h = 0.015 with R = 0.02, and no vertex opposite is then both inside the round end and further
 * off sideways than upwards, so the upward face stays the reference.
 *
 * <p>A point's id is the pair of vertices that lie opposite each other at its end of the faces,
 * whether the incident one is cut or not and whichever shape is the reference. Boxes of one width
 * that are stacked change between cut and vertex by a rounding; a point that changed its id with
 * them would lose its impulse, and a high stack topple.
 */
final class FaceClip {

  /**
   * Part of {@link Settings#linearSlop} by which a vertex beyond the end must be lower than the cut
   * to be taken instead of it. Level edges are cut; at a corner opposite a corner the vertex
   * counts.
   */
  private static final float VERTEX_LEAD = 0.1f;

  private static final byte VERTEX = (byte) ContactID.Type.VERTEX.ordinal();

  private FaceClip() {}

  /**
   * Writes point count, point positions and ids. Faces run from their own index to the next one,
   * modulo the count; an edge shape counts as a polygon of two faces.
   *
   * @param referenceIsB whether the reference face is shape B's (ids are written accordingly)
   * @param length length of the reference face
   * @param p start of the incident face, local to the incident shape
   * @param q its end
   * @param radius sum of the skin radii
   * @return height of the lowest point written, positive infinity if there is none
   */
  static float clip(
      Manifold manifold,
      boolean referenceIsB,
      int refFace,
      int refCount,
      float length,
      int incFace,
      int incCount,
      Vec2 p,
      Vec2 q,
      float uP,
      float hP,
      float uQ,
      float hQ,
      float radius) {
    int refEnd = refFace + 1 < refCount ? refFace + 1 : 0;
    int incEnd = incFace + 1 < incCount ? incFace + 1 : 0;
    manifold.pointCount = 0;
    manifold.corner = false;

    if ((uP < 0f && uQ < 0f) || (uP > length && uQ > length)) {
      return addCorner(
          manifold,
          referenceIsB,
          refFace,
          refEnd,
          length,
          incFace,
          incEnd,
          p,
          q,
          uP,
          hP,
          uQ,
          hQ,
          radius);
    }

    float lowest =
        addEnd(manifold, referenceIsB, refEnd, length, incFace, p, q, uP, hP, uQ, hQ, radius);
    if (uQ == uP && hQ == hP) {
      // An incident edge without length is one point, not two.
      return lowest;
    }
    return Math.min(
        lowest,
        addEnd(manifold, referenceIsB, refFace, length, incEnd, q, p, uQ, hQ, uP, hP, radius));
  }

  /**
   * Writes the point for an incident edge that lies beyond one end of the face.
   *
   * @return its height, positive infinity if it is outside the round end
   */
  private static float addCorner(
      Manifold manifold,
      boolean referenceIsB,
      int refFace,
      int refEnd,
      float length,
      int incFace,
      int incEnd,
      Vec2 p,
      Vec2 q,
      float uP,
      float hP,
      float uQ,
      float hQ,
      float radius) {
    float eP = uP < 0f ? -uP : uP - length;
    float eQ = uQ < 0f ? -uQ : uQ - length;
    float aboveP = Math.max(hP, 0f);
    float aboveQ = Math.max(hQ, 0f);
    float squaredP = aboveP * aboveP + eP * eP;
    float squaredQ = aboveQ * aboveQ + eQ * eQ;
    boolean nearP = squaredP <= squaredQ;
    if (!((nearP ? squaredP : squaredQ) <= radius * radius)) {
      return Float.POSITIVE_INFINITY;
    }
    manifold.corner = true;
    add(manifold, referenceIsB, nearP ? refEnd : refFace, nearP ? incFace : incEnd)
        .localPoint
        .set(nearP ? p : q);
    return nearP ? hP : hQ;
  }

  /**
   * Writes the point for one end {@code v} of the incident edge, cut if need be; {@code w} is the
   * other end.
   *
   * @param corner vertex of the reference face at this end
   * @param vertex index of {@code v}
   * @return its height, positive infinity if it is above the skins
   */
  private static float addEnd(
      Manifold manifold,
      boolean referenceIsB,
      int corner,
      float length,
      int vertex,
      Vec2 v,
      Vec2 w,
      float u,
      float h,
      float uOther,
      float hOther,
      float radius) {
    if (u < 0f || u > length) {
      float fraction = ((u < 0f ? 0f : length) - u) / (uOther - u);
      float hCut = h + fraction * (hOther - h);
      float e = u < 0f ? -u : u - length;
      float above = Math.max(h, 0f);
      boolean round = above * above + e * e <= radius * radius;
      if (!round || h >= hCut - VERTEX_LEAD * Settings.linearSlop) {
        if (!(hCut <= radius)) {
          return Float.POSITIVE_INFINITY;
        }
        ManifoldPoint point = add(manifold, referenceIsB, corner, vertex);
        point.localPoint.set(v.x + fraction * (w.x - v.x), v.y + fraction * (w.y - v.y));
        return hCut;
      }
    } else if (!(h <= radius)) {
      return Float.POSITIVE_INFINITY;
    }
    add(manifold, referenceIsB, corner, vertex).localPoint.set(v);
    return h;
  }

  private static ManifoldPoint add(Manifold manifold, boolean flip, int refVertex, int incVertex) {
    ManifoldPoint point = manifold.points[manifold.pointCount++];
    ContactID id = point.id;
    id.typeA = VERTEX;
    id.indexA = (byte) (flip ? incVertex : refVertex);
    id.typeB = VERTEX;
    id.indexB = (byte) (flip ? refVertex : incVertex);
    return point;
  }
}
