package org.jbox2d.dynamics;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Tells impacts from mere touches: what a body lies on, slides along or leaves must not stop it.
 *
 * <p>Three cases are no impacts. (1) The shapes touch from the start, and no point of the contact
 * approaches. (2) The contact has been solved in this step, so the body lies on it or leaves it,
 * and what approach is left does not carry it far for its thickness. (3) The body slides along one
 * fixture towards the side of the next one that continues it, a seam:
 *
 * <pre>
 *        +-------+
 *        | body  | ---&gt;
 *   =====+-------+==========     m: normal of the contact that the body slides along
 *     tile k     |   tile k+1    n: normal of the hit, against the motion
 * </pre>
 *
 * Along m the body is no deeper in tile k+1 than in tile k, or no deeper than two skins, and does
 * not get much deeper: so it slides over it, and the hit is one of skins.
 */
final class ImpactCheck {
  /** Approach over the rest of the step that is left to the next step, in linear slops. */
  private static final float HARMLESS_APPROACH = 0.5f;

  /** The same for a contact that has been solved in this step, as a share of the thickness. */
  private static final float HARMLESS_SINKING = 0.25f;

  /** Overlap along the sliding normal that two skins have before the cores touch, in slops. */
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
    float approach = approach(b, found.other, found.time, h);
    float sinking = HARMLESS_SINKING * b.thickness;
    if (approach <= (c.isTouching() ? sinking : HARMLESS_APPROACH * step.linearSlop)
        && (c.isTouching() || !(found.time > 0f))) {
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

  /**
   * How far a point of the hit comes nearer on the rest of the way, m, at most: by the velocities,
   * or by the body's way, which the position solver has made a different one. A body with joints is
   * not sent on by its velocity, so its way alone counts.
   */
  private float approach(Body b, Body o, float t, float h) {
    Sweep s = b.m_sweep;
    float wayX = (1f - t) * (s.c.x - s.c0.x);
    float wayY = (1f - t) * (s.c.y - s.c0.y);
    float turn = (1f - t) * (s.a - s.a0);
    Vec2 v = b.m_linearVelocity;
    float most = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < manifold.pointCount; i++) {
      Vec2 p = hit.points[i];
      float other =
          along(o, p, h * o.m_linearVelocity.x, h * o.m_linearVelocity.y, h * o.m_angularVelocity);
      float far = along(b, p, wayX, wayY, turn);
      if (b.m_jointList == null) {
        far = Math.min(far, along(b, p, h * v.x, h * v.y, h * b.m_angularVelocity));
      }
      most = Math.max(most, other - far);
    }
    return most;
  }

  /** The way of a point of a body along the normal of the hit. */
  private float along(Body b, Vec2 p, float wayX, float wayY, float turn) {
    float rx = p.x - b.m_xf.p.x - offsetX(b);
    float ry = p.y - b.m_xf.p.y - offsetY(b);
    return hit.normal.x * (wayX - turn * ry) + hit.normal.y * (wayY + turn * rx);
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
    if (apart * h > HARMLESS_SINKING * b.thickness) {
      return false;
    }
    boolean isA = k.m_fixtureA.m_body == b;
    Fixture support = isA ? k.m_fixtureB : k.m_fixtureA;
    int child = isA ? k.m_indexB : k.m_indexA;
    float low = -farthest(found.mine.fixture, found.mine.childIndex, -m.x, -m.y);
    float inHit = low - farthest(found.theirs.fixture, found.theirs.childIndex, m.x, m.y);
    float inSupport = low - farthest(support, child, m.x, m.y);
    float slop = step.linearSlop;
    return inHit >= Math.min(-SKINS * slop, inSupport - slop);
  }

  /** Greatest coordinate of a child's surface along a direction. */
  private float farthest(Fixture f, int child, float dx, float dy) {
    Transform xf = f.m_body.m_xf;
    proxy.set(f.m_shape, child);
    float lx = xf.q.c * dx + xf.q.s * dy;
    float ly = xf.q.c * dy - xf.q.s * dx;
    float most = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < proxy.m_count; i++) {
      Vec2 v = proxy.m_vertices[i];
      most = Math.max(most, lx * v.x + ly * v.y);
    }
    return most + dx * xf.p.x + dy * xf.p.y + proxy.m_radius;
  }
}
