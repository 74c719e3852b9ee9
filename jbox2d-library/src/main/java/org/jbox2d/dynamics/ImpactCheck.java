package org.jbox2d.dynamics;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Tells impacts from mere touches: what a body lies on, slides along or leaves must not stop it.
 *
 * <p>Two cases are no impacts. (1) The shapes touch from the start, and no point of the contact
 * approaches: the solver has seen to that. (2) The body slides along one fixture towards the side
 * of the next one that continues it, a seam:
 *
 * <pre>
 *        +-------+
 *        | body  | --->
 *   =====+-------+==========     m: normal of the contact that the body slides along
 *     tile k     |   tile k+1    n: normal of the hit, against the motion
 * </pre>
 *
 * Along m the cores of body and tile k+1 are apart, and do not approach: so they stay apart, and
 * the hit is that of skins. The depth that counts as apart is that of two skins.
 */
final class ImpactCheck {
  /** Approach over the rest of the step that is left to the next step, in linear slops. */
  private static final float HARMLESS_APPROACH = 0.5f;

  /** Overlap of the skins along the sliding normal up to which the cores are apart, in slops. */
  private static final float SKINS = 4f;

  /** Cosine of the angle between two normals within which they mean the same side (30 degrees). */
  private static final float SAME_SIDE = 0.866f;

  private final Manifold manifold = new Manifold();
  private final WorldManifold hit = new WorldManifold();
  private final WorldManifold sliding = new WorldManifold();
  private final DistanceProxy proxy = new DistanceProxy();

  /**
   * Whether what the search found is an impact. Both bodies have been placed where they are then.
   *
   * @param h time left of the step, s
   */
  boolean isImpact(Body b, ImpactSearch found, float h, StepConfig step) {
    Contact c = found.contact;
    Fixture a = c.m_fixtureA;
    Fixture z = c.m_fixtureB;
    c.evaluate(manifold, a.m_body.m_xf, z.m_body.m_xf);
    if (manifold.pointCount == 0) {
      return false;
    }
    hit.initialize(manifold, a.m_body.m_xf, a.m_shape.m_radius, z.m_body.m_xf, z.m_shape.m_radius);
    turnTowards(b, c, hit);
    if (!(found.time > 0f) && approach(b, found.other) * h <= HARMLESS_APPROACH * step.linearSlop) {
      return false;
    }
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      if (edge.contact != c && isSeam(b, edge, found, h, step)) {
        return false;
      }
    }
    return true;
  }

  /** Lets the normal of a contact's manifold point to the body {@code b}. */
  private static void turnTowards(Body b, Contact c, WorldManifold m) {
    if (c.m_fixtureA.m_body == b) {
      m.normal.negateLocal();
    }
  }

  /** The greatest speed at which a point of the hit comes nearer, m/s. */
  private float approach(Body b, Body o) {
    float most = Float.NEGATIVE_INFINITY;
    Vec2 n = hit.normal;
    for (int i = 0; i < manifold.pointCount; i++) {
      Vec2 p = hit.points[i];
      float vx = velocityX(b, p) - velocityX(o, p);
      float vy = velocityY(b, p) - velocityY(o, p);
      most = Math.max(most, -(n.x * vx + n.y * vy));
    }
    return most;
  }

  private static float velocityX(Body b, Vec2 p) {
    return b.m_linearVelocity.x - b.m_angularVelocity * (p.y - b.m_xf.p.y - offsetY(b));
  }

  private static float velocityY(Body b, Vec2 p) {
    return b.m_linearVelocity.y + b.m_angularVelocity * (p.x - b.m_xf.p.x - offsetX(b));
  }

  /** From the origin to the centre of mass, as the body is placed. */
  private static float offsetX(Body b) {
    Vec2 l = b.m_sweep.localCenter;
    return b.m_xf.q.c * l.x - b.m_xf.q.s * l.y;
  }

  private static float offsetY(Body b) {
    Vec2 l = b.m_sweep.localCenter;
    return b.m_xf.q.s * l.x + b.m_xf.q.c * l.y;
  }

  private boolean isSeam(Body b, ContactEdge edge, ImpactSearch found, float h, StepConfig step) {
    Contact k = edge.contact;
    if (edge.other.m_type == BodyType.DYNAMIC
        || !k.isTouching()
        || !k.isEnabled()
        || k.m_manifold.pointCount == 0) {
      return false;
    }
    k.getWorldManifold(sliding);
    turnTowards(b, k, sliding);
    Vec2 m = sliding.normal;
    if (Vec2.dot(m, hit.normal) > SAME_SIDE) {
      return false;
    }
    Body o = found.other;
    float apart =
        -(m.x * (b.m_linearVelocity.x - o.m_linearVelocity.x)
            + m.y * (b.m_linearVelocity.y - o.m_linearVelocity.y));
    if (apart * h > HARMLESS_APPROACH * step.linearSlop) {
      return false;
    }
    proxy.set(found.mine.fixture.m_shape, found.mine.childIndex);
    float low = -farthest(b.m_xf, -m.x, -m.y) - proxy.m_radius;
    proxy.set(found.theirs.fixture.m_shape, found.theirs.childIndex);
    float high = farthest(o.m_xf, m.x, m.y) + proxy.m_radius;
    return low - high >= -SKINS * step.linearSlop;
  }

  /** Greatest coordinate of the proxy's corners along a direction. */
  private float farthest(Transform xf, float dx, float dy) {
    float lx = xf.q.c * dx + xf.q.s * dy;
    float ly = xf.q.c * dy - xf.q.s * dx;
    float most = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < proxy.m_count; i++) {
      Vec2 v = proxy.m_vertices[i];
      most = Math.max(most, lx * v.x + ly * v.y);
    }
    return most + dx * xf.p.x + dy * xf.p.y;
  }
}
