package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.ContactID;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
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
 * max(h, 0)^2 + e^2 at most R^2, with e its distance beyond the end. A square end would let a box
 * that slides over butted tiles catch on the next tile: with the default settings bodies rest at h
 * = 0.015 with R = 0.02, and no vertex opposite is then both inside the round end and further off
 * sideways than upwards, so the upward face stays the reference.
 *
 * <p>Ids name features, whichever side is the reference: an incident vertex is (face of one, vertex
 * of the other), a cut is (end vertex of the reference face, face of the incident edge).
 */
final class FaceClip {

  private static final byte VERTEX = (byte) ContactID.Type.VERTEX.ordinal();
  private static final byte FACE = (byte) ContactID.Type.FACE.ordinal();

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
   */
  static void clip(
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

    if ((uP < 0f && uQ < 0f) || (uP > length && uQ > length)) {
      float eP = uP < 0f ? -uP : uP - length;
      float eQ = uQ < 0f ? -uQ : uQ - length;
      boolean nearP = eP <= eQ;
      float e = nearP ? eP : eQ;
      float h = Math.max(nearP ? hP : hQ, 0f);
      if (h * h + e * e <= radius * radius) {
        add(manifold, referenceIsB, FACE, refFace, VERTEX, nearP ? incFace : incEnd, nearP ? p : q);
      }
      return;
    }

    float du = uQ - uP;
    float dh = hQ - hP;
    if (uP < 0f || uP > length) {
      float cut = uP < 0f ? 0f : length;
      float fraction = (cut - uP) / du;
      if (hP + fraction * dh <= radius) {
        int corner = uP < 0f ? refFace : refEnd;
        add(manifold, referenceIsB, VERTEX, corner, FACE, incFace, p, q, fraction);
      }
    } else if (hP <= radius) {
      add(manifold, referenceIsB, FACE, refFace, VERTEX, incFace, p);
    }

    if (uQ < 0f || uQ > length) {
      float cut = uQ < 0f ? 0f : length;
      float fraction = (cut - uP) / du;
      if (hP + fraction * dh <= radius) {
        int corner = uQ < 0f ? refFace : refEnd;
        add(manifold, referenceIsB, VERTEX, corner, FACE, incFace, p, q, fraction);
      }
    } else if (hQ <= radius && (du != 0f || dh != 0f)) {
      // An incident edge without length is one point, not two.
      add(manifold, referenceIsB, FACE, refFace, VERTEX, incEnd, q);
    }
  }

  private static void add(
      Manifold manifold,
      boolean flip,
      byte refType,
      int refIndex,
      byte incType,
      int incIndex,
      Vec2 at) {
    ManifoldPoint point = manifold.points[manifold.pointCount++];
    point.localPoint.set(at);
    identify(point.id, flip, refType, refIndex, incType, incIndex);
  }

  private static void add(
      Manifold manifold,
      boolean flip,
      byte refType,
      int refIndex,
      byte incType,
      int incIndex,
      Vec2 p,
      Vec2 q,
      float fraction) {
    ManifoldPoint point = manifold.points[manifold.pointCount++];
    point.localPoint.set(p.x + fraction * (q.x - p.x), p.y + fraction * (q.y - p.y));
    identify(point.id, flip, refType, refIndex, incType, incIndex);
  }

  private static void identify(
      ContactID id, boolean flip, byte refType, int refIndex, byte incType, int incIndex) {
    id.typeA = flip ? incType : refType;
    id.indexA = (byte) (flip ? incIndex : refIndex);
    id.typeB = flip ? refType : incType;
    id.indexB = (byte) (flip ? refIndex : incIndex);
  }
}
