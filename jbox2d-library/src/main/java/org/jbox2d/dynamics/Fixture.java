package org.jbox2d.dynamics;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.narrowphase.KeptManifold;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.collision.shapes.ShapeType;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;

/**
 * A shape fixed to a body, with its density, friction and other properties. Made by {@link
 * Body#createFixture}.
 */
public class Fixture {
  /** Density, kg/m^2. */
  public float m_density;

  /** The next fixture of the body, or {@code null}. */
  public Fixture m_next;

  /** The body. */
  public Body m_body;

  /** The shape, a clone of the one given. */
  public Shape m_shape;

  /** Coefficient of friction. */
  public float m_friction;

  /** Coefficient of restitution. */
  public float m_restitution;

  /**
   * One for each child of the shape; only the first {@link #m_proxyCount} are in the broad phase.
   */
  public FixtureProxy[] m_proxies;

  /** Number of proxies in the broad phase. */
  public int m_proxyCount;

  /**
   * Which fixtures this one collides with. Call {@link #refilter()} after a change: the search for
   * pairs goes by a copy of it.
   */
  public final Filter m_filter = new Filter();

  /** Whether the fixture only reports contacts. */
  public boolean m_isSensor;

  /** Whatever the user keeps here. */
  public Object m_userData;

  /**
   * Hears of the fixture's solved contacts, such as a material that breaks; {@code null} for none.
   * May be set at any time.
   */
  public FixtureMaterial m_material;

  /** What the material remembers of this fixture; {@code null} for nothing. */
  public Object m_materialState;

  /** Place among the fixtures that leave a body together, or -1. */
  int leavingIndex = -1;

  /** Whether somebody else may hold, and change, the filter. */
  private boolean filterShared;

  private CompoundShape compound;
  private int summedPass = -1;
  private int shapeSum;

  /** A fixture that belongs to no body; use {@link Body#createFixture}. */
  public Fixture() {}

  /** Returns the shape's type. */
  public ShapeType getType() {
    return m_shape.getType();
  }

  /** Returns the shape. It may be edited; mass changes only by {@link Body#resetMassData()}. */
  public Shape getShape() {
    return m_shape;
  }

  /**
   * Returns the compound this fixture is a part of, or {@code null}. Fixtures made together return
   * the same object.
   */
  public CompoundShape getCompound() {
    return compound;
  }

  void setCompound(CompoundShape compound) {
    this.compound = compound;
  }

  /** Returns the material, or {@code null}. */
  public FixtureMaterial getMaterial() {
    return m_material;
  }

  /** Sets the material; {@code null} for none. */
  public void setMaterial(FixtureMaterial material) {
    m_material = material;
    if (material != null) {
      // Those that sleep may be woken, and solved, before they are updated.
      flagContacts(0, Contact.WATCHED_FLAG);
    }
  }

  private void flagContacts(int clear, int set) {
    ContactEdge edge = m_body == null ? null : m_body.m_contactList;
    for (; edge != null; edge = edge.next) {
      Contact c = edge.contact;
      if (c.m_fixtureA == this || c.m_fixtureB == this) {
        c.m_flags = c.m_flags & ~clear | set;
      }
    }
  }

  /** Returns whether the fixture only reports contacts. */
  public boolean isSensor() {
    return m_isSensor;
  }

  /** Makes the fixture a sensor or not; wakes the body, and those that touch the fixture. */
  public void setSensor(boolean sensor) {
    if (sensor != m_isSensor) {
      if (m_body != null) {
        m_body.setAwake(true);
        BodyContacts.disturb(m_body, this);
      }
      m_isSensor = sensor;
      // Within a step it takes effect at once.
      flagContacts(sensor ? Contact.SOLID_FLAG : 0, 0);
    }
  }

  /** Copies a filter and filters existing contacts anew before the next step. */
  public void setFilterData(Filter filter) {
    Checks.notNull(filter, "filter");
    m_filter.set(filter);
    refilter();
  }

