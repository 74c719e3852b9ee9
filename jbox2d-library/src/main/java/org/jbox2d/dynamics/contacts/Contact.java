package org.jbox2d.dynamics.contacts;

import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.collision.shapes.ShapeType;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.pooling.IWorldPool;

/**
 * Two fixtures whose bounds overlap in the broad phase. It exists from then until the bounds part,
 * whether or not the shapes themselves touch. Contacts are made and recycled by the world.
 */
public abstract class Contact {
  /** Used when islands are built. */
  public static final int ISLAND_FLAG = 0x0001;

  /** The shapes touch. */
  public static final int TOUCHING_FLAG = 0x0002;

  /** Not disabled by the listener for this step. */
  public static final int ENABLED_FLAG = 0x0004;

  /** Must be filtered anew before the next step. */
  public static final int FILTER_FLAG = 0x0008;

  /** A bullet hit. */
  public static final int BULLET_HIT_FLAG = 0x0010;

  /** {@link #m_toi} is valid. */
  public static final int TOI_FLAG = 0x0020;

  /**
   * Engine-internal: as of the last update the fixtures push each other, neither being a sensor.
   * With {@link #WATCHED_FLAG} it saves the search for islands a look at manifold and fixtures.
   */
  public static final int SOLID_FLAG = 0x0040;

  /** Engine-internal: as of the last update one of the fixtures has a material. */
  public static final int WATCHED_FLAG = 0x0080;

  /**
   * Engine-internal: an impact here ended the step of bodies with joints before its time, and has
   * been left to the next step.
   */
  public static final int LEFT_FLAG = 0x0100;

  /** State, of the {@code _FLAG} constants. */
  public int m_flags;

  /** Neighbours in the world's list of contacts. */
  public Contact m_prev;

  /** See {@link #m_prev}. */
  public Contact m_next;

  /** Node in the list of body A. */
  public ContactEdge m_nodeA = new ContactEdge();

  /** Node in the list of body B. */
  public ContactEdge m_nodeB = new ContactEdge();

  /** The fixtures. */
  public Fixture m_fixtureA;

  /** See {@link #m_fixtureA}. */
  public Fixture m_fixtureB;

  /** Engine-internal: the bodies of the fixtures. */
  public Body m_bodyA;

  /** Engine-internal: see {@link #m_bodyA}. */
  public Body m_bodyB;

  /** Children of the fixtures' shapes. */
  public int m_indexA;

  /** See {@link #m_indexA}. */
  public int m_indexB;

  /** Where the shapes touch. */
  public final Manifold m_manifold = new Manifold();

  /** Number of sub-steps of this step. */
  public float m_toiCount;

  /** Time of impact, as a fraction of the step. */
  public float m_toi;

  /** Mixed coefficient of friction. */
  public float m_friction;

  /** Mixed coefficient of restitution. */
  public float m_restitution;

  /** Speed of B's surface relative to A's that friction strives for, m/s, as on a conveyor belt. */
  public float m_tangentSpeed;

  /** Engine-internal: place among the contacts that a step looks at, or -1. */
  public int m_activeIndex = -1;

  /** Engine-internal: the proxies in the broad phase, so that a look at them needs no fixture. */
  public int m_proxyA;

  /** Engine-internal: see {@link #m_proxyA}. */
  public int m_proxyB;

  /** Engine-internal: radii of the shapes' skins when the manifold was made, m. */
  public float m_radiusA;

  /** Engine-internal: see {@link #m_radiusA}. */
  public float m_radiusB;

  /** Engine-internal: sum of the skins that are not the radius of a circle, m. */
  public float m_skin;

  /** Engine-internal: sum of the normal impulses of the last step, N s. */
  public float m_lastImpulse;

  /** The world's pool. */
  protected final IWorldPool pool;

  private Manifold oldManifold;

  /** Makes a contact that has no fixtures yet. */
  protected Contact(IWorldPool argPool) {
    pool = argPool;
  }

  /** Makes this the contact of two fixtures' children, not touching. */
  public void init(Fixture fA, int indexA, Fixture fB, int indexB) {
    m_flags = ENABLED_FLAG;
    m_fixtureA = fA;
    m_fixtureB = fB;
    m_bodyA = fA == null ? null : fA.m_body;
    m_bodyB = fB == null ? null : fB.m_body;
    m_indexA = indexA;
    m_indexB = indexB;
    m_manifold.pointCount = 0;
    m_manifold.corner = false;
    m_prev = null;
    m_next = null;
    clear(m_nodeA);
    clear(m_nodeB);
    m_toiCount = 0;
    m_toi = 1f;
    m_tangentSpeed = 0f;
    m_lastImpulse = 0f;
    if (fA != null && fB != null) {
      resetFriction();
      resetRestitution();
    }
  }

