package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/** Contact of two circles: one point, and the centres as the two features. */
public final class CircleCircle {

  private CircleCircle() {}

  /**
   * Writes the manifold of two circles: type CIRCLES with the centres in local coordinates if the
   * centres are no further apart than the sum of the radii, no point otherwise.
   */
  public static void collide(
      Manifold manifold, CircleShape circleA, Transform xfA, CircleShape circleB, Transform xfB) {
    Vec2 a = circleA.m_p;
    Vec2 b = circleB.m_p;
    // Positions are subtracted before the small offsets are added: exact far from the origin.
    float dx =
        (xfB.p.x - xfA.p.x) + ((xfB.q.c * b.x - xfB.q.s * b.y) - (xfA.q.c * a.x - xfA.q.s * a.y));
    float dy =
        (xfB.p.y - xfA.p.y) + ((xfB.q.s * b.x + xfB.q.c * b.y) - (xfA.q.s * a.x + xfA.q.c * a.y));
    float radius = circleA.m_radius + circleB.m_radius;
    if (!(dx * dx + dy * dy <= radius * radius)) {
      manifold.pointCount = 0;
      return;
    }
    writeRoundContact(manifold, a, b);
  }

  /**
   * Writes a contact between two points with radii. The manifold of a circle with anything has one
   * point whose normal turns continuously, so its id is always zero: impulses carry over when the
   * circle rolls from a face on to a vertex.
   */
  static void writeRoundContact(Manifold manifold, Vec2 localA, Vec2 localB) {
    manifold.type = Manifold.ManifoldType.CIRCLES;
    manifold.localNormal.setZero();
    writeSinglePoint(manifold, localA, localB);
  }

  /** Writes the reference point and the only contact point, with the zero id. */
  static void writeSinglePoint(Manifold manifold, Vec2 localPoint, Vec2 contactPoint) {
    manifold.localPoint.set(localPoint);
    manifold.pointCount = 1;
    ManifoldPoint point = manifold.points[0];
    point.localPoint.set(contactPoint);
    point.id.zero();
  }
}