  /**
   * Returns the filter itself. It may be changed; existing contacts are filtered anew by {@link
   * #refilter()}. From the first call on, the search for pairs no longer leaves this fixture's out
   * by their categories, since those may change at any time, and has the filter drop them one by
   * one; reading {@link #m_filter} has no such cost.
   */
  public Filter getFilterData() {
    if (!filterShared) {
      filterShared = true;
      if (m_body != null && m_body.m_world != null) {
        passFilter(m_body.m_world.m_contactManager.m_broadPhase);
      }
    }
    return m_filter;
  }

  /** Tells the broad phase by which categories it may leave out pairs. */
  private void passFilter(BroadPhase broadPhase) {
    // Fixtures of a positive group collide whatever their categories are.
    boolean any = filterShared || m_filter.groupIndex > 0;
    for (int i = 0; i < m_proxyCount; i++) {
      broadPhase.setFilter(
          m_proxies[i].proxyId, any ? -1 : m_filter.categoryBits, any ? -1 : m_filter.maskBits);
    }
  }

  /** Filters existing contacts anew before the next step, and looks for new ones. */
  public void refilter() {
    if (m_body == null || m_body.getWorld() == null) {
      return;
    }
    for (ContactEdge edge = m_body.getContactList(); edge != null; edge = edge.next) {
      Contact contact = edge.contact;
      if (contact.m_fixtureA == this || contact.m_fixtureB == this) {
        contact.flagForFiltering();
        m_body.getWorld().wakeForFiltering(contact);
      }
    }
    BroadPhase broadPhase = m_body.getWorld().m_contactManager.m_broadPhase;
    passFilter(broadPhase);
    for (int i = 0; i < m_proxyCount; i++) {
      broadPhase.touchProxy(m_proxies[i].proxyId);
    }
    m_body.getWorld().lookForPairs();
  }

  /** Returns the body. */
  public Body getBody() {
    return m_body;
  }

  /** Returns the next fixture of the body, or {@code null}. */
  public Fixture getNext() {
    return m_next;
  }

  /** Sets the density, kg/m^2; takes effect by {@link Body#resetMassData()}. */
  public void setDensity(float density) {
    Checks.notNegative(density, "density");
    m_density = density;
  }

  /** Returns the density, kg/m^2. */
  public float getDensity() {
    return m_density;
  }

  /** Returns the user data. */
  public Object getUserData() {
    return m_userData;
  }

  /** Sets the user data. */
  public void setUserData(Object data) {
    m_userData = data;
  }

  /** Returns the coefficient of friction. */
  public float getFriction() {
    return m_friction;
  }

  /** Sets the coefficient of friction, for contacts made from now on. */
  public void setFriction(float friction) {
    Checks.notNegative(friction, "friction");
    m_friction = friction;
  }

  /** Returns the coefficient of restitution. */
  public float getRestitution() {
    return m_restitution;
  }

  /** Sets the coefficient of restitution, for contacts made from now on. */
  public void setRestitution(float restitution) {
    Checks.notNegative(restitution, "restitution");
    m_restitution = restitution;
  }

  /** Returns whether a world point lies in the shape. */
  public boolean testPoint(Vec2 p) {
    return m_shape.testPoint(m_body.m_xf, p);
  }

  /** Casts a ray against a child of the shape. */
  public boolean raycast(RayCastOutput output, RayCastInput input, int childIndex) {
    return m_shape.raycast(output, input, m_body.m_xf, childIndex);
  }

  /**
   * Returns the distance of a world point from a child of the shape, m, negative inside where the
   * shape has an inside.
   *
   * @param normalOut receives the direction from the shape to the point
   */
  public float computeDistance(Vec2 p, int childIndex, Vec2 normalOut) {
    return m_shape.computeDistanceToOut(m_body.getTransform(), p, childIndex, normalOut);
  }

  /** Computes mass, centre and inertia (about the body's origin) of the shape at this density. */
  public void getMassData(MassData massData) {
    m_shape.computeMass(massData, m_density);
  }

