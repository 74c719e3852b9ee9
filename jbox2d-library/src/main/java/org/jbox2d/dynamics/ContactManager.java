package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.callbacks.ContactFilter;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.callbacks.PairCallback;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.broadphase.BroadPhaseStrategy;
import org.jbox2d.collision.broadphase.DefaultBroadPhaseBuffer;
import org.jbox2d.common.Settings;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.contacts.ShapeContact;
import org.jbox2d.internal.LongHashSet;
import org.jbox2d.internal.PairSelection;

/**
 * Makes, updates and destroys contacts.
 *
 * <p>Besides JBox2D's linked list of all contacts it keeps a dense array of those with an awake
 * body, which are all that a step looks at, and a hash set of the pairs that have a contact.
 */
public class ContactManager implements PairCallback, PairSelection {
  /** Finds pairs of overlapping bounds. */
  public BroadPhase m_broadPhase;

  /** First contact of the world, the newest. */
  public Contact m_contactList;

  /** Number of contacts of the world. */
  public int m_contactCount;

  /** Decides which fixtures collide; {@code null}: all do. */
  public ContactFilter m_contactFilter;

  /** Hears of contacts; may be {@code null}. */
  public ContactListener m_contactListener;

  Contact[] active = new Contact[64];
  int activeCount;

  /**
   * Whether an active contact did not touch when it was last looked at, its tight boxes being
   * apart, and nothing but the boxes can have changed that since.
   */
  boolean[] apart = new boolean[64];

  /** Both proxies of each active contact, so that a look at their boxes needs no contact. */
  int[] proxies = new int[128];

  /** Whether {@link #active} may hold contacts without an awake body. */
  boolean strays;

  private final World world;
  private final LongHashSet pairs = new LongHashSet();
  private Contact free;

  /** Called by the world. */
  public ContactManager(World argPool, BroadPhase broadPhase) {
    world = argPool;
    m_broadPhase = broadPhase;
    m_contactFilter = new ContactFilter();
  }

  /** Called by the world. */
  public ContactManager(World argPool, BroadPhaseStrategy strategy) {
    this(argPool, new DefaultBroadPhaseBuffer(strategy));
  }

  /**
   * Makes a contact for two proxies, if there is none yet and nothing forbids it. Called by the
   * broad phase.
   */
  @Override
  public void addPair(Object proxyUserDataA, Object proxyUserDataB) {
    FixtureProxy proxyA = (FixtureProxy) proxyUserDataA;
    FixtureProxy proxyB = (FixtureProxy) proxyUserDataB;
    Fixture fixtureA = proxyA.fixture;
    Fixture fixtureB = proxyB.fixture;
    Body bodyA = fixtureA.m_body;
    Body bodyB = fixtureB.m_body;
    if (bodyA == bodyB || pairs.contains(key(proxyA.proxyId, proxyB.proxyId))) {
      return;
    }
    if (!ShapeContact.canCollide(fixtureA.getType(), fixtureB.getType())
        || !passesFilters(fixtureA, fixtureB)) {
      return;
    }
    if (ShapeContact.mustSwap(fixtureA.getType(), fixtureB.getType())) {
      create(proxyB, proxyA);
    } else {
      create(proxyA, proxyB);
    }
  }

  /** Whether two proxies have a contact. Called by the broad phase. */
  @Override
  public boolean knows(int low, int high) {
    return pairs.contains(key(low, high));
  }

  /** Whether the default filter decides. Called by the broad phase. */
  @Override
  public boolean goesByCategories() {
    return m_contactFilter != null && m_contactFilter.getClass() == ContactFilter.class;
  }

  /**
   * Returns the contact of two proxies, which is made if there is none yet; {@code null} if they
   * must not collide.
   */
  Contact contactOf(FixtureProxy p, FixtureProxy q) {
    if (pairs.contains(key(p.proxyId, q.proxyId))) {
      return find(p, q);
    }
    int before = m_contactCount;
    // In the order of the broad phase, so that it does not matter who asks.
    boolean inOrder = p.proxyId < q.proxyId;
    addPair(inOrder ? p : q, inOrder ? q : p);
    return m_contactCount > before ? m_contactList : null;
  }

  private static Contact find(FixtureProxy p, FixtureProxy q) {
    ContactEdge edge = p.fixture.m_body.m_contactList;
    while (edge != null && !joins(edge.contact, p, q) && !joins(edge.contact, q, p)) {
      edge = edge.next;
    }
    return edge == null ? null : edge.contact;
  }

