package org.jbox2d.dynamics;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jbox2d.callbacks.ContactFilter;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.callbacks.DebugDraw;
import org.jbox2d.callbacks.DestructionListener;
import org.jbox2d.callbacks.QueryCallback;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.callbacks.StepListener;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.collision.broadphase.BroadPhaseStrategy;
import org.jbox2d.collision.broadphase.DefaultBroadPhaseBuffer;
import org.jbox2d.collision.broadphase.DynamicTree;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.pooling.IWorldPool;
import org.jbox2d.pooling.normal.DefaultWorldPool;

/**
 * A world of bodies, joints and contacts, and the step that moves them.
 *
 * <p>A world is used by one thread at a time; different worlds share nothing and may be stepped at
 * once on different threads. During a step the world is locked: callbacks may read it and change
 * velocities and properties, but what adds or removes anything throws an IllegalStateException;
 * queue such changes by {@link #defer}.
 */
public class World {
  public static final int WORLD_POOL_SIZE = 100;
  public static final int WORLD_POOL_CONTAINER_SIZE = 10;
  public static final int NEW_FIXTURE = 0x0001;
  public static final int LOCKED = 0x0002;
  public static final int CLEAR_FORCES = 0x0004;

  /** Number of contacts that the last step looked at. */
  public int activeContacts;

  /** Number of contacts kept for later use. */
  public int contactPoolCount;

  /** State, of the constants above. */
  protected int m_flags = CLEAR_FORCES;

  /** Makes and destroys contacts. */
  protected ContactManager m_contactManager;

  final AwakeSet awake;
  final Profile profile = new Profile();
  final MassData scratchMass = new MassData();
  final Vec2 scratchCentre = new Vec2();

  private final Vec2 gravity = new Vec2();
  private final IWorldPool pool;

  final WorldBodies bodies;
  private final WorldJoints joints;
  private final WorldRayCast rayCast;
  private final StepPhases phases;

  /** What {@link Fixture#synchronize} hands on, of one fixture after the other. */
  final AABB bounds = new AABB();

  /** As {@link #bounds}. */
  final Vec2 displacement = new Vec2();

  private final ArrayDeque<Runnable> deferred = new ArrayDeque<>();
  private final List<Object> extensions = new ArrayList<>();
  private final List<StepListener> stepListeners = new ArrayList<>();

  private DestructionListener destructionListener;
  private DebugDraw debugDraw;
  private boolean subStepping;

  /** A world with the given gravity, m/s^2. */
  public World(Vec2 gravity) {
    this(gravity, new DefaultWorldPool(WORLD_POOL_SIZE, WORLD_POOL_CONTAINER_SIZE));
  }

  /** A world with the given gravity and pool. */
  public World(Vec2 gravity, IWorldPool pool) {
    this(gravity, pool, new DynamicTree());
  }

  /** A world with the given gravity, pool and tree of bounds. */
  public World(Vec2 gravity, IWorldPool pool, BroadPhaseStrategy strategy) {
    this(gravity, pool, new DefaultBroadPhaseBuffer(strategy));
  }

  /** A world with the given gravity, pool and broad phase. */
  public World(Vec2 gravity, IWorldPool pool, BroadPhase broadPhase) {
    Checks.finite(gravity, "gravity");
    Checks.notNull(pool, "pool");
    Checks.notNull(broadPhase, "broadPhase");
    this.gravity.set(gravity);
    this.pool = pool;
    m_contactManager = new ContactManager(this, broadPhase);
    awake = new AwakeSet(m_contactManager);
    bodies = new WorldBodies(this);
    joints = new WorldJoints(this);
    rayCast = new WorldRayCast(broadPhase);
    phases = new StepPhases(this);
  }

  // --- Step ---

  /**
   * Moves the world on by {@code dt}.
   *
   * @param dt seconds, not negative; a fixed step such as 1/60 gives the best results
   * @param velocityIterations iterations of the velocity solver, such as 8
   * @param positionIterations iterations of the position solver, such as 3
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value is not allowed
   */
  public void step(float dt, int velocityIterations, int positionIterations) {
    checkUnlocked("step");
    phases.begin(dt, velocityIterations, positionIterations, gravity);
    m_flags |= LOCKED;
    try {
      phases.run();
      if ((m_flags & CLEAR_FORCES) != 0) {
        clearForces();
      }
    } finally {
      m_flags &= ~LOCKED;
    }
    runDeferred();
    for (int i = 0; i < stepListeners.size(); i++) {
      stepListeners.get(i).stepped(this, dt);
    }
    profile.end();
  }