  private static void clear(ContactEdge edge) {
    edge.contact = null;
    edge.prev = null;
    edge.next = null;
    edge.other = null;
  }

  /** Returns the manifold, in local coordinates. Do not change it, but in {@code preSolve}. */
  public Manifold getManifold() {
    return m_manifold;
  }

  /** Computes the manifold in world coordinates. */
  public void getWorldManifold(WorldManifold worldManifold) {
    Body bodyA = m_fixtureA.getBody();
    Body bodyB = m_fixtureB.getBody();
    worldManifold.initialize(
        m_manifold,
        bodyA.getTransform(),
        m_fixtureA.getShape().m_radius,
        bodyB.getTransform(),
        m_fixtureB.getShape().m_radius);
  }

  /** Returns whether the shapes touch. */
  public boolean isTouching() {
    return (m_flags & TOUCHING_FLAG) != 0;
  }

  /** Enables or disables the contact for the current step; of use in {@code preSolve}. */
  public void setEnabled(boolean flag) {
    m_flags = flag ? m_flags | ENABLED_FLAG : m_flags & ~ENABLED_FLAG;
  }

  /** Returns whether the contact is enabled. */
  public boolean isEnabled() {
    return (m_flags & ENABLED_FLAG) != 0;
  }

  /** Returns the next contact in the world's list, or {@code null}. */
  public Contact getNext() {
    return m_next;
  }

  /** Returns the first fixture. */
  public Fixture getFixtureA() {
    return m_fixtureA;
  }

  /** Returns the child of the first fixture's shape. */
  public int getChildIndexA() {
    return m_indexA;
  }

  /** Returns the second fixture. */
  public Fixture getFixtureB() {
    return m_fixtureB;
  }

  /** Returns the child of the second fixture's shape. */
  public int getChildIndexB() {
    return m_indexB;
  }

  /** Overrides the friction until the fixtures' own is mixed again. */
  public void setFriction(float friction) {
    if (!(friction >= 0f) || Float.isInfinite(friction)) {
      throw new IllegalArgumentException(
          "friction must be finite and not negative, is " + friction);
    }
    m_friction = friction;
  }

  /** Returns the friction in use. */
  public float getFriction() {
    return m_friction;
  }

  /** Mixes the fixtures' friction anew. */
  public void resetFriction() {
    m_friction = mixFriction(m_fixtureA.m_friction, m_fixtureB.m_friction);
  }

  /** Overrides the restitution until the fixtures' own is mixed again. */
  public void setRestitution(float restitution) {
    if (!(restitution >= 0f) || Float.isInfinite(restitution)) {
      throw new IllegalArgumentException(
          "restitution must be finite and not negative, is " + restitution);
    }
    m_restitution = restitution;
  }

  /** Returns the restitution in use. */
  public float getRestitution() {
    return m_restitution;
  }

  /** Mixes the fixtures' restitution anew. */
  public void resetRestitution() {
    m_restitution = mixRestitution(m_fixtureA.m_restitution, m_fixtureB.m_restitution);
  }

  /** Sets the tangent speed, m/s, as of a conveyor belt. */
  public void setTangentSpeed(float speed) {
    if (!Float.isFinite(speed)) {
      throw new IllegalArgumentException("speed must be finite, is " + speed);
    }
    m_tangentSpeed = speed;
  }

  /** Returns the tangent speed, m/s. */
  public float getTangentSpeed() {
    return m_tangentSpeed;
  }

  /** Computes the manifold of the two shapes at the given transforms. */
  public abstract void evaluate(Manifold manifold, Transform xfA, Transform xfB);

  /** Whether {@link #m_manifold} need not be evaluated anew at these transforms. */
  boolean isGood(Transform xfA, Transform xfB) {
    return false;
  }

  /** Notes that {@link #m_manifold} has been evaluated at these transforms. */
  void keep(Transform xfA, Transform xfB) {}

  /** A listener may have changed {@link #m_manifold}. */
  void lookAtManifold() {}

  /** Marks the contact for filtering before the next step. */
  public void flagForFiltering() {
    m_flags |= FILTER_FLAG;
    lookAgain();
  }

  /** Whoever still holds a contact that has been destroyed does no harm. */
  private void lookAgain() {
    if (m_activeIndex >= 0) {
      m_bodyA.m_world.getContactManager().lookAt(this);
    }
  }