  private static boolean joins(Contact c, FixtureProxy a, FixtureProxy b) {
    return c.m_fixtureA == a.fixture
        && c.m_fixtureB == b.fixture
        && c.m_indexA == a.childIndex
        && c.m_indexB == b.childIndex;
  }

  private void create(FixtureProxy proxyA, FixtureProxy proxyB) {
    Contact c = pop();
    c.init(proxyA.fixture, proxyA.childIndex, proxyB.fixture, proxyB.childIndex);
    c.m_proxyA = proxyA.proxyId;
    c.m_proxyB = proxyB.proxyId;
    pairs.add(key(c.m_proxyA, c.m_proxyB));
    c.m_prev = null;
    c.m_next = m_contactList;
    if (m_contactList != null) {
      m_contactList.m_prev = c;
    }
    m_contactList = c;
    m_contactCount++;
    Body bodyA = proxyA.fixture.m_body;
    Body bodyB = proxyB.fixture.m_body;
    link(c, c.m_nodeA, bodyA, bodyB);
    link(c, c.m_nodeB, bodyB, bodyA);
    if (bodyA.awakeIndex >= 0 || bodyB.awakeIndex >= 0) {
      activate(c);
    } else {
      activateStray(c);
    }
  }

  private static void link(Contact c, ContactEdge node, Body body, Body other) {
    node.contact = c;
    node.other = other;
    node.prev = null;
    node.next = body.m_contactList;
    if (body.m_contactList != null) {
      body.m_contactList.prev = node;
    }
    body.m_contactList = node;
    if (other.isObstacle()) {
      body.obstacles++;
    }
  }

  private static void unlink(ContactEdge node, Body body) {
    if (node.other.isObstacle()) {
      body.obstacles--;
    }
    if (node.prev != null) {
      node.prev.next = node.next;
    } else {
      body.m_contactList = node.next;
    }
    if (node.next != null) {
      node.next.prev = node.prev;
    }
  }

  /** Looks for pairs whose bounds have come to overlap. */
  public void findNewContacts() {
    m_broadPhase.updatePairs(this);
  }

  /**
   * Takes a contact out of everything, tells the listener if it touched, and keeps it for later
   * use. Outside a step the listener may destroy the fixtures itself.
   */
  public void destroy(Contact c) {
    Fixture fixtureA = c.m_fixtureA;
    Fixture fixtureB = c.m_fixtureB;
    if (m_contactListener != null && c.isTouching()) {
      // No longer touching while the listener hears of it, so that it hears but once.
      c.m_flags &= ~Contact.TOUCHING_FLAG;
      m_contactListener.endContact(c);
      if (c.m_fixtureA != fixtureA) {
        return;
      }
    }
    if (c.m_manifold.pointCount > 0 && !fixtureA.m_isSensor && !fixtureB.m_isSensor) {
      fixtureA.m_body.setAwake(true);
      fixtureB.m_body.setAwake(true);
    }
    if (c.m_prev != null) {
      c.m_prev.m_next = c.m_next;
    } else {
      m_contactList = c.m_next;
    }
    if (c.m_next != null) {
      c.m_next.m_prev = c.m_prev;
    }
    m_contactCount--;
    unlink(c.m_nodeA, fixtureA.m_body);
    unlink(c.m_nodeB, fixtureB.m_body);
    deactivate(c);
    pairs.remove(key(c.m_proxyA, c.m_proxyB));
    push(c);
  }

  /**
   * Updates every contact that has an awake body: filters, drops it if the bounds have parted,
   * computes the manifold. A contact that does not touch and whose tight boxes are apart stays as
   * it is: most of the contacts of a heap in motion, for which nothing but the boxes is read.
   * Bounds hold the tight boxes, so those that are near have not parted.
   */
  public void collide() {
    // Far above the rounding of the boxes and of the narrow phase, so that nothing that touches is
    // passed over.
    float slop = Settings.linearSlop;
    world.getPool().getCollision().beginPass();
    int i = 0;
    while (i < activeCount) {
      int a = proxies[2 * i];
      int b = proxies[2 * i + 1];
      boolean near = m_broadPhase.testTightOverlap(a, b, slop);
      if (!near && apart[i] ? m_broadPhase.testOverlap(a, b) : collide(i, near)) {
        i++;
      } else {
        // The last active contact takes this place.
        destroy(active[i]);
      }
    }
    if (strays) {
      dropStrays();
    }
  }

