package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.pooling.arrays.IntArray;
import org.jbox2d.pooling.arrays.Vec2Array;

/**
 * A solid convex polygon, counter-clockwise, with a skin of {@link Settings#polygonRadius} that
 * keeps it in touch with others.
 *
 * <p>Programs may write {@link #m_vertices}, {@link #m_normals}, {@link #m_centroid} and {@link
 * #m_count} themselves; then {@link #validate} tells whether the result is convex.
 */
public class PolygonShape extends Shape {

  /** Centre of area in body coordinates. */
  public final Vec2 m_centroid = new Vec2();

  /** Of length {@link Settings#maxPolygonVertices}; the first {@link #m_count} are in use. */
  public final Vec2[] m_vertices;

  /** Outward unit normal of the edge from vertex i to vertex i + 1. */
  public final Vec2[] m_normals;

  /** Number of vertices. */
  public int m_count;

  /** A polygon without vertices. */
  public PolygonShape() {
    this(Settings.maxPolygonVertices);
  }

  private PolygonShape(int capacity) {
    super(ShapeType.POLYGON);
    m_radius = Settings.polygonRadius;
    m_vertices = newVectors(capacity);
    m_normals = newVectors(capacity);
  }

  private static Vec2[] newVectors(int length) {
    Vec2[] vectors = new Vec2[length];
    for (int i = 0; i < length; i++) {
      vectors[i] = new Vec2();
    }
    return vectors;
  }

  @Override
  public final Shape clone() {
    PolygonShape copy = new PolygonShape(m_vertices.length);
    copy.m_centroid.set(m_centroid);
    for (int i = 0; i < m_count; i++) {
      copy.m_vertices[i].set(m_vertices[i]);
      copy.m_normals[i].set(m_normals[i]);
    }
    copy.m_radius = m_radius;
    copy.m_count = m_count;
    return copy;
  }

  /**
   * Sets the convex hull of some points. It is counter-clockwise and starts at the lowest of the
   * rightmost points. Points closer than half of {@link Settings#linearSlop} to an earlier one are
   * merged into it; points on an edge of the hull, up to rounding, are dropped.
   *
   * <p>JBox2D makes a box of points that have no area; this class refuses them.
   *
   * @param vertices copied; any order
   * @param count how many of them count, from 3 to {@link Settings#maxPolygonVertices}
   * @throws IllegalArgumentException if the count is out of range, a coordinate is infinite or NaN,
   *     fewer than 3 points are distinct, or all lie on a line; the shape then stays as it was
   */
  public final void set(Vec2[] vertices, int count) {
    int most = Math.min(m_vertices.length, vertices.length);
    if (count < 3 || count > most) {
      throw new IllegalArgumentException("count must be from 3 to " + most + ": " + count);
    }
    ConvexHull hull = ConvexHull.of(vertices, count);
    hull.copyTo(m_vertices);
    m_count = hull.size();
    computeNormals();
    computeCentroidToOut(m_vertices, m_count, m_centroid);
  }

  /** As {@link #set(Vec2[], int)}; the pools are not used and may be null. */
  public final void set(Vec2[] verts, int num, Vec2Array vecPool, IntArray intPool) {
    set(verts, num);
  }

  private void computeNormals() {
    for (int i = 0; i < m_count; i++) {
      Vec2 from = m_vertices[i];
      Vec2 to = m_vertices[i + 1 < m_count ? i + 1 : 0];
      double nx = (double) to.y - from.y;
      double ny = (double) from.x - to.x;
      double length = Math.sqrt(nx * nx + ny * ny);
      m_normals[i].set((float) (nx / length), (float) (ny / length));
    }
  }

  /**
   * Sets a rectangle about the origin, counter-clockwise from its lower left corner.
   *
   * @param hx half of the width in metres
   * @param hy half of the height in metres
   * @throws IllegalArgumentException if a size is not positive or not finite
   */
  public final void setAsBox(float hx, float hy) {
    checkHalfSize("hx", hx);
    checkHalfSize("hy", hy);
    m_count = 4;
    m_vertices[0].set(-hx, -hy);
    m_vertices[1].set(hx, -hy);
    m_vertices[2].set(hx, hy);
    m_vertices[3].set(-hx, hy);
    m_normals[0].set(0f, -1f);
    m_normals[1].set(1f, 0f);
    m_normals[2].set(0f, 1f);
    m_normals[3].set(-1f, 0f);
    m_centroid.setZero();
  }

  /**
   * Sets a rectangle about {@code center}, turned by {@code angle}.
   *
   * @param hx half of the width in metres
   * @param hy half of the height in metres
   * @param center in body coordinates
   * @param angle in radians
   * @throws IllegalArgumentException if a size is not positive, or anything is not finite
   */
  public final void setAsBox(float hx, float hy, Vec2 center, float angle) {
    if (!center.isValid()) {
      throw new IllegalArgumentException("center must be finite: " + center);
    }
    if (!(Math.abs(angle) <= Float.MAX_VALUE)) {
      throw new IllegalArgumentException("angle must be finite: " + angle);
    }
    setAsBox(hx, hy);
    m_centroid.set(center);
    Transform xf = new Transform(center, new Rot(angle));
    for (int i = 0; i < m_count; i++) {
      Transform.mulToOut(xf, m_vertices[i], m_vertices[i]);
      Rot.mulToOut(xf.q, m_normals[i], m_normals[i]);
    }
  }

