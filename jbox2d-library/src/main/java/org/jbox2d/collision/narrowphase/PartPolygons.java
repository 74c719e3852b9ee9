package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Transform;

/**
 * Contact of two convex polygons of which at least one is a part of a compound.
 *
 * <p>Each part has contacts of its own. The direction of least penetration of a part may lead
 * through an inner edge, and so out of the part into the next one, which pushes back: a splinter
 * that has got in stays wedged between the two. A blow drives splinters deep enough for that, and
 * so does a step in which a body is driven over a seam. (Ghost collisions with inner edges of
 * meshes, and normals limited by the neighbours' as their remedy: G. van den Bergen, Collision
 * Detection in Interactive 3D Environments, 2004; C. Ericson, Real-Time Collision Detection, 2005,
 * section 9.5.)
 *
 * <p>Here a contact whose least penetration leads through an inner edge is left to the part across,
 * if that holds the other body by a surface:
 *
 * <pre>
 *                 ^ by part 1's surface
 *     +---------+-|------+
 *     |       [-|-Q-]    |      part 0: Q would leave to the right, into part 1: left to part 1
 *     | part 0  | part 1 |
 * </pre>
 *
 * <p>If it would in turn lead on, the search goes on from there. It may come back to where it
 * began: then the other body lies across the inner edge, deeper below the surface than it is wide.
 * Or the part across may not be touched at all. In both cases nothing but this contact would get
 * the body out, so it takes a surface of the whole compound for its reference face: the one through
 * which the body has come in the last step, if it has; otherwise the nearest.
 *
 * <p>An edge counts as leading through if either the reference face or the incident face, which is
 * the one whose normal is nearest to the direction opposed, is an inner one. At a corner of the
 * outline where parts meet, one of them at least has an outer edge nearest to each direction
 * between the outline's normals, so corners are never left out.
 */
public final class PartPolygons {
  /**
   * How many contacts a search passes through at most: parts that meet in one vertex are seldom
   * more than half a dozen.
   */
  private static final int MOST_PASSED = 8;

  private final PolygonPolygon polygons;
  private final FaceQuery queryA = new FaceQuery();
  private final FaceQuery queryB = new FaceQuery();
  private final int[] passedA = new int[MOST_PASSED];
  private final int[] passedB = new int[MOST_PASSED];

  /** A point w of B is at R w + t in A's frame, R = (c, -s; s, c); and back. */
  private float c;

  private float s;
  private float tx;
  private float ty;
  private float backX;
  private float backY;
  private float radius;

  /** What {@link #rate} found: separation, and the parts across if its faces are inner edges. */
  private float separation;

  private PartShape acrossA;
  private PartShape acrossB;

  /** How B has moved against A in the last step, in the world, m. */
  private float wayX;

  private float wayY;

  public PartPolygons(PolygonPolygon polygons) {
    this.polygons = polygons;
  }

  /**
   * As {@link PolygonPolygon#collide}.
   *
   * @param wayX how B has moved against A in the last step, in the world, m
   * @param wayY see {@code wayX}
   */
  public void collide(
      Manifold manifold,
      PolygonShape a,
      Transform xfA,
      PolygonShape b,
      Transform xfB,
      float wayX,
      float wayY) {
    this.wayX = wayX;
    this.wayY = wayY;
    place(a, xfA, b, xfB);
    rate(a, b);
    if (acrossA == null && acrossB == null) {
      polygons.collide(manifold, a, xfA, b, xfB, 0);
      return;
    }
    manifold.pointCount = 0;
    // Beyond an inner edge there is the next part, or what is nearest is a vertex of the outline
    // that it has as well.
    if (separation <= 0f && isLast(a, b) && !buildOnOutline(manifold, a, xfA, b, xfB)) {
      polygons.collide(manifold, a, xfA, b, xfB, 0);
    }
    acrossA = null;
    acrossB = null;
  }

  private void place(PolygonShape a, Transform xfA, PolygonShape b, Transform xfB) {
    float cA = xfA.q.c;
    float sA = xfA.q.s;
    float gx = xfB.p.x - xfA.p.x;
    float gy = xfB.p.y - xfA.p.y;
    c = cA * xfB.q.c + sA * xfB.q.s;
    s = cA * xfB.q.s - sA * xfB.q.c;
    tx = cA * gx + sA * gy;
    ty = cA * gy - sA * gx;
    backX = -(c * tx + s * ty);
    backY = s * tx - c * ty;
    radius = a.m_radius + b.m_radius;
  }