  /**
   * Returns the bounds of a child that is in the broad phase, where the body is now; the next call
   * for this child writes them anew.
   */
  public AABB getAABB(int childIndex) {
    if (childIndex < 0 || childIndex >= m_proxyCount) {
      throw new IllegalArgumentException(
          "childIndex must be in [0, " + m_proxyCount + "), is " + childIndex);
    }
    AABB aabb = m_proxies[childIndex].aabb;
    m_shape.computeAABB(aabb, m_body.m_xf, childIndex);
    return aabb;
  }

  /** Does nothing; kept for programs compiled against 2.2.1.1. */
  public void dump(int bodyIndex) {}

  /** Takes over a definition, whose shape is cloned. */
  public void create(Body body, FixtureDef def) {
    create(body, def, def.shape.clone());
  }

  /** Takes over a definition with a shape, instead of its own, that is nobody else's. */
  final void create(Body body, FixtureDef def, Shape shape) {
    m_userData = def.userData;
    m_friction = def.friction;
    m_restitution = def.restitution;
    m_density = def.density;
    m_isSensor = def.isSensor;
    m_material = def.material;
    m_filter.set(def.filter);
    m_body = body;
    m_next = null;
    m_shape = shape;
    int children = m_shape.getChildCount();
    m_proxies = new FixtureProxy[children];
    for (int i = 0; i < children; i++) {
      m_proxies[i] = new FixtureProxy();
    }
    m_proxyCount = 0;
  }

  /** Lets go of shape and proxies. Called by the engine. */
  public void destroy() {
    m_proxies = null;
    m_shape = null;
    m_next = null;
  }

  /** Enters the shape's children into the broad phase. Called by the engine. */
  public void createProxies(BroadPhase broadPhase, Transform xf) {
    m_proxyCount = m_shape.getChildCount();
    for (int i = 0; i < m_proxyCount; i++) {
      FixtureProxy proxy = m_proxies[i];
      m_shape.computeAABB(proxy.aabb, xf, i);
      proxy.fixture = this;
      proxy.childIndex = i;
      proxy.proxyId = broadPhase.createProxy(proxy.aabb, proxy);
      if (m_body.isObstacle()) {
        broadPhase.setObstacle(proxy.proxyId, true);
      }
    }
    passFilter(broadPhase);
  }

  /** Tells the broad phase whether the body stops others within a step. */
  final void markObstacle(BroadPhase broadPhase) {
    for (int i = 0; i < m_proxyCount; i++) {
      broadPhase.setObstacle(m_proxies[i].proxyId, m_body.isObstacle());
    }
  }

  /** Removes the shape's children from the broad phase. Called by the engine. */
  public void destroyProxies(BroadPhase broadPhase) {
    for (int i = 0; i < m_proxyCount; i++) {
      FixtureProxy proxy = m_proxies[i];
      broadPhase.destroyProxy(proxy.proxyId);
      proxy.proxyId = BroadPhase.NULL_PROXY;
    }
    m_proxyCount = 0;
  }

  /**
   * Engine-internal: checksum of a polygon, to be told when a program has changed it in place; it
   * is summed once in each pass over the contacts.
   */
  public final int polygonChecksum(int pass) {
    if (summedPass != pass) {
      summedPass = pass;
      shapeSum = KeptManifold.checksum((PolygonShape) m_shape);
    }
    return shapeSum;
  }

  /**
   * Moves the proxies to where the body is now. The displacement lets the broad phase foresee where
   * it will be next.
   *
   * @param transform1 transform before the step
   * @param transform2 transform now
   */
  protected void synchronize(BroadPhase broadPhase, Transform transform1, Transform transform2) {
    Vec2 displacement = m_body.m_world.displacement;
    displacement.x = transform2.p.x - transform1.p.x;
    displacement.y = transform2.p.y - transform1.p.y;
    AABB bounds = m_body.m_world.bounds;
    for (int i = 0; i < m_proxyCount; i++) {
      m_shape.computeAABB(bounds, transform2, i);
      broadPhase.moveProxy(m_proxies[i].proxyId, bounds, displacement);
    }
  }
}
