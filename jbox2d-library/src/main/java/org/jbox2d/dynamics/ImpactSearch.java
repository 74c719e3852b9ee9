package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.TimeOfImpact;
import org.jbox2d.collision.TimeOfImpact.TOIInput;
import org.jbox2d.collision.TimeOfImpact.TOIOutput;
import org.jbox2d.collision.TimeOfImpact.TOIOutputState;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.contacts.ShapeContact;

/**
 * Finds what a body hits first on the rest of its way through the step.
 *
 * <p>Of a body whose boxes in the broad phase cover its whole way, all that it can have met has a
 * contact with it; those contacts are the candidates. For others the broad phase is asked once,
 * with the bounds of the way.
 */
final class ImpactSearch implements TreeCallback {
  /** The contact of the first impact; {@code null} if the search could only say how far is safe. */
  Contact contact;

  /** The body that is hit. */
  Body other;

  /** The child of the searched body's fixture that hits. */
  FixtureProxy mine;

  /** The child of the other body's fixture that is hit. */
  FixtureProxy theirs;

  /** When, as a fraction of the searched body's rest of its way. */
  float time;

  private final ContactManager contacts;
  private final TimeOfImpact timeOfImpact = new TimeOfImpact();
  private final TOIInput input = new TOIInput();
  private final TOIOutput output = new TOIOutput();
  private final Transform start = new Transform();
  private final AABB box = new AABB();
  private final AABB way = new AABB();
  private final AABB end = new AABB();

  private Contact[] ignored = new Contact[8];
  private int ignoredCount;
  private FixtureProxy[] found = new FixtureProxy[32];
  private int foundCount;

  ImpactSearch(ContactManager contacts) {
    this.contacts = contacts;
  }

  /** Forgets which contacts are to be ignored. */
  void reset() {
    Arrays.fill(ignored, 0, ignoredCount, null);
    ignoredCount = 0;
    contact = null;
    other = null;
    mine = null;
    theirs = null;
  }

  /** Lets the searched body pass where this contact is concerned, until the next reset. */
  void ignore(Contact c) {
    if (ignoredCount == ignored.length) {
      ignored = Arrays.copyOf(ignored, 2 * ignoredCount);
    }
    ignored[ignoredCount++] = c;
  }

  /**
   * Searches the rest of the way of a body.
   *
   * @param far whether to ask the broad phase rather than to look at the body's contacts
   * @param resting whether contacts that touch already are candidates
   * @return whether there is an impact; the fields describe the first one
   */
  boolean find(Body b, boolean far, boolean resting) {
    contact = null;
    other = null;
    time = 1f;
    input.sweepB.set(b.m_sweep);
    if (far) {
      searchTree(b);
    } else {
      searchContacts(b, resting);
    }
    return other != null;
  }

  private void searchContacts(Body b, boolean resting) {
    int left = b.isBullet() ? Integer.MAX_VALUE : b.obstacles;
    for (ContactEdge edge = b.m_contactList; left > 0 && edge != null; edge = edge.next) {
      Body o = edge.other;
      if (o.isObstacle()) {
        left--;
      }
      if (!mayHit(b, o)) {
        continue;
      }
      Contact c = edge.contact;
      if (!resting && c.isTouching()) {
        continue;
      }
      FixtureProxy a = c.m_fixtureA.m_proxies[c.m_indexA];
      FixtureProxy z = c.m_fixtureB.m_proxies[c.m_indexB];
      if (c.m_fixtureA.m_body == b) {
        test(b, a, o, z);
      } else {
        test(b, z, o, a);
      }
    }
  }