  /** Returns whether a contact stays. */
  private boolean collide(int i, boolean near) {
    Contact c = active[i];
    if ((!near || (c.m_flags & Contact.FILTER_FLAG) != 0) && !mayPersist(c)) {
      return false;
    }
    // A listener may have it filtered again.
    int state = Contact.TOUCHING_FLAG | Contact.ENABLED_FLAG | Contact.FILTER_FLAG;
    if (near || (c.m_flags & state) != Contact.ENABLED_FLAG) {
      c.update(m_contactListener);
    }
    apart[i] = !near && (c.m_flags & state) == Contact.ENABLED_FLAG;
    return true;
  }

  /**
   * Engine-internal: an active contact may have to be filtered, or have come to touch or to part.
   */
  public void lookAt(Contact c) {
    apart[c.m_activeIndex] = false;
  }

  private void dropStrays() {
    strays = false;
    for (int i = activeCount - 1; i >= 0; i--) {
      Contact c = active[i];
      if (c.m_fixtureA.m_body.awakeIndex < 0 && c.m_fixtureB.m_body.awakeIndex < 0) {
        deactivate(c);
      }
    }
  }

  /** Both bodies sleep: the contact need not be looked at, unless it is still to be filtered. */
  void letRest(Contact c) {
    if ((c.m_flags & Contact.FILTER_FLAG) != 0) {
      strays = true;
    } else {
      deactivate(c);
    }
  }

  /** Has a contact looked at in the next step, even if neither body is awake by then. */
  void activateStray(Contact c) {
    activate(c);
    strays = true;
  }

  private boolean mayPersist(Contact c) {
    if ((c.m_flags & Contact.FILTER_FLAG) != 0) {
      if (!passesFilters(c.m_fixtureA, c.m_fixtureB)) {
        return false;
      }
      c.m_flags &= ~Contact.FILTER_FLAG;
    }
    return m_broadPhase.testOverlap(c.m_proxyA, c.m_proxyB);
  }

  private boolean passesFilters(Fixture fixtureA, Fixture fixtureB) {
    ContactFilter filter = m_contactFilter;
    // Nobody hears of the default filter, and it costs less than to look through the joints.
    if (goesByCategories()) {
      return filter.shouldCollide(fixtureA, fixtureB)
          && fixtureB.m_body.shouldCollide(fixtureA.m_body);
    }
    return fixtureB.m_body.shouldCollide(fixtureA.m_body)
        && (filter == null || filter.shouldCollide(fixtureA, fixtureB));
  }

  void activate(Contact c) {
    if (c.m_activeIndex >= 0) {
      return;
    }
    if (activeCount == active.length) {
      int capacity = activeCount + (activeCount >> 1);
      active = Arrays.copyOf(active, capacity);
      apart = Arrays.copyOf(apart, capacity);
      proxies = Arrays.copyOf(proxies, 2 * capacity);
    }
    c.m_activeIndex = activeCount;
    apart[activeCount] = false;
    proxies[2 * activeCount] = c.m_proxyA;
    proxies[2 * activeCount + 1] = c.m_proxyB;
    active[activeCount++] = c;
  }

  void deactivate(Contact c) {
    int i = c.m_activeIndex;
    if (i < 0) {
      return;
    }
    Contact last = active[--activeCount];
    active[i] = last;
    apart[i] = apart[activeCount];
    proxies[2 * i] = proxies[2 * activeCount];
    proxies[2 * i + 1] = proxies[2 * activeCount + 1];
    last.m_activeIndex = i;
    active[activeCount] = null;
    c.m_activeIndex = -1;
  }

  Contact pop() {
    Contact c = free;
    if (c == null) {
      return new ShapeContact(world.getPool());
    }
    free = c.m_next;
    world.contactPoolCount--;
    return c;
  }

  void push(Contact c) {
    c.init(null, 0, null, 0);
    c.m_next = free;
    free = c;
    world.contactPoolCount++;
  }

  private static long key(int proxyA, int proxyB) {
    int low = Math.min(proxyA, proxyB);
    int high = Math.max(proxyA, proxyB);
    return (long) low << 32 | high;
  }
}