  /**
   * Sets how contacts and joints are solved from the next step on. Impulses that bodies at rest
   * exert on one another carry over. What each solver costs and gets right is measured in the
   * project's {@code docs/accuracy.md}.
   *
   * @throws IllegalStateException if the world is locked
   */
  public void setSolver(Solver solver) {
    checkUnlocked("setSolver");
    Checks.notNull(solver, "solver");
    phases.solver = solver;
  }

  /** Returns how contacts and joints are solved. */
  public Solver getSolver() {
    return phases.solver;
  }

  /** Makes contacts for fixtures that are new or have been moved by hand. */
  void updatePairs() {
    if ((m_flags & NEW_FIXTURE) != 0) {
      m_contactManager.findNewContacts();
      m_flags &= ~NEW_FIXTURE;
    }
  }

  private void runDeferred() {
    Runnable task;
    while ((task = deferred.poll()) != null) {
      task.run();
    }
  }

  /**
   * Queues a change of the world. It runs at the end of the current step, when the world is no
   * longer locked, after what was queued before it; or at once if the world is not locked. If a
   * task throws, the exception leaves {@link #step} and the tasks behind it run at the end of the
   * next step.
   */
  public void defer(Runnable task) {
    Checks.notNull(task, "task");
    if (isLocked()) {
      deferred.add(task);
    } else {
      task.run();
    }
  }

  // --- Bodies and joints ---

  /**
   * Makes a body.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value of the definition is not allowed
   */
  public Body createBody(BodyDef def) {
    checkUnlocked("createBody");
    Checks.notNull(def, "def");
    def.check();
    return bodies.create(def);
  }

  /**
   * Destroys a body with its joints, contacts and fixtures.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the body is not of this world, or was destroyed before
   */
  public void destroyBody(Body body) {
    checkUnlocked("destroyBody");
    checkBody(body, "body");
    bodies.destroy(body);
  }

  /**
   * Makes a joint.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if a value of the definition is not allowed
   */
  public Joint createJoint(JointDef def) {
    checkUnlocked("createJoint");
    Checks.notNull(def, "def");
    return joints.create(def);
  }

  void checkBody(Body body, String name) {
    Checks.notNull(body, name);
    if (body.m_world != this) {
      throw new IllegalArgumentException(name + " is not of this world, or was destroyed before");
    }
  }

  /** A contact between sleeping bodies must be looked at in the next step. */
  void wakeForFiltering(Contact contact) {
    m_contactManager.activateStray(contact);
  }

  /**
   * Destroys a joint; its bodies wake, and collide again if they did not because of it.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the joint is not of this world, or was destroyed before
   */
  public void destroyJoint(Joint joint) {
    checkUnlocked("destroyJoint");
    Checks.notNull(joint, "joint");
    joints.destroy(joint);
  }

  /**
   * Moves an end of a joint from one body to another whose frame is the same, such as a piece of
   * it: local anchors and angles are kept. Both bodies wake.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the joint does not hold {@code from}, or a body is not of
   *     this world
   */
  public void moveJoint(Joint joint, Body from, Body to) {
    checkUnlocked("moveJoint");
    Checks.notNull(joint, "joint");
    checkBody(from, "from");
    checkBody(to, "to");
    joints.move(joint, from, to);
  }

  // --- Catching up ---

  /**
   * Returns for how long a body had the velocity it was given at a moment of the last step, s.
   *
   * @param alpha when, as a fraction of the step
   */
  public float timeSince(Body body, float alpha) {
    return (1f - alpha) * (phases.config.dt + Laggards.timeOf(body));
  }

  /**
   * Lets a dynamic body make up in the next step for time that it has spent with a velocity which
   * was then taken back, as when what held it up has broken. In that step it moves on, besides, by
   * this time times the difference of its velocity, as then solved, and the one taken back; unless
   * it would be pushed into something that it touches. It does not pass through still bodies.
   *
   * @param group any object, the same for all bodies that struck each other and their pieces: the
   *     whole of them keeps its angular momentum; {@code null} if something that does not catch up
   *     had a part in it, as a floor
   * @param time see {@link #timeSince}; no more than four steps are made up for
   * @param velocity the velocity taken back, of the centre of mass, m/s; copied
   * @param angularVelocity the angular velocity taken back, rad/s
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the body is not of this world, or a value is not allowed
   */
  public void letCatchUp(
      Body body, Object group, float time, Vec2 velocity, float angularVelocity) {
    checkUnlocked("letCatchUp");
    checkBody(body, "body");
    Checks.notNegative(time, "time");
    Checks.finite(velocity, "velocity");
    Checks.finite(angularVelocity, "angularVelocity");
    phases.laggards.add(body, group, time, phases.config.dt, velocity, angularVelocity);
  }

