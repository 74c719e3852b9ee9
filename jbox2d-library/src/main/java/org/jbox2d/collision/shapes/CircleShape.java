package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/** A disc about {@link #m_p} of radius {@link Shape#m_radius}. */
public class CircleShape extends Shape {

  /** Centre in body coordinates. */
  public final Vec2 m_p;

  /** A circle of radius 0 about the origin. */
  public CircleShape() {
    super(ShapeType.CIRCLE);
    m_p = new Vec2();
  }

  @Override
  public final Shape clone() {
    CircleShape copy = new CircleShape();
    copy.m_p.set(m_p);
    copy.m_radius = m_radius;
    return copy;
  }

  @Override
  public final int getChildCount() {
    return 1;
  }

  /** The index of the vertex farthest along {@code d}: always 0, the centre. */
  public final int getSupport(Vec2 d) {
    return 0;
  }

  /** The centre itself. */
  public final Vec2 getSupportVertex(Vec2 d) {
    return m_p;
  }

  /** Always 1. */
  public final int getVertexCount() {
    return 1;
  }

  /** The centre itself, for the index 0. */
  public final Vec2 getVertex(int index) {
    if (index != 0) {
      throw new IllegalArgumentException("a circle has one vertex, no index " + index);
    }
    return m_p;
  }

  @Override
  public final boolean testPoint(Transform xf, Vec2 p) {
    double dx = p.x - worldX(xf);
    double dy = p.y - worldY(xf);
    return dx * dx + dy * dy <= (double) m_radius * m_radius;
  }

  @Override
  public float computeDistanceToOut(Transform xf, Vec2 p, int childIndex, Vec2 normalOut) {
    double dx = p.x - worldX(xf);
    double dy = p.y - worldY(xf);
    double length = Math.sqrt(dx * dx + dy * dy);
    if (length > 0) {
      normalOut.set((float) (dx / length), (float) (dy / length));
    } else {
      normalOut.set(1f, 0f);
    }
    return (float) (length - m_radius);
  }

  /** With s from the centre to the start and d the ray, the first root of |s + t d|^2 = r^2. */
  @Override
  public final boolean raycast(
      RayCastOutput output, RayCastInput input, Transform transform, int childIndex) {
    double sx = input.p1.x - worldX(transform);
    double sy = input.p1.y - worldY(transform);
    double dx = (double) input.p2.x - input.p1.x;
    double dy = (double) input.p2.y - input.p1.y;
    double dd = dx * dx + dy * dy;
    double sd = sx * dx + sy * dy;
    double outside = sx * sx + sy * sy - (double) m_radius * m_radius;
    double discriminant = sd * sd - dd * outside;
    if (!(dd > 0 && outside >= 0 && discriminant >= 0)) {
      return false;
    }
    double t = -(sd + Math.sqrt(discriminant)) / dd;
    if (!(t >= 0 && t <= input.maxFraction)) {
      return false;
    }
    double nx = sx + t * dx;
    double ny = sy + t * dy;
    double length = Math.sqrt(nx * nx + ny * ny);
    if (length == 0) {
      return false;
    }
    output.fraction = (float) t;
    output.normal.set((float) (nx / length), (float) (ny / length));
    return true;
  }

  @Override
  public final void computeAABB(AABB aabb, Transform xf, int childIndex) {
    float x = worldX(xf);
    float y = worldY(xf);
    aabb.lowerBound.set(x - m_radius, y - m_radius);
    aabb.upperBound.set(x + m_radius, y + m_radius);
  }

  @Override
  public final void computeMass(MassData massData, float density) {
    double rr = (double) m_radius * m_radius;
    double mass = density * Math.PI * rr;
    massData.mass = (float) mass;
    massData.center.set(m_p);
    massData.I = (float) (mass * (0.5 * rr + (double) m_p.x * m_p.x + (double) m_p.y * m_p.y));
  }

  private float worldX(Transform xf) {
    return xf.q.c * m_p.x - xf.q.s * m_p.y + xf.p.x;
  }

  private float worldY(Transform xf) {
    return xf.q.s * m_p.x + xf.q.c * m_p.y + xf.p.y;
  }
}