  private static void checkHalfSize(String name, float value) {
    if (!(value > 0 && value <= Float.MAX_VALUE)) {
      throw new IllegalArgumentException(name + " must be positive and finite: " + value);
    }
  }

  /** Always 1. */
  @Override
  public int getChildCount() {
    return 1;
  }

  public final int getVertexCount() {
    return m_count;
  }

  /** The vertex itself, not a copy. */
  public final Vec2 getVertex(int index) {
    assert 0 <= index && index < m_count;
    return m_vertices[index];
  }

  /** The array itself. */
  public Vec2[] getVertices() {
    return m_vertices;
  }

  /** The array itself. */
  public Vec2[] getNormals() {
    return m_normals;
  }

  /** Centre of area in world coordinates. */
  public Vec2 centroid(Transform xf) {
    return Transform.mul(xf, m_centroid);
  }

  /** Writes the centre of area in world coordinates, and returns {@code out}. */
  public Vec2 centroidToOut(Transform xf, Vec2 out) {
    Transform.mulToOutUnsafe(xf, m_centroid, out);
    return out;
  }

  @Override
  public final boolean testPoint(Transform xf, Vec2 p) {
    Rot q = xf.q;
    float ox = p.x - xf.p.x;
    float oy = p.y - xf.p.y;
    float px = q.c * ox + q.s * oy;
    float py = q.c * oy - q.s * ox;
    for (int i = 0; i < m_count; i++) {
      Vec2 v = m_vertices[i];
      Vec2 n = m_normals[i];
      if (n.x * (px - v.x) + n.y * (py - v.y) > 0f) {
        return false;
      }
    }
    return true;
  }