  /** Lets the next step look for pairs among the bounds that have changed. */
  void lookForPairs() {
    m_flags |= NEW_FIXTURE;
  }

  // --- Queries ---

  /**
   * Reports every fixture whose bounds overlap {@code aabb}; a fixture with several children may be
   * reported for each.
   *
   * @throws IllegalArgumentException if a bound is NaN
   */
  public void queryAABB(QueryCallback callback, AABB aabb) {
    Checks.notNull(callback, "callback");
    Checks.bounds(aabb, "aabb");
    BroadPhase broadPhase = m_contactManager.m_broadPhase;
    broadPhase.query(
        proxyId -> callback.reportFixture(((FixtureProxy) broadPhase.getUserData(proxyId)).fixture),
        aabb);
  }

  /**
   * Reports the fixtures that the segment from {@code point1} to {@code point2} meets, in no
   * particular order. The callback may cast further rays.
   *
   * @throws IllegalArgumentException if a point is not finite
   */
  public void raycast(RayCastCallback callback, Vec2 point1, Vec2 point2) {
    Checks.notNull(callback, "callback");
    Checks.finite(point1, "point1");
    Checks.finite(point2, "point2");
    rayCast.cast(callback, point1, point2);
  }

  // --- Extensions ---

  /**
   * Returns this world's object of a type, made by {@code factory} when first asked for. It lets a
   * library built on the engine keep its state with the world rather than in statics.
   */
  public <T> T extension(Class<T> type, Function<World, T> factory) {
    for (int i = 0; i < extensions.size(); i++) {
      Object extension = extensions.get(i);
      if (type.isInstance(extension)) {
        return type.cast(extension);
      }
    }
    T made = factory.apply(this);
    Checks.notNull(made, "what the factory made");
    extensions.add(made);
    return made;
  }

  // --- Properties ---

  /** Returns the first body of the list, the newest, or {@code null}. */
  public Body getBodyList() {
    return bodies.list;
  }

  /** Returns the first joint of the list, the newest, or {@code null}. */
  public Joint getJointList() {
    return joints.list;
  }

  /**
   * Returns the first contact of the list, the newest, or {@code null}; it may be one that does not
   * touch.
   */
  public Contact getContactList() {
    return m_contactManager.m_contactList;
  }

  /** Returns the number of bodies. */
  public int getBodyCount() {
    return bodies.count;
  }

  /** Returns the number of joints. */
  public int getJointCount() {
    return joints.count;
  }

  /** Returns the number of contacts, touching or not. */
  public int getContactCount() {
    return m_contactManager.m_contactCount;
  }

  /** Returns what makes and destroys contacts. */
  public ContactManager getContactManager() {
    return m_contactManager;
  }

  /** Sets gravity, m/s^2; it is copied. */
  public void setGravity(Vec2 gravity) {
    Checks.finite(gravity, "gravity");
    this.gravity.set(gravity);
  }

  /** Returns gravity, m/s^2, the same object each time. */
  public Vec2 getGravity() {
    return gravity;
  }

  /** Returns whether the world is locked, as it is during a step. */
  public boolean isLocked() {
    return (m_flags & LOCKED) != 0;
  }

  void checkUnlocked(String call) {
    if (isLocked()) {
      throw new IllegalStateException(call + " while the world is locked; queue it by World.defer");
    }
  }

  /** Sets whether forces are cleared at the end of each step. */
  public void setAutoClearForces(boolean flag) {
    m_flags = flag ? m_flags | CLEAR_FORCES : m_flags & ~CLEAR_FORCES;
  }

  /** Returns whether forces are cleared at the end of each step. */
  public boolean getAutoClearForces() {
    return (m_flags & CLEAR_FORCES) != 0;
  }

  /** Clears the forces of all awake bodies; sleeping ones have none. */
  public void clearForces() {
    for (int i = 0; i < awake.count; i++) {
      Body b = awake.bodies[i];
      b.m_force.setZero();
      b.m_torque = 0f;
    }
  }

