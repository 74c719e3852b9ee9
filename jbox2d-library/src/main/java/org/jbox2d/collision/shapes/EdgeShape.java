package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * A segment from {@link #m_vertex1} to {@link #m_vertex2}, solid from both sides. The ghost
 * vertices before and after it keep bodies that slide over a row of edges from being caught at
 * their joints.
 */
public class EdgeShape extends Shape {

  public final Vec2 m_vertex1 = new Vec2();
  public final Vec2 m_vertex2 = new Vec2();

  /** The vertex before {@link #m_vertex1}, if {@link #m_hasVertex0}. */
  public final Vec2 m_vertex0 = new Vec2();

  /** The vertex after {@link #m_vertex2}, if {@link #m_hasVertex3}. */
  public final Vec2 m_vertex3 = new Vec2();

  public boolean m_hasVertex0;
  public boolean m_hasVertex3;

  public EdgeShape() {
    super(ShapeType.EDGE);
    m_radius = Settings.polygonRadius;
  }

  /**
   * Sets both ends, without ghost vertices.
   *
   * @throws IllegalArgumentException if a coordinate is infinite or NaN
   */
  public void set(Vec2 v1, Vec2 v2) {
    if (!v1.isValid() || !v2.isValid()) {
      throw new IllegalArgumentException("edge ends must be finite: " + v1 + ", " + v2);
    }
    m_vertex1.set(v1);
    m_vertex2.set(v2);
    m_hasVertex0 = false;
    m_hasVertex3 = false;
  }

  @Override
  public int getChildCount() {
    return 1;
  }

  /** Always false: a segment has no inside. */
  @Override
  public boolean testPoint(Transform xf, Vec2 p) {
    return false;
  }

  @Override
  public float computeDistanceToOut(Transform xf, Vec2 p, int childIndex, Vec2 normalOut) {
    return Segments.distance(xf, p, m_vertex1, m_vertex2, normalOut);
  }

  @Override
  public boolean raycast(RayCastOutput output, RayCastInput input, Transform xf, int childIndex) {
    return Segments.raycast(output, input, xf, m_vertex1, m_vertex2);
  }

  @Override
  public void computeAABB(AABB aabb, Transform xf, int childIndex) {
    Segments.computeAABB(aabb, xf, m_vertex1, m_vertex2, m_radius);
  }

  /** No mass; the centre is the middle. */
  @Override
  public void computeMass(MassData massData, float density) {
    massData.mass = 0f;
    massData.center.set(0.5f * (m_vertex1.x + m_vertex2.x), 0.5f * (m_vertex1.y + m_vertex2.y));
    massData.I = 0f;
  }

  @Override
  public Shape clone() {
    EdgeShape copy = new EdgeShape();
    copy.m_radius = m_radius;
    copy.m_hasVertex0 = m_hasVertex0;
    copy.m_hasVertex3 = m_hasVertex3;
    copy.m_vertex0.set(m_vertex0);
    copy.m_vertex1.set(m_vertex1);
    copy.m_vertex2.set(m_vertex2);
    copy.m_vertex3.set(m_vertex3);
    return copy;
  }
}
