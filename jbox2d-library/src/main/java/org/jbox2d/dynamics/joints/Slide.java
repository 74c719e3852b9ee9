package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Rot;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/**
 * The coordinate of a point of body B along an axis of body A, {@code q = a . d}, for those who ask
 * between steps.
 */
final class Slide {
  private Slide() {}

  /** Returns q, m. */
  static float translation(Body a, Vec2 localA, Body b, Vec2 localB, Vec2 axis) {
    Rot qa = a.m_xf.q;
    float ux = qa.c * axis.x - qa.s * axis.y;
    float uy = qa.s * axis.x + qa.c * axis.y;
    float dx = worldX(b, localB) - worldX(a, localA);
    float dy = worldY(b, localB) - worldY(a, localA);
    return ux * dx + uy * dy;
  }

  /** Returns {@code qdot = a . ddot + (wA x a) . d}, m/s. */
  static float speed(Body a, Vec2 localA, Body b, Vec2 localB, Vec2 axis) {
    Rot qa = a.m_xf.q;
    float ux = qa.c * axis.x - qa.s * axis.y;
    float uy = qa.s * axis.x + qa.c * axis.y;
    float rbx = worldX(b, localB) - b.m_sweep.c.x;
    float rby = worldY(b, localB) - b.m_sweep.c.y;
    // From the centre of A to the point of B: the point of A that is there now moves with A.
    float armX = worldX(b, localB) - a.m_sweep.c.x;
    float armY = worldY(b, localB) - a.m_sweep.c.y;
    float vx = b.m_linearVelocity.x - a.m_linearVelocity.x;
    float vy = b.m_linearVelocity.y - a.m_linearVelocity.y;
    return ux * vx
        + uy * vy
        + b.m_angularVelocity * (rbx * uy - rby * ux)
        - a.m_angularVelocity * (armX * uy - armY * ux);
  }

  private static float worldX(Body b, Vec2 local) {
    return b.m_xf.p.x + b.m_xf.q.c * local.x - b.m_xf.q.s * local.y;
  }

  private static float worldY(Body b, Vec2 local) {
    return b.m_xf.p.y + b.m_xf.q.s * local.x + b.m_xf.q.c * local.y;
  }
}
