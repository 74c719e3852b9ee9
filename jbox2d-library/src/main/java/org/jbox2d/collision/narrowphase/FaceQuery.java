package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;

/**
 * Finds the face of one convex polygon that separates it best from another one.
 *
 * <p>For face i with outward unit normal n_i and vertex v_i the separation is
 *
 * <pre>  s_i = min_j n_i . (w_j - v_i)        (w_j: vertices of the other polygon)</pre>
 *
 * and the answer is max_i s_i: the distance between the polygons along the best face normal, or
 * minus the least penetration (separating axis theorem; Ericson, Real-Time Collision Detection,
 * 2005, section 5.2.1).
 *
 * <p>Since the mean c of the w_j lies in their hull, s_i is at most n_i . (c - v_i), which costs
 * one product instead of one for each vertex. The face that was best in the step before is measured
 * first, and of the others only those whose bound reaches the best separation so far. For two boxes
 * at rest that leaves one or two of four faces; for polygons apart, often the first ends the
 * search. Instead of moving vertices, the normal is turned into the other polygon's frame, where
 * the support is taken from its own vertices.
 *
 * <p>An instance only carries the two results out of {@link #run}.
 */
public final class FaceQuery {

  /**
   * Vertices that are handled without a loop. Boxes are by far the most frequent shape, and loops
   * this short spend more on their control than on the products.
   */
  private static final int UNROLLED = 4;

  /** Separation of the best face in metres; negative: penetration. */
  public float separation;

  /** Index of the best face. */
  public int face;

  /**
   * Measures the faces of {@code polygon} against {@code other}; the position of a point w of the
   * other polygon in this polygon's frame is R w + t with R = (c, -s; s, c).
   *
   * @param limit a separation in metres above which the exact maximum does not matter: the search
   *     stops at the first face that exceeds it
   */
  public void run(
      PolygonShape polygon, PolygonShape other, float c, float s, float tx, float ty, float limit) {
    run(polygon, other, c, s, tx, ty, limit, 0);
  }

  /**
   * As above.
   *
   * @param guess the face that is likely the best, as it was in the last step. It is measured
   *     first; the better it is, the less is left to be measured. The answer does not depend on it,
   *     unless the limit is exceeded: of faces that separate equally it is that of the least index
   */
  public void run(
      PolygonShape polygon,
      PolygonShape other,
      float c,
      float s,
      float tx,
      float ty,
      float limit,
      int guess) {
    Vec2[] v = polygon.m_vertices;
    Vec2[] n = polygon.m_normals;
    int count = polygon.m_count;
    Vec2[] w = other.m_vertices;
    int otherCount = other.m_count;
    int first = guess < count ? guess : 0;
    float best = measure(n[first], v[first], w, otherCount, c, s, tx, ty);
    int bestFace = first;
    if (best <= limit) {
      float sumX = 0f;
      float sumY = 0f;
      int j = 0;
      if (otherCount >= UNROLLED) {
        sumX = (w[0].x + w[1].x) + (w[2].x + w[3].x);
        sumY = (w[0].y + w[1].y) + (w[2].y + w[3].y);
        j = UNROLLED;
      }
      for (; j < otherCount; j++) {
        sumX += w[j].x;
        sumY += w[j].y;
      }
      float share = 1f / otherCount;
      float meanX = sumX * share;
      float meanY = sumY * share;
      float cx = c * meanX - s * meanY + tx;
      float cy = s * meanX + c * meanY + ty;
      for (int i = 0; i < count && best <= limit; i++) {
        float bound = n[i].x * (cx - v[i].x) + n[i].y * (cy - v[i].y);
        if (bound >= best && i != first) {
          float exact = measure(n[i], v[i], w, otherCount, c, s, tx, ty);
          if (exact > best || (exact == best && i < bestFace)) {
            best = exact;
            bestFace = i;
          }
        }
      }
    }
    separation = best;
    face = bestFace;
  }

  /** The separation of one face of {@code polygon}, as {@link #run} computes it. */
  static float measure(
      PolygonShape polygon, int face, PolygonShape other, float c, float s, float tx, float ty) {
    Vec2 n = polygon.m_normals[face];
    Vec2 v = polygon.m_vertices[face];
    return measure(n, v, other.m_vertices, other.m_count, c, s, tx, ty);
  }

  /** The separation of a single face: the least n . (R w_j + t - v). */
  public static float measure(
      Vec2 n, Vec2 v, Vec2[] w, int count, float c, float s, float tx, float ty) {
    float mx = c * n.x + s * n.y;
    float my = c * n.y - s * n.x;
    float least = Float.POSITIVE_INFINITY;
    int j = 0;
    if (count >= UNROLLED) {
      float d0 = mx * w[0].x + my * w[0].y;
      float d1 = mx * w[1].x + my * w[1].y;
      float d2 = mx * w[2].x + my * w[2].y;
      float d3 = mx * w[3].x + my * w[3].y;
      float d01 = d0 < d1 ? d0 : d1;
      float d23 = d2 < d3 ? d2 : d3;
      least = d01 < d23 ? d01 : d23;
      j = UNROLLED;
    }
    for (; j < count; j++) {
      float d = mx * w[j].x + my * w[j].y;
      if (d < least) {
        least = d;
      }
    }
    return least + (n.x * (tx - v.x) + n.y * (ty - v.y));
  }

  /**
   * The face of {@code polygon} that looks most against the direction m, both in the polygon's
   * frame; of equals the first.
   */
  public static int incidentFace(PolygonShape polygon, float mx, float my) {
    Vec2[] n = polygon.m_normals;
    int count = polygon.m_count;
    float least = Float.POSITIVE_INFINITY;
    int face = 0;
    for (int i = 0; i < count; i++) {
      float d = mx * n[i].x + my * n[i].y;
      if (d < least) {
        least = d;
        face = i;
      }
    }
    return face;
  }
}
