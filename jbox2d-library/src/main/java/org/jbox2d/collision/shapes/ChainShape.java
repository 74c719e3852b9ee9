package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * A line of segments, solid from both sides, whose vertices do not catch what slides over them.
 * Child i is the edge from vertex i to vertex i + 1; its neighbours serve as ghost vertices. A
 * chain must not cross itself.
 */
public class ChainShape extends Shape {

  /** The vertices; owned by this shape. A loop repeats its first vertex at the end. */
  public Vec2[] m_vertices;

  /** Vertices in use. */
  public int m_count;

  /** The ghost vertex before the first, if {@link #m_hasPrevVertex}. */
  public final Vec2 m_prevVertex = new Vec2();

  /** The ghost vertex after the last, if {@link #m_hasNextVertex}. */
  public final Vec2 m_nextVertex = new Vec2();

  public boolean m_hasPrevVertex;
  public boolean m_hasNextVertex;

  /** A chain without vertices. */
  public ChainShape() {
    super(ShapeType.CHAIN);
    m_radius = Settings.polygonRadius;
  }

  /** Forgets all vertices. */
  public void clear() {
    m_vertices = null;
    m_count = 0;
    m_hasPrevVertex = false;
    m_hasNextVertex = false;
  }

  /**
   * Sets a closed line that ends where it begins.
   *
   * @param vertices copied; the first is not to be repeated at the end
   * @param count how many of them count, at least 3
   * @throws IllegalArgumentException if there are too few vertices, one is infinite or NaN, or two
   *     neighbours are closer than {@link Settings#linearSlop}
   */
  public void createLoop(Vec2[] vertices, int count) {
    checkVertices(vertices, count, 3);
    checkApart(vertices, count - 1, 0);
    copyVertices(vertices, count, count + 1);
    m_vertices[count] = vertices[0].clone();
    m_prevVertex.set(m_vertices[count - 1]);
    m_nextVertex.set(m_vertices[1]);
    m_hasPrevVertex = true;
    m_hasNextVertex = true;
  }

  /**
   * Sets an open line, without ghost vertices at its ends.
   *
   * @param vertices copied
   * @param count how many of them count, at least 2
   * @throws IllegalArgumentException if there are too few vertices, one is infinite or NaN, or two
   *     neighbours are closer than {@link Settings#linearSlop}
   */
  public void createChain(Vec2[] vertices, int count) {
    checkVertices(vertices, count, 2);
    copyVertices(vertices, count, count);
    m_prevVertex.setZero();
    m_nextVertex.setZero();
    m_hasPrevVertex = false;
    m_hasNextVertex = false;
  }

  private static void checkVertices(Vec2[] vertices, int count, int least) {
    if (count < least || count > vertices.length) {
      throw new IllegalArgumentException(
          "count must be from "
              + least
              + " to the array's length "
              + vertices.length
              + ": "
              + count);
    }
    for (int i = 0; i < count; i++) {
      if (!vertices[i].isValid()) {
        throw new IllegalArgumentException("vertex " + i + " must be finite: " + vertices[i]);
      }
      if (i > 0) {
        checkApart(vertices, i - 1, i);
      }
    }
  }

  private static void checkApart(Vec2[] vertices, int i, int j) {
    double dx = (double) vertices[i].x - vertices[j].x;
    double dy = (double) vertices[i].y - vertices[j].y;
    double slop = Settings.linearSlop;
    if (!(dx * dx + dy * dy > slop * slop)) {
      throw new IllegalArgumentException(
          "vertices "
              + i
              + " and "
              + j
              + " are closer than "
              + Settings.linearSlop
              + ": "
              + vertices[i]);
    }
  }

  private void copyVertices(Vec2[] vertices, int count, int length) {
    Vec2[] copy = new Vec2[length];
    for (int i = 0; i < count; i++) {
      copy[i] = vertices[i].clone();
    }
    m_vertices = copy;
    m_count = length;
  }

  /**
   * Sets the ghost vertex before the first vertex of an open chain.
   *
   * @throws IllegalArgumentException if it is infinite or NaN
   */
  public void setPrevVertex(Vec2 prevVertex) {
    checkGhost(prevVertex);
    m_prevVertex.set(prevVertex);
    m_hasPrevVertex = true;
  }

  /**
   * Sets the ghost vertex after the last vertex of an open chain.
   *
   * @throws IllegalArgumentException if it is infinite or NaN
   */
  public void setNextVertex(Vec2 nextVertex) {
    checkGhost(nextVertex);
    m_nextVertex.set(nextVertex);
    m_hasNextVertex = true;
  }

  private static void checkGhost(Vec2 vertex) {
    if (!vertex.isValid()) {
      throw new IllegalArgumentException("ghost vertex must be finite: " + vertex);
    }
  }

  /** The number of edges. */
  @Override
  public int getChildCount() {
    return m_count > 1 ? m_count - 1 : 0;
  }

  /** Writes child {@code index} with its ghost vertices. */
  public void getChildEdge(EdgeShape edge, int index) {
    assert 0 <= index && index < m_count - 1;
    edge.m_radius = m_radius;
    edge.m_vertex1.set(m_vertices[index]);
    edge.m_vertex2.set(m_vertices[index + 1]);
    if (index > 0) {
      edge.m_vertex0.set(m_vertices[index - 1]);
      edge.m_hasVertex0 = true;
    } else {
      edge.m_vertex0.set(m_prevVertex);
      edge.m_hasVertex0 = m_hasPrevVertex;
    }
    if (index + 2 < m_count) {
      edge.m_vertex3.set(m_vertices[index + 2]);
      edge.m_hasVertex3 = true;
    } else {
      edge.m_vertex3.set(m_nextVertex);
      edge.m_hasVertex3 = m_hasNextVertex;
    }
  }

  /** Always false: a line has no inside. */
  @Override
  public boolean testPoint(Transform xf, Vec2 p) {
    return false;
  }

  @Override
  public float computeDistanceToOut(Transform xf, Vec2 p, int childIndex, Vec2 normalOut) {
    return Segments.distance(xf, p, m_vertices[childIndex], m_vertices[childIndex + 1], normalOut);
  }

  @Override
  public boolean raycast(RayCastOutput output, RayCastInput input, Transform xf, int childIndex) {
    return Segments.raycast(output, input, xf, m_vertices[childIndex], m_vertices[childIndex + 1]);
  }

  @Override
  public void computeAABB(AABB aabb, Transform xf, int childIndex) {
    Segments.computeAABB(aabb, xf, m_vertices[childIndex], m_vertices[childIndex + 1], m_radius);
  }

  /** No mass; the centre is the origin. */
  @Override
  public void computeMass(MassData massData, float density) {
    massData.mass = 0f;
    massData.center.setZero();
    massData.I = 0f;
  }

  @Override
  public Shape clone() {
    ChainShape copy = new ChainShape();
    copy.m_radius = m_radius;
    if (m_vertices != null) {
      copy.copyVertices(m_vertices, m_count, m_count);
    }
    copy.m_prevVertex.set(m_prevVertex);
    copy.m_nextVertex.set(m_nextVertex);
    copy.m_hasPrevVertex = m_hasPrevVertex;
    copy.m_hasNextVertex = m_hasNextVertex;
    return copy;
  }
}