  /** Finds the reference and the incident face of two polygons, and whether they are inner ones. */
  private void rate(PolygonShape a, PolygonShape b) {
    acrossA = null;
    acrossB = null;
    queryA.run(a, b, c, s, tx, ty, radius);
    separation = queryA.separation;
    if (!(separation <= radius)) {
      return;
    }
    queryB.run(b, a, c, -s, backX, backY, radius);
    int faceA = queryA.face;
    int faceB = queryB.face;
    if (queryB.separation > separation + PolygonPolygon.margin(separation)) {
      separation = queryB.separation;
      float nx = b.m_normals[faceB].x;
      float ny = b.m_normals[faceB].y;
      faceA = FaceQuery.incidentFace(a, c * nx - s * ny, c * ny + s * nx);
    } else {
      float nx = a.m_normals[faceA].x;
      float ny = a.m_normals[faceA].y;
      faceB = FaceQuery.incidentFace(b, c * nx + s * ny, c * ny - s * nx);
    }
    if (separation <= radius) {
      acrossA = a instanceof PartShape ? ((PartShape) a).across(faceA) : null;
      acrossB = b instanceof PartShape ? ((PartShape) b).across(faceB) : null;
    }
  }

  /**
   * Whether no other contact gets the two apart, after {@link #rate} has found that the best way
   * out of {@code a} and {@code b} leads through an inner edge.
   */
  private boolean isLast(PolygonShape a, PolygonShape b) {
    int n = 0;
    while (n < MOST_PASSED) {
      passedA[n] = a instanceof PartShape ? ((PartShape) a).index() : 0;
      passedB[n] = b instanceof PartShape ? ((PartShape) b).index() : 0;
      n++;
      if (acrossA != null) {
        a = acrossA;
      } else {
        b = acrossB;
      }
      rate(a, b);
      if (separation > 0f) {
        return n == 1;
      }
      if (acrossA == null && acrossB == null) {
        return false;
      }
      int before = passed(a, b, n);
      if (before >= 0) {
        // Those of the loop are the last ones; the way in leads to it.
        return before == 0;
      }
    }
    return true;
  }

  private int passed(PolygonShape a, PolygonShape b, int n) {
    int indexA = a instanceof PartShape ? ((PartShape) a).index() : 0;
    int indexB = b instanceof PartShape ? ((PartShape) b).index() : 0;
    for (int i = 0; i < n; i++) {
      if (passedA[i] == indexA && passedB[i] == indexB) {
        return i;
      }
    }
    return -1;
  }

  // --- The surface of a compound ---

  /** Builds on a face of either compound's outline. */
  private boolean buildOnOutline(
      Manifold manifold, PolygonShape a, Transform xfA, PolygonShape b, Transform xfB) {
    float least = Float.POSITIVE_INFINITY;
    PartShape reference = null;
    int face = 0;
    boolean referenceIsB = false;
    for (int side = 0; side < 2; side++) {
      boolean ofB = side == 1;
      PolygonShape of = ofB ? b : a;
      PolygonShape other = ofB ? a : b;
      if (!(of instanceof PartShape)) {
        continue;
      }
      Transform xf = ofB ? xfB : xfA;
      float sign = ofB ? -1f : 1f;
      float inX = sign * (xf.q.c * wayX + xf.q.s * wayY);
      float inY = sign * (xf.q.c * wayY - xf.q.s * wayX);
      PartShape compound = (PartShape) of;
      for (int p = 0; p < compound.partCount(); p++) {
        PartShape part = compound.part(p);
        for (int i = 0; part != null && i < part.m_count; i++) {
          if (part.across(i) != null) {
            continue;
          }
          float depth = -separation(part, i, other, ofB);
          float in = -(part.m_normals[i].x * inX + part.m_normals[i].y * inY);
          float order = order(depth, in);
          if (depth >= 0f && order < least && build(manifold, part, i, other, ofB) <= 0f) {
            least = order;
            reference = part;
            face = i;
            referenceIsB = ofB;
          }
        }
      }
    }
    if (reference == null) {
      return false;
    }
    manifold.type = referenceIsB ? Manifold.ManifoldType.FACE_B : Manifold.ManifoldType.FACE_A;
    build(manifold, reference, face, referenceIsB ? a : b, referenceIsB);
    return true;
  }

  /**
   * The order in which surfaces are taken, least first: those passed in the last step by how long
   * ago, then the others by their depth.
   *
   * @param depth below the surface, m, at least 0
   * @param in how far the last step has led inwards, m
   */
  static float order(float depth, float in) {
    return depth < in ? depth / in - 1f : depth;
  }

  private float separation(PartShape part, int face, PolygonShape other, boolean ofB) {
    return FaceQuery.measure(
        part.m_normals[face],
        part.m_vertices[face],
        other.m_vertices,
        other.m_count,
        c,
        ofB ? -s : s,
        ofB ? backX : tx,
        ofB ? backY : ty);
  }

  private float build(
      Manifold manifold, PartShape part, int face, PolygonShape other, boolean ofB) {
    return PolygonPolygon.build(
        manifold,
        ofB,
        part,
        face,
        other,
        c,
        ofB ? -s : s,
        ofB ? backX : tx,
        ofB ? backY : ty,
        radius);
  }
}