  /**
   * Computes the manifold at the bodies' transforms, keeps the impulses of points that persist, and
   * tells the listener what has changed.
   *
   * @param listener may be {@code null}
   */
  public void update(ContactListener listener) {
    boolean wasTouching = isTouching();
    boolean sensor = m_fixtureA.m_isSensor || m_fixtureB.m_isSensor;
    boolean watched = m_fixtureA.m_material != null || m_fixtureB.m_material != null;
    m_flags = m_flags & ~(SOLID_FLAG | WATCHED_FLAG) | ENABLED_FLAG;
    boolean touching = sensor ? senses() : renewManifold(listener != null);
    m_flags |= (touching && !sensor ? SOLID_FLAG : 0) | (watched ? WATCHED_FLAG : 0);
    if (touching != wasTouching) {
      changeTouching(touching, sensor, listener);
    }
    if (touching && !sensor && listener != null) {
      listener.preSolve(this, oldManifold);
      lookAtManifold();
      if (!isEnabled()) {
        m_lastImpulse = 0f;
      }
      if (m_manifold.pointCount == 0) {
        m_flags &= ~SOLID_FLAG;
      }
    }
  }

  private boolean senses() {
    m_manifold.pointCount = 0;
    return pool.getCollision()
        .testOverlap(
            m_fixtureA.m_shape, m_indexA, m_fixtureB.m_shape, m_indexB, m_bodyA.m_xf, m_bodyB.m_xf);
  }

  private void changeTouching(boolean touching, boolean sensor, ContactListener listener) {
    if (!sensor) {
      m_bodyA.setAwake(true);
      m_bodyB.setAwake(true);
    }
    lookAgain();
    if (touching) {
      m_flags |= TOUCHING_FLAG;
    } else {
      m_flags &= ~(TOUCHING_FLAG | LEFT_FLAG);
      m_lastImpulse = 0f;
    }
    if (listener != null) {
      if (touching) {
        listener.beginContact(this);
      } else {
        listener.endContact(this);
      }
    }
  }

  /**
   * Evaluates, and gives points that were there before (by their id) their old impulses for warm
   * starting.
   */
  private boolean renewManifold(boolean keepOld) {
    Manifold m = m_manifold;
    if (keepOld) {
      if (oldManifold == null) {
        oldManifold = new Manifold();
      }
      oldManifold.set(m);
    }
    if (isGood(m_bodyA.m_xf, m_bodyB.m_xf)) {
      return m.pointCount > 0;
    }
    int oldCount = m.pointCount;
    int key0 = 0;
    int key1 = 0;
    float normal0 = 0f;
    float normal1 = 0f;
    float tangent0 = 0f;
    float tangent1 = 0f;
    if (oldCount > 0) {
      ManifoldPoint p = m.points[0];
      key0 = p.id.getKey();
      normal0 = p.normalImpulse;
      tangent0 = p.tangentImpulse;
    }
    if (oldCount > 1) {
      ManifoldPoint p = m.points[1];
      key1 = p.id.getKey();
      normal1 = p.normalImpulse;
      tangent1 = p.tangentImpulse;
    }
    evaluate(m, m_bodyA.m_xf, m_bodyB.m_xf);
    keep(m_bodyA.m_xf, m_bodyB.m_xf);
    m_radiusA = m_fixtureA.m_shape.m_radius;
    m_radiusB = m_fixtureB.m_shape.m_radius;
    m_skin =
        (m_fixtureA.m_shape.m_type == ShapeType.CIRCLE ? 0f : m_radiusA)
            + (m_fixtureB.m_shape.m_type == ShapeType.CIRCLE ? 0f : m_radiusB);
    for (int i = 0; i < m.pointCount; i++) {
      ManifoldPoint p = m.points[i];
      int key = p.id.getKey();
      if (oldCount > 0 && key == key0) {
        p.normalImpulse = normal0;
        p.tangentImpulse = tangent0;
      } else if (oldCount > 1 && key == key1) {
        p.normalImpulse = normal1;
        p.tangentImpulse = tangent1;
      } else {
        p.normalImpulse = 0f;
        p.tangentImpulse = 0f;
      }
    }
    return m.pointCount > 0;
  }

  /**
   * Friction of two surfaces: the geometric mean, so that one without friction lets anything slide.
   */
  public static final float mixFriction(float friction1, float friction2) {
    return Settings.mixFriction(friction1, friction2);
  }

  /** Restitution of two surfaces: the larger one, so that a ball bounces off anything. */
  public static final float mixRestitution(float restitution1, float restitution2) {
    return Math.max(restitution1, restitution2);
  }
}
