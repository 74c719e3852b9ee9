package org.jbox2d.collision;

import org.jbox2d.collision.narrowphase.Gjk;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Distance and closest points of two convex shapes ({@link Gjk} has the method). An instance keeps
 * scratch memory: use one for each thread.
 */
public class Distance {

  /** Bound of the support steps of one call. */
  public static final int MAX_ITERS = Gjk.MAX_ITERATIONS;

  /** Kept for source and binary compatibility; nothing is counted across worlds and threads. */
  public static int GJK_CALLS;

  /** See {@link #GJK_CALLS}. */
  public static int GJK_ITERS;

  /** See {@link #GJK_CALLS}; {@link DistanceOutput#iterations} has the figure of one call. */
  public static int GJK_MAX_ITERS = MAX_ITERS;

  private final Gjk gjk = new Gjk();

  public Distance() {}

  /**
   * Computes the distance of two proxies.
   *
   * <p>With {@link DistanceInput#useRadii} the skins count: if they are apart, the points lie on
   * them; if not, the distance is zero and both points are the middle between the cores' points.
   *
   * @param output receives distance, points and iterations
   * @param cache start for the search, and its end: keep it from step to step to save iterations,
   *     or set its count to zero. The distance does not depend on it
   * @param input is not changed
   */
  public final void distance(DistanceOutput output, SimplexCache cache, DistanceInput input) {
    Transform xfA = input.transformA;
    Transform xfB = input.transformB;
    double cA = xfA.q.c;
    double sA = xfA.q.s;
    double gx = (double) xfB.p.x - xfA.p.x;
    double gy = (double) xfB.p.y - xfA.p.y;
    // Relative transform by R_A^T, which is the inverse up to the rounding of the float rotation.
    gjk.solve(
        input.proxyA,
        input.proxyB,
        cA * xfB.q.c + sA * xfB.q.s,
        cA * xfB.q.s - sA * xfB.q.c,
        cA * gx + sA * gy,
        cA * gy - sA * gx,
        cache);

    double ax = gjk.pointAX;
    double ay = gjk.pointAY;
    double bx = gjk.pointBX;
    double by = gjk.pointBY;
    double distance = gjk.distance;
    if (input.useRadii) {
      double rA = input.proxyA.m_radius;
      double rB = input.proxyB.m_radius;
      if (distance > rA + rB) {
        double ux = gjk.gapX / distance;
        double uy = gjk.gapY / distance;
        ax += rA * ux;
        ay += rA * uy;
        bx -= rB * ux;
        by -= rB * uy;
        distance -= rA + rB;
      } else {
        ax = 0.5 * (ax + bx);
        ay = 0.5 * (ay + by);
        bx = ax;
        by = ay;
        distance = 0.0;
      }
    }
    output.distance = (float) distance;
    output.iterations = gjk.iterations;
    toWorld(xfA, ax, ay, output.pointA);
    toWorld(xfA, bx, by, output.pointB);
  }

  private static void toWorld(Transform xf, double x, double y, Vec2 out) {
    Rot q = xf.q;
    out.x = (float) (q.c * x - q.s * y + xf.p.x);
    out.y = (float) (q.s * x + q.c * y + xf.p.y);
  }

  /** The corners of a convex shape, and its skin radius: what the distance functions look at. */
  public static class DistanceProxy {

    /** Of length {@link Settings#maxPolygonVertices}; the first {@link #m_count} are in use. */
    public final Vec2[] m_vertices;

    public int m_count;

    /** Skin radius in metres. */
    public float m_radius;

    /** The two ends of the last link of a chain that was set. */
    public final Vec2[] m_buffer;

    public DistanceProxy() {
      m_vertices = new Vec2[Settings.maxPolygonVertices];
      for (int i = 0; i < m_vertices.length; i++) {
        m_vertices[i] = new Vec2();
      }
      m_buffer = new Vec2[] {new Vec2(), new Vec2()};
    }

    /**
     * Copies the corners of a shape.
     *
     * @param shape any of the four kinds
     * @param index for a chain the link, from vertex {@code index} to the next one; otherwise
     *     ignored
     * @throws IllegalArgumentException if a polygon has more vertices than this proxy has room for,
     *     or the chain has no such link
     */
    public final void set(Shape shape, int index) {
      switch (shape.m_type) {
        case CIRCLE:
          m_vertices[0].set(((CircleShape) shape).m_p);
          m_count = 1;
          break;
        case POLYGON:
          copyPolygon((PolygonShape) shape);
          break;
        case CHAIN:
          copyLink((ChainShape) shape, index);
          break;
        case EDGE:
          EdgeShape edge = (EdgeShape) shape;
          m_vertices[0].set(edge.m_vertex1);
          m_vertices[1].set(edge.m_vertex2);
          m_count = 2;
          break;
        default:
          throw new IllegalArgumentException("no distance proxy for shape type " + shape.m_type);
      }
      m_radius = shape.m_radius;
    }

    private void copyPolygon(PolygonShape polygon) {
      if (polygon.m_count > m_vertices.length) {
        throw new IllegalArgumentException(
            "polygon has "
                + polygon.m_count
                + " vertices, the proxy room for "
                + m_vertices.length);
      }
      m_count = polygon.m_count;
      for (int i = 0; i < m_count; i++) {
        m_vertices[i].set(polygon.m_vertices[i]);
      }
    }

    private void copyLink(ChainShape chain, int index) {
      if (index < 0 || index >= chain.m_count) {
        throw new IllegalArgumentException(
            "chain has no link " + index + ", it has " + chain.m_count + " vertices");
      }
      m_buffer[0].set(chain.m_vertices[index]);
      m_buffer[1].set(chain.m_vertices[index + 1 < chain.m_count ? index + 1 : 0]);
      m_vertices[0].set(m_buffer[0]);
      m_vertices[1].set(m_buffer[1]);
      m_count = 2;
    }

    /** Index of the vertex furthest in direction {@code d}; of equals the first. */
    public final int getSupport(Vec2 d) {
      int best = 0;
      float most = Float.NEGATIVE_INFINITY;
      for (int i = 0; i < m_count; i++) {
        float along = d.x * m_vertices[i].x + d.y * m_vertices[i].y;
        if (along > most) {
          most = along;
          best = i;
        }
      }
      return best;
    }

    /** The vertex furthest in direction {@code d}; not a copy. */
    public final Vec2 getSupportVertex(Vec2 d) {
      return m_vertices[getSupport(d)];
    }

    public final int getVertexCount() {
      return m_count;
    }

    /** The vertex itself, not a copy. */
    public final Vec2 getVertex(int index) {
      assert 0 <= index && index < m_count;
      return m_vertices[index];
    }
  }

  /** Where the last search ended: corners of the two proxies that span the closest points. */
  public static class SimplexCache {

    /** Length or area of the simplex, for information. */
    public float metric;

    /** Corners in use, 0 to 3; 0 starts afresh. */
    public int count;

    /** Vertices of A; the first {@link #count} are in use. */
    public final int[] indexA = new int[3];

    /** Vertices of B; the first {@link #count} are in use. */
    public final int[] indexB = new int[3];

    public SimplexCache() {}

    /** Copies {@code sc}. */
    public void set(SimplexCache sc) {
      metric = sc.metric;
      count = sc.count;
      System.arraycopy(sc.indexA, 0, indexA, 0, indexA.length);
      System.arraycopy(sc.indexB, 0, indexB, 0, indexB.length);
    }
  }
}
