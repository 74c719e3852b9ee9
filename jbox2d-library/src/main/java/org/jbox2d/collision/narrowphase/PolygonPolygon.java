package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Contact of two convex polygons: the best separating face of either is the reference, the other
 * polygon's face most opposed to it is cut to its width.
 *
 * <p>By the separating axis theorem the normal of least penetration of two convex polygons is a
 * face normal of one of them, and the other's deepest vertex then lies over that face ({@link
 * FaceQuery}, {@link FaceClip}).
 */
public final class PolygonPolygon {

  /**
   * Part of {@link Settings#linearSlop} by which B's face must separate better than A's to become
   * the reference. Two parallel faces separate equally up to rounding; without the margin the
   * reference, and with it the ids, would change from step to step. The slop is the depth at which
   * the solver leaves contacts alone, so a tenth of it is not felt.
   */
  private static final float FACE_MARGIN = 0.1f;

  /**
   * The same as a part of the separation itself: for penetrations far above the slop, where one
   * step moves bodies by more than the absolute margin.
   */
  private static final float RELATIVE_MARGIN = 0.02f;

  /** A guess: the best face of A, that of B, and whether B's alone is known to keep them apart. */
  private static final int FACE_BITS = 8;

  private static final int FACE = (1 << FACE_BITS) - 1;
  private static final int PARTED_BY_B = 1 << 2 * FACE_BITS;

  /**
   * The separation that the last call found, m: the polygons, without their skins, are at least
   * that far apart. It is the best of all faces unless they are further apart than their skins.
   */
  public float separation;

  private final FaceQuery queryA = new FaceQuery();
  private final FaceQuery queryB = new FaceQuery();

  /**
   * Writes the manifold of two polygons; no point if they are further than their skins. All edges
   * are surfaces; for parts of compounds see {@link PartPolygons}.
   *
   * @param guess what the last call for this pair returned, or 0: where to begin to search. The
   *     manifold does not depend on it
   * @return where to begin the next time
   */
  public int collide(
      Manifold manifold, PolygonShape a, Transform xfA, PolygonShape b, Transform xfB, int guess) {
    manifold.pointCount = 0;
    float radius = a.m_radius + b.m_radius;

    // Stage 1: a point w of B is at R w + t in A's frame, R = (c, -s; s, c).
    float cA = xfA.q.c;
    float sA = xfA.q.s;
    float gx = xfB.p.x - xfA.p.x;
    float gy = xfB.p.y - xfA.p.y;
    float c = cA * xfB.q.c + sA * xfB.q.s;
    float s = cA * xfB.q.s - sA * xfB.q.c;
    float tx = cA * gx + sA * gy;
    float ty = cA * gy - sA * gx;

    // Stage 2: best face of each; a gap on either ends the search. NaN fails the comparisons.
    float backX = -(c * tx + s * ty);
    float backY = s * tx - c * ty;
    int guessA = guess & FACE;
    int guessB = guess >> FACE_BITS & FACE;
    if ((guess & PARTED_BY_B) != 0 && guessB < b.m_count) {
      separation = FaceQuery.measure(b, guessB, a, c, -s, backX, backY);
      if (separation > radius) {
        return guess;
      }
    }
    FaceQuery faceA = queryA;
    faceA.run(a, b, c, s, tx, ty, radius, guessA);
    separation = faceA.separation;
    if (!(separation <= radius)) {
      return faceA.face | guessB << FACE_BITS;
    }
    FaceQuery faceB = queryB;
    faceB.run(b, a, c, -s, backX, backY, radius, guessB);
    int faces = faceA.face | faceB.face << FACE_BITS;
    if (!(faceB.separation <= separation)) {
      separation = faceB.separation;
    }
    if (!(separation <= radius)) {
      return faces | PARTED_BY_B;
    }

    // Stage 3: reference face and incident face.
    float margin = margin(faceA.separation);
    boolean referenceIsB = faceB.separation > faceA.separation + margin;
    float lowest = buildOn(manifold, referenceIsB, a, b, c, s, tx, ty, radius);
    // The reference face may end before the other's nearest vertex: beside a corner, or where A is
    // preferred by the margin alone. Then the cut has lost that vertex, and the other face shows
    // it.
    boolean lost =
        lowest == Float.POSITIVE_INFINITY
            || (!referenceIsB
                && lowest > faceB.separation + margin
                && faceB.separation > faceA.separation);
    if (lost) {
      buildOn(manifold, !referenceIsB, a, b, c, s, tx, ty, radius);
    }
    return faces;
  }

  /** By how much B's face must separate better than A's of the given separation, m. */
  static float margin(float separationA) {
    return FACE_MARGIN * Settings.linearSlop + RELATIVE_MARGIN * Math.abs(separationA);
  }

  /** Builds on the face found for A or for B; a point w of B is at R w + t in A's frame. */
  private float buildOn(
      Manifold manifold,
      boolean referenceIsB,
      PolygonShape a,
      PolygonShape b,
      float c,
      float s,
      float tx,
      float ty,
      float radius) {
    if (referenceIsB) {
      manifold.type = Manifold.ManifoldType.FACE_B;
      float backX = -(c * tx + s * ty);
      float backY = s * tx - c * ty;
      return build(manifold, true, b, queryB.face, a, c, -s, backX, backY, radius);
    }
    manifold.type = Manifold.ManifoldType.FACE_A;
    return build(manifold, false, a, queryA.face, b, c, s, tx, ty, radius);
  }

  /**
   * Writes plane and points for a face of {@code ref}; (c, s, t) moves {@code inc} into its frame.
   *
   * @return height of the lowest point written, positive infinity if there is none
   */
  static float build(
      Manifold manifold,
      boolean referenceIsB,
      PolygonShape ref,
      int face,
      PolygonShape inc,
      float c,
      float s,
      float tx,
      float ty,
      float radius) {
    Vec2 n = ref.m_normals[face];
    Vec2 v1 = ref.m_vertices[face];
    Vec2 v2 = ref.m_vertices[face + 1 < ref.m_count ? face + 1 : 0];
    float nx = n.x;
    float ny = n.y;

    int incFace = FaceQuery.incidentFace(inc, c * nx + s * ny, c * ny - s * nx);
    Vec2 p = inc.m_vertices[incFace];
    Vec2 q = inc.m_vertices[incFace + 1 < inc.m_count ? incFace + 1 : 0];
    float px = (c * p.x - s * p.y + tx) - v1.x;
    float py = (s * p.x + c * p.y + ty) - v1.y;
    float qx = (c * q.x - s * q.y + tx) - v1.x;
    float qy = (s * q.x + c * q.y + ty) - v1.y;

    manifold.localNormal.set(nx, ny);
    manifold.localPoint.set(0.5f * (v1.x + v2.x), 0.5f * (v1.y + v2.y));
    // Counter-clockwise order: the face runs along (-n.y, n.x).
    return FaceClip.clip(
        manifold,
        referenceIsB,
        face,
        ref.m_count,
        nx * (v2.y - v1.y) - ny * (v2.x - v1.x),
        incFace,
        inc.m_count,
        p,
        q,
        nx * py - ny * px,
        nx * px + ny * py,
        nx * qy - ny * qx,
        nx * qx + ny * qy,
        radius);
  }
}
