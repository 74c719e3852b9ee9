package org.jbox2d.dynamics;

import java.util.List;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.JointEdge;

/**
 * A rigid body. Made by {@link World#createBody}.
 *
 * <p>The public fields are the record of the body between steps; JBox2D's users read them, and
 * write some: a velocity written into {@link #m_linearVelocity} or {@link #m_angularVelocity} takes
 * effect in the next step of a body that is awake.
 */
public class Body {
  public static final int e_islandFlag = 0x0001;
  public static final int e_awakeFlag = 0x0002;
  public static final int e_autoSleepFlag = 0x0004;
  public static final int e_bulletFlag = 0x0008;
  public static final int e_fixedRotationFlag = 0x0010;
  public static final int e_activeFlag = 0x0020;
  public static final int e_toiFlag = 0x0040;

  /** Static, kinematic or dynamic; change it by {@link #setType}. */
  public BodyType m_type;

  /** State, of the {@code e_...Flag} constants. */
  public int m_flags;

  /** Engine-internal: slot in the solver during a step. */
  public int m_islandIndex;

  /** Transform of the body's origin. */
  public final Transform m_xf = new Transform();

  /** Transform at the start of the last step. */
  public final Transform m_xf0 = new Transform();

  /** Motion of the centre of mass over the last step. */
  public final Sweep m_sweep = new Sweep();

  /** Velocity of the centre of mass, m/s. */
  public final Vec2 m_linearVelocity = new Vec2();

  /** Angular velocity, rad/s. */
  public float m_angularVelocity;

  /** Force gathered for the next step, N. */
  public final Vec2 m_force = new Vec2();

  /** Torque gathered for the next step, N m. */
  public float m_torque;

  /** The world. */
  public World m_world;

  /** Neighbours in the world's list of bodies. */
  public Body m_prev;

  /** See {@link #m_prev}. */
  public Body m_next;

  /** First fixture, the newest. */
  public Fixture m_fixtureList;

  /** Number of fixtures. */
  public int m_fixtureCount;

  /** First node of the list of joints. */
  public JointEdge m_jointList;

  /** First node of the list of contacts. */
  public ContactEdge m_contactList;

  /** Mass, kg, and its inverse (0 for infinite). */
  public float m_mass;

  /** See {@link #m_mass}. */
  public float m_invMass;

  /** Inertia about the centre of mass, kg m^2, and its inverse (0 for infinite). */
  public float m_I;

  /** See {@link #m_I}. */
  public float m_invI;

  /** Damping of the linear velocity, 1/s. */
  public float m_linearDamping;

  /** Damping of the angular velocity, 1/s. */
  public float m_angularDamping;

  /** Factor on gravity. */
  public float m_gravityScale;

  /** How long the body has been calm, s. */
  public float m_sleepTime;

  /** How long it has been still, and how long it has crept at most; see {@link IslandSleep}. */
  final Rest still = new Rest();

  final Rest creep = new Rest();

  /** Whatever the user keeps here. */
  public Object m_userData;

  /** Substeps that its island got, for how many steps it needed less, whether a blow asked. */
  int effort;

  int effortAge;
  boolean effortOfSpeed;

  /** Place among the bodies that a step looks at, or -1. */
  int awakeIndex = -1;

  /** The step in which {@link #m_islandIndex} was given to a body that does not move. */
  long slotStamp;

  /** See {@link BodyExtents}; the thickness is negative when they have to be computed anew. */
  float thickness = -1f;

  /** See {@link #thickness}. */
  float reach;

  /** Number of contacts whose other body {@link #isObstacle}; most bodies of a pile have none. */
  int obstacles;

  /** How many impacts the continuous phase has handled for this body in the current step. */
  int impacts;

  /**
   * In how many steps in a row the continuous phase has stopped it, the last one {@link #heldAt}.
   */
  int heldSteps;

  /** See {@link #heldSteps}. */
  int heldAt;

  /** By how much the body catches up in this step; {@code null} if it does not. */
  Laggards.Lag lag;