  @Override
  public final void computeAABB(AABB aabb, Transform xf, int childIndex) {
    float c = xf.q.c;
    float s = xf.q.s;
    float minX = Float.POSITIVE_INFINITY;
    float minY = Float.POSITIVE_INFINITY;
    float maxX = Float.NEGATIVE_INFINITY;
    float maxY = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < m_count; i++) {
      Vec2 v = m_vertices[i];
      float x = c * v.x - s * v.y;
      float y = s * v.x + c * v.y;
      minX = x < minX ? x : minX;
      minY = y < minY ? y : minY;
      maxX = x > maxX ? x : maxX;
      maxY = y > maxY ? y : maxY;
    }
    aabb.lowerBound.set(minX + xf.p.x - m_radius, minY + xf.p.y - m_radius);
    aabb.upperBound.set(maxX + xf.p.x + m_radius, maxY + xf.p.y + m_radius);
  }

  /**
   * Outside, the nearest point is on the segment nearest to the point; inside, the distance is that
   * to the nearest face.
   */
  @Override
  public float computeDistanceToOut(Transform xf, Vec2 p, int childIndex, Vec2 normalOut) {
    Rot q = xf.q;
    float ox = p.x - xf.p.x;
    float oy = p.y - xf.p.y;
    float px = q.c * ox + q.s * oy;
    float py = q.c * oy - q.s * ox;
    float separation = Float.NEGATIVE_INFINITY;
    int face = 0;
    for (int i = 0; i < m_count; i++) {
      Vec2 v = m_vertices[i];
      Vec2 n = m_normals[i];
      float height = n.x * (px - v.x) + n.y * (py - v.y);
      if (height > separation) {
        separation = height;
        face = i;
      }
    }
    if (separation <= 0f) {
      Rot.mulToOut(q, m_normals[face], normalOut);
      return separation;
    }
    int nearest = face;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < m_count; i++) {
      double squared = squaredDistanceToEdge(i, px, py);
      if (squared < least) {
        least = squared;
        nearest = i;
      }
    }
    return Segments.distance(xf, p, m_vertices[nearest], m_vertices[next(nearest)], normalOut);
  }

  private double squaredDistanceToEdge(int i, double px, double py) {
    Vec2 from = m_vertices[i];
    Vec2 to = m_vertices[next(i)];
    double ex = (double) to.x - from.x;
    double ey = (double) to.y - from.y;
    double dx = px - from.x;
    double dy = py - from.y;
    double ee = ex * ex + ey * ey;
    double t = ee > 0 ? Math.max(0, Math.min(1, (dx * ex + dy * ey) / ee)) : 0;
    double rx = dx - t * ex;
    double ry = dy - t * ey;
    return rx * rx + ry * ry;
  }

  private int next(int i) {
    return i + 1 < m_count ? i + 1 : 0;
  }

  /**
   * Cuts the ray by the half-plane of each face (M. Cyrus and J. Beck, Generalized two- and
   * three-dimensional clipping, Computers and Graphics 3, 1978): it enters the polygon at the last
   * face that it crosses inwards.
   */
  @Override
  public final boolean raycast(
      RayCastOutput output, RayCastInput input, Transform xf, int childIndex) {
    Rot q = xf.q;
    double ox = (double) input.p1.x - xf.p.x;
    double oy = (double) input.p1.y - xf.p.y;
    double wx = (double) input.p2.x - input.p1.x;
    double wy = (double) input.p2.y - input.p1.y;
    double px = q.c * ox + q.s * oy;
    double py = q.c * oy - q.s * ox;
    double dx = q.c * wx + q.s * wy;
    double dy = q.c * wy - q.s * wx;
    double enter = 0;
    double leave = input.maxFraction;
    int face = -1;
    for (int i = 0; i < m_count; i++) {
      Vec2 v = m_vertices[i];
      Vec2 n = m_normals[i];
      double depth = n.x * (v.x - px) + n.y * (v.y - py);
      double speed = n.x * dx + n.y * dy;
      if (speed == 0) {
        if (depth < 0) {
          return false;
        }
      } else if (speed < 0) {
        if (depth < enter * speed) {
          enter = depth / speed;
          face = i;
        }
      } else if (depth < leave * speed) {
        leave = depth / speed;
      }
      if (leave < enter) {
        return false;
      }
    }
    if (face < 0) {
      return false;
    }
    output.fraction = (float) enter;
    Rot.mulToOut(q, m_normals[face], output.normal);
    return true;
  }

  /**
   * Writes the centre of area of a polygon of {@code count} vertices. Offsets from the first vertex
   * keep the precision far from the origin; without an area it is the mean of the vertices.
   */
  public final void computeCentroidToOut(Vec2[] vs, int count, Vec2 out) {
    double originX = vs[0].x;
    double originY = vs[0].y;
    double momentX = 0;
    double momentY = 0;
    double doubleArea = 0;
    for (int i = 2; i < count; i++) {
      double ax = vs[i - 1].x - originX;
      double ay = vs[i - 1].y - originY;
      double bx = vs[i].x - originX;
      double by = vs[i].y - originY;
      double cross = ax * by - ay * bx;
      doubleArea += cross;
      momentX += cross * (ax + bx);
      momentY += cross * (ay + by);
    }
    if (doubleArea != 0) {
      double scale = 1.0 / (3.0 * doubleArea);
      out.set((float) (originX + scale * momentX), (float) (originY + scale * momentY));
      return;
    }
    double sumX = 0;
    double sumY = 0;
    for (int i = 0; i < count; i++) {
      sumX += vs[i].x;
      sumY += vs[i].y;
    }
    out.set((float) (sumX / count), (float) (sumY / count));
  }

  /**
   * Fan of triangles from the first vertex. A triangle 0, a, b of area A has the second moments
   *
   * <pre>
   * integral of x^2 + y^2 = A/6 (a.a + a.b + b.b)
   * </pre>
   *
   * about the first vertex; Steiner's theorem moves the sum to the centre of mass and from there to
   * the origin. Without an area the mass is 0.
   */
  @Override
  public void computeMass(MassData massData, float density) {
    double originX = m_vertices[0].x;
    double originY = m_vertices[0].y;
    double momentX = 0;
    double momentY = 0;
    double doubleArea = 0;
    double second = 0;
    for (int i = 2; i < m_count; i++) {
      double ax = m_vertices[i - 1].x - originX;
      double ay = m_vertices[i - 1].y - originY;
      double bx = m_vertices[i].x - originX;
      double by = m_vertices[i].y - originY;
      double cross = ax * by - ay * bx;
      doubleArea += cross;
      momentX += cross * (ax + bx);
      momentY += cross * (ay + by);
      second += cross * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by);
    }
    if (!(doubleArea > 0)) {
      massData.mass = 0f;
      massData.I = 0f;
      massData.center.set(m_centroid);
      return;
    }
    double cx = momentX / (3.0 * doubleArea);
    double cy = momentY / (3.0 * doubleArea);
    double mass = 0.5 * density * doubleArea;
    double aboutCenter = density * second / 12.0 - mass * (cx * cx + cy * cy);
    double worldX = originX + cx;
    double worldY = originY + cy;
    massData.mass = (float) mass;
    massData.center.set((float) worldX, (float) worldY);
    massData.I = (float) (aboutCenter + mass * (worldX * worldX + worldY * worldY));
  }

  /** Whether the vertices are strictly convex and counter-clockwise. */
  public boolean validate() {
    if (m_count < 3) {
      return false;
    }
    for (int i = 0; i < m_count; i++) {
      Vec2 from = m_vertices[i];
      Vec2 to = m_vertices[next(i)];
      double ex = (double) to.x - from.x;
      double ey = (double) to.y - from.y;
      for (int j = 0; j < m_count; j++) {
        boolean isEnd = j == i || j == next(i);
        Vec2 v = m_vertices[j];
        if (!isEnd && !(ex * ((double) v.y - from.y) - ey * ((double) v.x - from.x) > 0)) {
          return false;
        }
      }
    }
    return true;
  }
}