  private void searchTree(Body b) {
    collect(b);
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      for (int i = 0; i < f.m_proxyCount && !f.m_isSensor; i++) {
        FixtureProxy p = f.m_proxies[i];
        boundsOfWay(b, p, way);
        for (int k = 0; k < foundCount; k++) {
          FixtureProxy q = found[k];
          // The box of what moves is that of the end of its way, so only a still one can be
          // excluded by it.
          if (q.fixture.m_body.m_type != BodyType.STATIC || AABB.testOverlap(way, q.aabb)) {
            test(b, p, q.fixture.m_body, q);
          }
        }
      }
    }
    Arrays.fill(found, 0, foundCount, null);
    foundCount = 0;
  }

  private void collect(Body b) {
    foundCount = 0;
    boundsOfWay(b, box);
    if (b.isBullet()) {
      contacts.m_broadPhase.query(this, box);
    } else {
      contacts.m_broadPhase.queryObstacles(this, box);
    }
    int kept = 0;
    for (int i = 0; i < foundCount; i++) {
      FixtureProxy q = found[i];
      if (mayHit(b, q.fixture.m_body)) {
        if (q.fixture.m_body.m_type == BodyType.STATIC) {
          // Once for all fixtures of the body.
          q.fixture.getAABB(q.childIndex);
        }
        found[kept++] = q;
      }
    }
    Arrays.fill(found, kept, foundCount, null);
    foundCount = kept;
  }

  @Override
  public boolean treeCallback(int proxyId) {
    if (foundCount == found.length) {
      found = Arrays.copyOf(found, 2 * foundCount);
    }
    BroadPhase broadPhase = contacts.m_broadPhase;
    found[foundCount++] = (FixtureProxy) broadPhase.getUserData(proxyId);
    return true;
  }

  /**
   * Two dynamic bodies pass through one another within a step unless one is a bullet. Those that
   * catch up together have been solved together: a bullet and the pieces in front of it, which it
   * would else meet one by one.
   */
  private static boolean mayHit(Body b, Body o) {
    return o != b
        && (o.m_type != BodyType.DYNAMIC
            || (((b.m_flags | o.m_flags) & Body.e_bulletFlag) != 0
                && !(Laggards.timeOf(b) > 0f && Laggards.timeOf(o) > 0f)));
  }

  private void test(Body b, FixtureProxy p, Body o, FixtureProxy q) {
    Fixture fp = p.fixture;
    Fixture fq = q.fixture;
    if (fp.m_isSensor || fq.m_isSensor || !ShapeContact.canCollide(fp.getType(), fq.getType())) {
      return;
    }
    restOfWay(o, b.m_sweep.alpha0, input.sweepA);
    if (passesBy(b, o)) {
      return;
    }
    input.proxyA.set(fq.m_shape, q.childIndex);
    if (isOutOfReach(b, o)) {
      return;
    }
    input.proxyB.set(fp.m_shape, p.childIndex);
    input.tMax = time;
    timeOfImpact.timeOfImpact(output, input);
    boolean touching = output.state == TOIOutputState.TOUCHING;
    boolean unknown = output.state == TOIOutputState.FAILED && output.t > 0f;
    if (!(touching || unknown) || !(output.t < time)) {
      return;
    }
    Contact c = contacts.contactOf(p, q);
    if (c == null || !c.isEnabled() || isIgnored(c)) {
      return;
    }
    time = output.t;
    contact = touching ? c : null;
    other = o;
    mine = p;
    theirs = q;
  }

  /**
   * Whether two bodies stay further apart than they reach: seen from one, the centre of the other
   * goes along a straight line from p to p + d, whose nearest point to the origin is where {@code
   * (p + t d) . d = 0}, or an end. Of a bullet's candidates, which fill the box of a slanting way,
   * that leaves the few along it.
   */
  private boolean passesBy(Body b, Body o) {
    Sweep s = b.m_sweep;
    Sweep way = input.sweepA;
    float px = s.c0.x - way.c0.x;
    float py = s.c0.y - way.c0.y;
    float dx = s.c.x - way.c.x - px;
    float dy = s.c.y - way.c.y - py;
    float dd = dx * dx + dy * dy;
    float t = dd > 0f ? -(px * dx + py * dy) / dd : 0f;
    t = Math.max(0f, Math.min(t, 1f));
    float x = px + t * dx;
    float y = py + t * dy;
    if (o.thickness < 0f) {
      BodyExtents.compute(o);
    }
    float reach = b.reach + o.reach + Settings.linearSlop;
    return x * x + y * y > reach * reach;
  }

  /**
   * Whether the other shape has a side that the whole way of the body lies beyond: both ends of the
   * way of its centre are farther out than it reaches. Most candidates are excluded by this, at a
   * fraction of the cost of a time of impact. What the other body moves adds to the reach.
   */
  private boolean isOutOfReach(Body b, Body o) {
    Sweep s = b.m_sweep;
    Sweep way = input.sweepA;
    float mx = way.c.x - way.c0.x;
    float my = way.c.y - way.c0.y;
    float otherWay = (float) Math.sqrt(mx * mx + my * my) + Math.abs(way.a - way.a0) * o.reach;
    float reach = b.reach + input.proxyA.m_radius + otherWay + Settings.linearSlop;
    Transform xf = o.m_xf;
    Vec2[] corners = input.proxyA.m_vertices;
    int n = input.proxyA.m_count;
    float x0 = localX(xf, s.c0);
    float y0 = localY(xf, s.c0);
    float x1 = localX(xf, s.c);
    float y1 = localY(xf, s.c);
    for (int i = 0; i < n && n > 1; i++) {
      Vec2 v = corners[i];
      Vec2 w = corners[i + 1 < n ? i + 1 : 0];
      // The outward normal of the side, as long as the side.
      float nx = w.y - v.y;
      float ny = v.x - w.x;
      float out = Math.min(nx * (x0 - v.x) + ny * (y0 - v.y), nx * (x1 - v.x) + ny * (y1 - v.y));
      if (out > 0f && out * out > reach * reach * (nx * nx + ny * ny)) {
        return true;
      }
    }
    return false;
  }

  private static float localX(Transform xf, Vec2 p) {
    return xf.q.c * (p.x - xf.p.x) + xf.q.s * (p.y - xf.p.y);
  }

  private static float localY(Transform xf, Vec2 p) {
    return xf.q.c * (p.y - xf.p.y) - xf.q.s * (p.x - xf.p.x);
  }

  private boolean isIgnored(Contact c) {
    for (int i = 0; i < ignoredCount; i++) {
      if (ignored[i] == c) {
        return true;
      }
    }
    return false;
  }

  /**
   * Writes the motion of a body from the time {@code alpha} of the step on. One that does not move
   * stands still. One that was itself stopped at a later time is taken to be on its way from there
   * already.
   */
  static void restOfWay(Body o, float alpha, Sweep out) {
    out.set(o.m_sweep);
    if (o.awakeIndex < 0) {
      out.c0.set(out.c);
      out.a0 = out.a;
    } else if (o.m_sweep.alpha0 < alpha) {
      out.advance(alpha);
    }
    out.alpha0 = alpha;
  }

  /**
   * Whether the enlarged boxes of a body, which cover the end of its way, cover its start as well,
   * and so all of it: then what still bodies it may meet have a contact with it.
   */
  boolean boxesCoverWay(Body b) {
    float turn = b.m_sweep.a - b.m_sweep.a0;
    if (b.m_sweep.alpha0 > 0f || b.reach * turn * turn / 8f > Settings.linearSlop) {
      return false;
    }
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      for (int i = 0; i < f.m_proxyCount; i++) {
        FixtureProxy p = f.m_proxies[i];
        f.m_shape.computeAABB(end, b.m_xf0, p.childIndex);
        if (!contacts.m_broadPhase.covers(p.proxyId, end)) {
          return false;
        }
      }
    }
    return true;
  }

  /** The bounds of all children of a body on its way. */
  void boundsOfWay(Body b, AABB out) {
    boolean first = true;
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      for (int i = 0; i < f.m_proxyCount; i++) {
        boundsOfWay(b, f.m_proxies[i], first ? out : way);
        if (!first) {
          out.combine(way);
        }
        first = false;
      }
    }
    if (first) {
      out.lowerBound.set(b.m_sweep.c);
      out.upperBound.set(b.m_sweep.c);
    }
  }

  /**
   * The bounds of one child of a body on its way: those at start and end, and room for the arcs
   * between. A point at distance R from the centre that turns by an angle d leaves the straight
   * line by at most R (1 - cos(d/2)), which is below R d^2 / 8.
   */
  void boundsOfWay(Body b, FixtureProxy p, AABB out) {
    Sweep sweep = b.m_sweep;
    sweep.getTransform(start, 0f);
    p.fixture.m_shape.computeAABB(out, start, p.childIndex);
    sweep.getTransform(start, 1f);
    p.fixture.m_shape.computeAABB(end, start, p.childIndex);
    out.combine(end);
    float turn = sweep.a - sweep.a0;
    float arc = b.reach * turn * turn / 8f;
    out.lowerBound.x -= arc;
    out.lowerBound.y -= arc;
    out.upperBound.x += arc;
    out.upperBound.y += arc;
  }
}