  /** Made by {@link World#createBody}. */
  public Body(BodyDef bd, World world) {
    m_type = bd.type;
    m_world = world;
    m_userData = bd.userData;
    m_flags =
        (bd.bullet ? e_bulletFlag : 0)
            | (bd.fixedRotation ? e_fixedRotationFlag : 0)
            | (bd.allowSleep ? e_autoSleepFlag : 0)
            | (bd.awake ? e_awakeFlag : 0)
            | (bd.active ? e_activeFlag : 0);
    m_xf.set(bd.position, bd.angle);
    m_xf0.set(m_xf);
    m_sweep.localCenter.setZero();
    m_sweep.c0.set(m_xf.p);
    m_sweep.c.set(m_xf.p);
    m_sweep.a0 = bd.angle;
    m_sweep.a = bd.angle;
    m_sweep.alpha0 = 0f;
    m_linearVelocity.set(bd.linearVelocity);
    m_angularVelocity = bd.angularVelocity;
    m_linearDamping = bd.linearDamping;
    m_angularDamping = bd.angularDamping;
    m_gravityScale = bd.gravityScale;
    if (m_type == BodyType.DYNAMIC) {
      m_mass = 1f;
      m_invMass = 1f;
    }
  }

  // --- Fixtures ---

  /**
   * Adds a fixture; the shape is cloned. If the density is positive, the mass of the body is
   * computed anew.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value of the definition is not allowed; nothing has
   *     changed then
   */
  public final Fixture createFixture(FixtureDef def) {
    checkChangeable("createFixture");
    return BodyFixtures.create(this, def);
  }