  /** Sets whether bodies may fall asleep; if not, all are woken. */
  public void setAllowSleep(boolean flag) {
    if (flag == phases.allowSleep) {
      return;
    }
    phases.allowSleep = flag;
    if (!flag) {
      for (Body b = bodies.list; b != null; b = b.m_next) {
        b.setAwake(true);
      }
    }
  }

  /** Sets whether bodies may fall asleep. */
  public void setSleepingAllowed(boolean sleepingAllowed) {
    setAllowSleep(sleepingAllowed);
  }

  /** Returns whether bodies may fall asleep. */
  public boolean isAllowSleep() {
    return phases.allowSleep;
  }

  /** Returns whether bodies may fall asleep. */
  public boolean isSleepingAllowed() {
    return phases.allowSleep;
  }

  /** Sets whether impulses of the last step start the next one's iterations; of use for tests. */
  public void setWarmStarting(boolean warmStarting) {
    phases.warmStarting = warmStarting;
  }

  /** Returns whether impulses of the last step start the next one's iterations. */
  public boolean isWarmStarting() {
    return phases.warmStarting;
  }

  /** Sets whether fast bodies are kept from passing through others. */
  public void setContinuousPhysics(boolean continuousPhysics) {
    phases.continuousPhysics = continuousPhysics;
  }

  /** Returns whether fast bodies are kept from passing through others. */
  public boolean isContinuousPhysics() {
    return phases.continuousPhysics;
  }

  /** Sets whether a step ends at the first time of impact; of use for tests. */
  public void setSubStepping(boolean subStepping) {
    this.subStepping = subStepping;
  }

  /** Returns whether a step ends at the first time of impact. */
  public boolean isSubStepping() {
    return subStepping;
  }

  /** Sets who hears of joints and fixtures that go with their body. */
  public void setDestructionListener(DestructionListener listener) {
    destructionListener = listener;
  }

  /** Returns who hears of joints and fixtures that go with their body. */
  public DestructionListener getDestructionListener() {
    return destructionListener;
  }

  /** Sets what decides which fixtures collide; {@code null}: all do. */
  public void setContactFilter(ContactFilter filter) {
    m_contactManager.m_contactFilter = filter;
  }

  /** Sets who hears of contacts; may be {@code null}. */
  public void setContactListener(ContactListener listener) {
    m_contactManager.m_contactListener = listener;
  }

  /** Adds who hears of the end of each step, after those added before. */
  public void addStepListener(StepListener listener) {
    Checks.notNull(listener, "listener");
    stepListeners.add(listener);
  }

  /** Removes who hears of the end of each step; does nothing if it was not added. */
  public void removeStepListener(StepListener listener) {
    stepListeners.remove(listener);
  }

  /** Sets what draws the world in {@link #drawDebugData()}. */
  public void setDebugDraw(DebugDraw debugDraw) {
    this.debugDraw = debugDraw;
  }

  /** Draws the world by means of the debug draw, if one is set. */
  public void drawDebugData() {
    if (debugDraw != null) {
      new DebugDrawing(this, debugDraw).draw();
    }
  }

  /** Returns the world's pool. */
  public IWorldPool getPool() {
    return pool;
  }

  /**
   * Returns how long the phases of the last steps took. Times are measured from the first call on:
   * reading the clock costs as much as a step of a small world. Counts are always kept.
   */
  public Profile getProfile() {
    profile.measure();
    return profile;
  }

  /** Returns the number of proxies in the broad phase. */
  public int getProxyCount() {
    return m_contactManager.m_broadPhase.getProxyCount();
  }

  /** Returns the height of the broad phase's tree. */
  public int getTreeHeight() {
    return m_contactManager.m_broadPhase.getTreeHeight();
  }

  /** Returns the largest difference in height of two siblings in the tree. */
  public int getTreeBalance() {
    return m_contactManager.m_broadPhase.getTreeBalance();
  }

  /**
   * Returns the quality of the tree: the ratio of the summed to the root perimeter; the smaller the
   * better.
   */
  public float getTreeQuality() {
    return m_contactManager.m_broadPhase.getTreeQuality();
  }

  /** Takes a contact from the pool. Called by the engine. */
  public Contact popContact(Fixture fixtureA, int indexA, Fixture fixtureB, int indexB) {
    Contact c = m_contactManager.pop();
    c.init(fixtureA, indexA, fixtureB, indexB);
    return c;
  }

  /** Gives a contact back to the pool. Called by the engine. */
  public void pushContact(Contact contact) {
    m_contactManager.push(contact);
  }
}