  /** Adds a fixture with the given shape and density, kg/m^2, and defaults for the rest. */
  public final Fixture createFixture(Shape shape, float density) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = density;
    return createFixture(def);
  }

  /**
   * Adds a fixture for each part of a compound, all with the attributes of {@code def} ({@link
   * FixtureDef#shape} is not looked at). They remember their compound ({@link
   * Fixture#getCompound()}).
   *
   * @return the fixtures, in the order of the parts
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value is not allowed; nothing has changed then
   */
  public final List<Fixture> createFixture(FixtureDef def, CompoundShape compound) {
    checkChangeable("createFixture");
    return BodyFixtures.createAll(this, def, compound);
  }

  /**
   * Removes a fixture with its contacts and computes the mass anew.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the fixture is not of this body
   */
  public final void destroyFixture(Fixture fixture) {
    BodyFixtures.checkOwn(this, fixture);
    checkChangeable("destroyFixture");
    BodyFixtures.remove(this, fixture);
  }

  /**
   * Removes fixtures with their contacts, one after the other, and then computes the mass anew,
   * once. A fixture that a listener has destroyed meanwhile is passed over.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a fixture is not of this body; nothing has changed then
   */
  public final void destroyFixtures(List<Fixture> fixtures) {
    Checks.notNull(fixtures, "fixtures");
    for (Fixture fixture : fixtures) {
      BodyFixtures.checkOwn(this, fixture);
    }
    checkChangeable("destroyFixtures");
    BodyFixtures.removeAll(this, fixtures);
  }

  /** Throws if the body is of no world any more, or the world is locked. */
  private void checkChangeable(String call) {
    if (m_world == null) {
      throw new IllegalStateException(call + " on a body that was destroyed");
    }
    m_world.checkUnlocked(call);
  }

  // --- Position ---

  /**
   * Puts the body's origin somewhere. Contacts are found anew in the next step; bodies that touched
   * this one wake if it moves.
   *
   * @throws IllegalStateException if the world is locked
   */
  public final void setTransform(Vec2 position, float angle) {
    checkChangeable("setTransform");
    Checks.finite(position, "position");
    Checks.finite(angle, "angle");
    BodyChanges.place(this, position, angle);
  }

  /** Returns the transform of the body's origin, the same object each time. */
  public final Transform getTransform() {
    return m_xf;
  }

  /** Returns the world position of the body's origin, the same object each time. */
  public final Vec2 getPosition() {
    return m_xf.p;
  }

  /** Returns the angle, rad. */
  public final float getAngle() {
    return m_sweep.a;
  }

  /** Returns the world position of the centre of mass, the same object each time. */
  public final Vec2 getWorldCenter() {
    return m_sweep.c;
  }

  /** Returns the centre of mass in the body's frame. */
  public final Vec2 getLocalCenter() {
    return m_sweep.localCenter;
  }

  // --- Velocity, forces, impulses ---

  /** Sets the velocity of the centre of mass, m/s; wakes the body. No effect on static bodies. */
  public final void setLinearVelocity(Vec2 v) {
    Checks.finite(v, "v");
    if (m_type == BodyType.STATIC) {
      return;
    }
    if (v.x != 0f || v.y != 0f) {
      setAwake(true);
    }
    m_linearVelocity.set(v);
  }

  /** Returns the velocity of the centre of mass, the same object each time. */
  public final Vec2 getLinearVelocity() {
    return m_linearVelocity;
  }

  /** Sets the angular velocity, rad/s; wakes the body. No effect on static bodies. */
  public final void setAngularVelocity(float w) {
    Checks.finite(w, "w");
    if (m_type == BodyType.STATIC) {
      return;
    }
    if (w != 0f) {
      setAwake(true);
    }
    m_angularVelocity = w;
  }

  /** Returns the angular velocity, rad/s. */
  public final float getAngularVelocity() {
    return m_angularVelocity;
  }

  /**
   * Applies a force, N, at a world point, for the next step; wakes the body. No effect on bodies
   * that are inactive or not dynamic.
   */
  public final void applyForce(Vec2 force, Vec2 point) {
    Checks.finite(force, "force");
    Checks.finite(point, "point");
    if (!takesForces()) {
      return;
    }
    setAwake(true);
    m_force.x += force.x;
    m_force.y += force.y;
    m_torque += (point.x - m_sweep.c.x) * force.y - (point.y - m_sweep.c.y) * force.x;
  }

  /** As {@link #applyForce}, at the centre of mass. */
  public final void applyForceToCenter(Vec2 force) {
    Checks.finite(force, "force");
    if (!takesForces()) {
      return;
    }
    setAwake(true);
    m_force.x += force.x;
    m_force.y += force.y;
  }

  /**
   * Applies a torque, N m, for the next step; wakes the body. No effect on bodies that are inactive
   * or not dynamic.
   */
  public final void applyTorque(float torque) {
    Checks.finite(torque, "torque");
    if (!takesForces()) {
      return;
    }
    setAwake(true);
    m_torque += torque;
  }

  /** Only awake bodies' forces are cleared by a step; so no other body may gather any. */
  private boolean takesForces() {
    return m_type == BodyType.DYNAMIC && isActive();
  }

  /** Applies an impulse, N s, at a world point, at once; wakes the body. */
  public final void applyLinearImpulse(Vec2 impulse, Vec2 point) {
    applyLinearImpulse(impulse, point, true);
  }

  /**
   * Applies an impulse, N s, at a world point, at once.
   *
   * @param wake whether to wake the body; a body that stays asleep is not changed
   */
  public final void applyLinearImpulse(Vec2 impulse, Vec2 point, boolean wake) {
    Checks.finite(impulse, "impulse");
    Checks.finite(point, "point");
    if (m_type != BodyType.DYNAMIC) {
      return;
    }
    if (!isAwake()) {
      if (!wake) {
        return;
      }
      setAwake(true);
    }
    m_linearVelocity.x += impulse.x * m_invMass;
    m_linearVelocity.y += impulse.y * m_invMass;
    m_angularVelocity +=
        m_invI * ((point.x - m_sweep.c.x) * impulse.y - (point.y - m_sweep.c.y) * impulse.x);
  }

  /** Applies an angular impulse, N m s, at once; wakes the body. */
  public void applyAngularImpulse(float impulse) {
    Checks.finite(impulse, "impulse");
    if (m_type != BodyType.DYNAMIC) {
      return;
    }
    setAwake(true);
    m_angularVelocity += m_invI * impulse;
  }

  // --- Mass ---

  /** Returns the mass, kg; 0 for static and kinematic bodies. */
  public final float getMass() {
    return m_mass;
  }

  /** Returns the inertia about the body's origin, kg m^2. */
  public final float getInertia() {
    return m_I + m_mass * m_sweep.localCenter.lengthSquared();
  }

  /** Writes mass, centre and inertia about the body's origin to {@code data}. */
  public final void getMassData(MassData data) {
    data.mass = m_mass;
    data.I = getInertia();
    data.center.set(m_sweep.localCenter);
  }

  /**
   * Overrides mass, centre and inertia until they are computed anew. A mass that is not positive
   * counts as 1 kg; no effect on bodies that are not dynamic.
   *
   * @param massData inertia about the body's origin
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value is not finite, or the inertia is less than the mass
   *     at its centre has
   */
  public final void setMassData(MassData massData) {
    checkChangeable("setMassData");
    BodyMass.override(this, massData);
  }

  /** Computes mass, centre and inertia from the fixtures' shapes and densities. */
  public final void resetMassData() {
    BodyMass.reset(this);
  }

  // --- Frames ---

  /** Returns the world position of a local point, as a new vector. */
  public final Vec2 getWorldPoint(Vec2 localPoint) {
    Vec2 out = new Vec2();
    getWorldPointToOut(localPoint, out);
    return out;
  }

  /** Writes the world position of a local point to {@code out}. */
  public final void getWorldPointToOut(Vec2 localPoint, Vec2 out) {
    Transform.mulToOut(m_xf, localPoint, out);
  }

  /** Returns a local vector in world coordinates, as a new vector. */
  public final Vec2 getWorldVector(Vec2 localVector) {
    Vec2 out = new Vec2();
    getWorldVectorToOut(localVector, out);
    return out;
  }

  /** Writes a local vector in world coordinates to {@code out}. */
  public final void getWorldVectorToOut(Vec2 localVector, Vec2 out) {
    Rot.mulToOut(m_xf.q, localVector, out);
  }

  /** As {@link #getWorldVectorToOut}; {@code out} must not be {@code localVector}. */
  public final void getWorldVectorToOutUnsafe(Vec2 localVector, Vec2 out) {
    Rot.mulToOutUnsafe(m_xf.q, localVector, out);
  }

  /** Returns a world point in the body's frame, as a new vector. */
  public final Vec2 getLocalPoint(Vec2 worldPoint) {
    Vec2 out = new Vec2();
    getLocalPointToOut(worldPoint, out);
    return out;
  }

  /** Writes a world point in the body's frame to {@code out}. */
  public final void getLocalPointToOut(Vec2 worldPoint, Vec2 out) {
    Transform.mulTransToOut(m_xf, worldPoint, out);
  }

  /** Returns a world vector in the body's frame, as a new vector. */
  public final Vec2 getLocalVector(Vec2 worldVector) {
    Vec2 out = new Vec2();
    getLocalVectorToOut(worldVector, out);
    return out;
  }

  /** Writes a world vector in the body's frame to {@code out}. */
  public final void getLocalVectorToOut(Vec2 worldVector, Vec2 out) {
    Rot.mulTrans(m_xf.q, worldVector, out);
  }

  /** As {@link #getLocalVectorToOut}; {@code out} must not be {@code worldVector}. */
  public final void getLocalVectorToOutUnsafe(Vec2 worldVector, Vec2 out) {
    Rot.mulTransUnsafe(m_xf.q, worldVector, out);
  }

  /** Returns the velocity of a world point that moves with the body, m/s, as a new vector. */
  public final Vec2 getLinearVelocityFromWorldPoint(Vec2 worldPoint) {
    Vec2 out = new Vec2();
    getLinearVelocityFromWorldPointToOut(worldPoint, out);
    return out;
  }

  /** Writes the velocity of a world point that moves with the body to {@code out}, m/s. */
  public final void getLinearVelocityFromWorldPointToOut(Vec2 worldPoint, Vec2 out) {
    float dx = worldPoint.x - m_sweep.c.x;
    float dy = worldPoint.y - m_sweep.c.y;
    out.set(
        m_linearVelocity.x - m_angularVelocity * dy, m_linearVelocity.y + m_angularVelocity * dx);
  }

  /** Returns the velocity of a local point, m/s, as a new vector. */
  public final Vec2 getLinearVelocityFromLocalPoint(Vec2 localPoint) {
    Vec2 out = new Vec2();
    getLinearVelocityFromLocalPointToOut(localPoint, out);
    return out;
  }

  /** Writes the velocity of a local point to {@code out}, m/s. */
  public final void getLinearVelocityFromLocalPointToOut(Vec2 localPoint, Vec2 out) {
    getWorldPointToOut(localPoint, out);
    getLinearVelocityFromWorldPointToOut(out, out);
  }

  // --- Properties ---

  /** Returns the linear damping, 1/s. */
  public final float getLinearDamping() {
    return m_linearDamping;
  }

  /** Sets the linear damping, 1/s. */
  public final void setLinearDamping(float linearDamping) {
    Checks.notNegative(linearDamping, "linearDamping");
    m_linearDamping = linearDamping;
  }

  /** Returns the angular damping, 1/s. */
  public final float getAngularDamping() {
    return m_angularDamping;
  }

  /** Sets the angular damping, 1/s. */
  public final void setAngularDamping(float angularDamping) {
    Checks.notNegative(angularDamping, "angularDamping");
    m_angularDamping = angularDamping;
  }

  /** Returns the factor on gravity. */
  public float getGravityScale() {
    return m_gravityScale;
  }

  /** Sets the factor on gravity. */
  public void setGravityScale(float gravityScale) {
    Checks.finite(gravityScale, "gravityScale");
    m_gravityScale = gravityScale;
  }

  /** Returns the kind of body. */
  public BodyType getType() {
    return m_type;
  }

  /**
   * Changes the kind of body. Mass is computed anew, contacts are found anew, and the body is
   * awake.
   *
   * @throws IllegalStateException if the world is locked
   */
  public void setType(BodyType type) {
    checkChangeable("setType");
    Checks.notNull(type, "type");
    if (type != m_type) {
      BodyChanges.become(this, type);
    }
  }

  /** Returns whether continuous collision also guards this body against other moving bodies. */
  public final boolean isBullet() {
    return (m_flags & e_bulletFlag) != 0;
  }

  /** Sets whether continuous collision also guards this body against other moving bodies. */
  public final void setBullet(boolean flag) {
    boolean was = isObstacle();
    m_flags = flag ? m_flags | e_bulletFlag : m_flags & ~e_bulletFlag;
    if (isObstacle() != was && m_world != null) {
      m_world.bodies.obstacles += was ? -1 : 1;
      BodyContacts.countObstacle(this, !was);
      BodyContacts.markObstacle(this);
    }
  }

  /** Whether other bodies are stopped by this one within a step. */
  final boolean isObstacle() {
    return m_type != BodyType.DYNAMIC || isBullet();
  }

  /** Sets whether the body may fall asleep; if not, it is woken. */
  public void setSleepingAllowed(boolean flag) {
    if (flag) {
      m_flags |= e_autoSleepFlag;
    } else {
      m_flags &= ~e_autoSleepFlag;
      setAwake(true);
    }
  }

  /** Returns whether the body may fall asleep. */
  public boolean isSleepingAllowed() {
    return (m_flags & e_autoSleepFlag) != 0;
  }

  /** Wakes the body, or puts it to sleep: then its velocities and forces become 0. */
  public void setAwake(boolean flag) {
    if (flag) {
      if ((m_flags & e_awakeFlag) == 0) {
        m_flags |= e_awakeFlag;
        m_sleepTime = 0f;
      }
      if (awakeIndex < 0 && m_world != null) {
        m_world.awake.enter(this);
      }
    } else {
      m_flags &= ~e_awakeFlag;
      restart();
      m_linearVelocity.setZero();
      m_angularVelocity = 0f;
      m_force.setZero();
      m_torque = 0f;
      if (awakeIndex >= 0) {
        m_world.awake.leave(this, m_world.isLocked());
      }
    }
  }

  /** Counts its time of rest from now on. */
  final void restart() {
    m_sleepTime = 0f;
    still.time = 0f;
    creep.time = 0f;
  }

  /** Returns whether the body is awake. */
  public boolean isAwake() {
    return (m_flags & e_awakeFlag) != 0;
  }

  /**
   * Takes the body into the simulation, or out of it: then it has no contacts, is not met by
   * queries and does not move.
   *
   * @throws IllegalStateException if the world is locked
   */
  public void setActive(boolean flag) {
    checkChangeable("setActive");
    if (flag == isActive()) {
      return;
    }
    if (flag) {
      BodyChanges.activate(this);
    } else {
      BodyChanges.deactivate(this);
    }
  }

  /** Returns whether the body takes part in the simulation. */
  public boolean isActive() {
    return (m_flags & e_activeFlag) != 0;
  }

  /** Sets whether the body never turns; its angular velocity becomes 0. */
  public void setFixedRotation(boolean flag) {
    if (flag == isFixedRotation()) {
      return;
    }
    m_flags = flag ? m_flags | e_fixedRotationFlag : m_flags & ~e_fixedRotationFlag;
    m_angularVelocity = 0f;
    resetMassData();
  }

  /** Returns whether the body never turns. */
  public boolean isFixedRotation() {
    return (m_flags & e_fixedRotationFlag) != 0;
  }

  /** Returns the first fixture, the newest, or {@code null}. */
  public final Fixture getFixtureList() {
    return m_fixtureList;
  }

  /** Returns the first node of the list of joints, or {@code null}. */
  public final JointEdge getJointList() {
    return m_jointList;
  }

  /** Returns the first node of the list of contacts, or {@code null}. */
  public final ContactEdge getContactList() {
    return m_contactList;
  }

  /** Returns the next body of the world's list, or {@code null}. */
  public final Body getNext() {
    return m_next;
  }

  /** Returns the user data. */
  public final Object getUserData() {
    return m_userData;
  }

  /** Sets the user data. */
  public final void setUserData(Object data) {
    m_userData = data;
  }

  /** Returns the world. */
  public final World getWorld() {
    return m_world;
  }

  /**
   * Returns whether this body collides with another: at least one of them is dynamic, and no joint
   * forbids it. Fixtures' filters are not looked at.
   */
  public boolean shouldCollide(Body other) {
    if (m_type != BodyType.DYNAMIC && other.m_type != BodyType.DYNAMIC) {
      return false;
    }
    for (JointEdge edge = m_jointList; edge != null; edge = edge.next) {
      if (edge.other == other && !edge.joint.getCollideConnected()) {
        return false;
      }
    }
    return true;
  }

  // --- Engine ---

  /** Moves the broad-phase proxies to where the body is. Called by the engine. */
  protected final void synchronizeFixtures() {
    BroadPhase broadPhase = m_world.m_contactManager.m_broadPhase;
    for (Fixture f = m_fixtureList; f != null; f = f.m_next) {
      f.synchronize(broadPhase, m_xf0, m_xf);
    }
  }

  /** Computes {@link #m_xf} from {@link #m_sweep}. */
  public final void synchronizeTransform() {
    m_xf.q.s = MathUtils.sin(m_sweep.a);
    m_xf.q.c = MathUtils.cos(m_sweep.a);
    placeOrigin();
  }

  /** Computes the origin from the centre of mass and the rotation. */
  final void placeOrigin() {
    Rot q = m_xf.q;
    Vec2 local = m_sweep.localCenter;
    m_xf.p.x = m_sweep.c.x - q.c * local.x + q.s * local.y;
    m_xf.p.y = m_sweep.c.y - q.s * local.x - q.c * local.y;
  }

  /** Forgets the motion of an earlier step. */
  final void standStill() {
    m_sweep.c0.set(m_sweep.c);
    m_sweep.a0 = m_sweep.a;
    m_sweep.alpha0 = 0f;
  }

  /**
   * Moves the body along its sweep to the fraction {@code t} of the step, and lets the rest of the
   * step start there.
   */
  protected final void advance(float t) {
    m_sweep.advance(t);
    m_sweep.c.set(m_sweep.c0);
    m_sweep.a = m_sweep.a0;
    synchronizeTransform();
  }
}
