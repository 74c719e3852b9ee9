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
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.dynamics.joints.JointType;
import org.jbox2d.dynamics.solver.StepConfig;
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

  final AwakeSet awake = new AwakeSet();
  final Profile profile = new Profile();
  final MassData scratchMass = new MassData();
  final Vec2 scratchCentre = new Vec2();

  private final Vec2 gravity = new Vec2();
  private final IWorldPool pool;
  private final StepConfig step = new StepConfig();

  private final WorldRayCast rayCast;
  private final IslandSolver islandSolver;
  private final ContinuousCollision continuous;
  private final Laggards laggards = new Laggards();
  private final ArrayDeque<Runnable> deferred = new ArrayDeque<>();
  private final List<Body> leaving = new ArrayList<>();
  private final List<Object> extensions = new ArrayList<>();
  private final List<StepListener> stepListeners = new ArrayList<>();

  private Solver solver = Solver.sequentialImpulses();
  private Body bodyList;
  private Joint jointList;
  private int bodyCount;
  private int jointCount;
  private DestructionListener destructionListener;
  private DebugDraw debugDraw;
  private float lastInvDt;
  private boolean allowSleep = true;
  private boolean warmStarting = true;
  private boolean continuousPhysics = true;
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
    rayCast = new WorldRayCast(broadPhase);
    islandSolver = new IslandSolver(this);
    continuous = new ContinuousCollision(this);
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
    beginStep(dt, velocityIterations, positionIterations);
    m_flags |= LOCKED;
    try {
      updatePairs();
      collide();
      if (dt > 0f) {
        solve();
        synchronizeBroadPhase();
        solveContinuous();
        sleep();
      }
      endStep();
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
    this.solver = solver;
  }

  /** Returns how contacts and joints are solved. */
  public Solver getSolver() {
    return solver;
  }

  private void beginStep(float dt, int velocityIterations, int positionIterations) {
    Checks.notNegative(dt, "dt");
    if (velocityIterations < 0 || positionIterations < 0) {
      throw new IllegalArgumentException(
          "iterations must not be negative, are " + velocityIterations + ", " + positionIterations);
    }
    profile.begin();
    step.dt = dt;
    step.invDt = dt > 0f ? 1f / dt : 0f;
    step.invStep = step.invDt;
    step.dtRatio = lastInvDt * dt;
    step.velocityIterations = velocityIterations;
    step.positionIterations = positionIterations;
    step.warmStarting = warmStarting;
    step.gravityX = gravity.x;
    step.gravityY = gravity.y;
    step.readSettings();
    step.velocityTime = 0.5f;
    step.skinShare = 0f;
    if (!solver.isSequentialImpulses()) {
      step.velocityTime = 1f;
      step.skinShare = 0.5f;
      step.maxTranslation = Float.MAX_VALUE;
    }
  }

  /** Contacts for fixtures that are new or have been moved by hand. */
  private void updatePairs() {
    profile.stepInit.start();
    if ((m_flags & NEW_FIXTURE) != 0) {
      m_contactManager.findNewContacts();
      m_flags &= ~NEW_FIXTURE;
    }
    profile.stepInit.stop();
  }

  private void collide() {
    profile.collide.start();
    m_contactManager.collide();
    letLeave();
    activeContacts = m_contactManager.activeCount;
    profile.collide.stop();
  }

  private void solve() {
    profile.solve.start();
    islandSolver.solve(step, solver, profile);
    laggards.catchUp();
    profile.solve.stop();
  }

  /**
   * Moves the bounds of what has moved, and makes contacts for bounds that have come to overlap.
   */
  private void synchronizeBroadPhase() {
    profile.broadphase.start();
    islandSolver.synchronizeFixtures();
    m_contactManager.findNewContacts();
    profile.broadphase.stop();
  }

  private void solveContinuous() {
    profile.solveTOI.start();
    if (continuousPhysics) {
      continuous.solve(step);
    }
    profile.solveTOI.stop();
  }

  private void sleep() {
    if (allowSleep) {
      islandSolver.updateSleep(step);
    }
  }

  private void endStep() {
    if (step.dt > 0f) {
      lastInvDt = step.invDt;
    }
    letLeave();
    if ((m_flags & CLEAR_FORCES) != 0) {
      clearForces();
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
    Body b = new Body(def, this);
    b.m_next = bodyList;
    if (bodyList != null) {
      bodyList.m_prev = b;
    }
    bodyList = b;
    bodyCount++;
    enterAwakeSet(b);
    return b;
  }

  /**
   * Destroys a body with its joints, contacts and fixtures.
   *
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the body is not of this world, or was destroyed before
   */
  public void destroyBody(Body body) {
    checkUnlocked("destroyBody");
    Checks.notNull(body, "body");
    if (body.m_world != this) {
      throw new IllegalArgumentException("body is not of this world, or was destroyed before");
    }
    for (JointEdge edge = body.m_jointList; edge != null; edge = body.m_jointList) {
      if (destructionListener != null) {
        destructionListener.sayGoodbye(edge.joint);
      }
      // The listener may have destroyed it itself.
      if (body.m_jointList == edge) {
        destroyJoint(edge.joint);
      }
    }
    for (ContactEdge edge = body.m_contactList; edge != null; edge = body.m_contactList) {
      m_contactManager.destroy(edge.contact);
    }
    for (Fixture f = body.m_fixtureList; f != null; f = body.m_fixtureList) {
      if (destructionListener != null) {
        destructionListener.sayGoodbye(f);
      }
      if (body.m_fixtureList != f) {
        continue;
      }
      body.m_fixtureList = f.m_next;
      body.m_fixtureCount--;
      f.destroyProxies(m_contactManager.m_broadPhase);
      f.destroy();
    }
    if (body.m_world == null) {
      // A listener destroyed it meanwhile.
      return;
    }
    awake.remove(body);
    if (body.m_prev != null) {
      body.m_prev.m_next = body.m_next;
    } else {
      bodyList = body.m_next;
    }
    if (body.m_next != null) {
      body.m_next.m_prev = body.m_prev;
    }
    body.m_world = null;
    bodyCount--;
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
    if (def.type != JointType.GEAR) {
      checkBody(def.bodyA, "JointDef.bodyA");
      checkBody(def.bodyB, "JointDef.bodyB");
    }
    Joint j = Joint.create(this, def);
    // A gear takes its bodies from the joints it couples.
    checkBody(j.getBodyA(), "Joint.bodyA");
    j.m_next = jointList;
    if (jointList != null) {
      jointList.m_prev = j;
    }
    jointList = j;
    jointCount++;
    link(j, j.m_edgeA, j.getBodyA(), j.getBodyB());
    if (j.getBodyA() != j.getBodyB()) {
      link(j, j.m_edgeB, j.getBodyB(), j.getBodyA());
    }
    if (!j.getCollideConnected()) {
      flagContactsBetween(j.getBodyA(), j.getBodyB());
    }
    return j;
  }

  private void checkBody(Body body, String name) {
    Checks.notNull(body, name);
    if (body.m_world != this) {
      throw new IllegalArgumentException(name + " is not of this world, or was destroyed before");
    }
  }

  private static void link(Joint j, JointEdge edge, Body body, Body other) {
    edge.joint = j;
    edge.other = other;
    edge.prev = null;
    edge.next = body.m_jointList;
    if (body.m_jointList != null) {
      body.m_jointList.prev = edge;
    }
    body.m_jointList = edge;
  }

  private static void unlink(JointEdge edge, Body body) {
    if (edge.prev != null) {
      edge.prev.next = edge.next;
    } else {
      body.m_jointList = edge.next;
    }
    if (edge.next != null) {
      edge.next.prev = edge.prev;
    }
    edge.prev = null;
    edge.next = null;
  }

  private void flagContactsBetween(Body a, Body b) {
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      if (edge.other == a) {
        edge.contact.flagForFiltering();
        wakeForFiltering(edge.contact);
      }
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
    if (joint.m_edgeA.joint != joint || joint.getBodyA().m_world != this) {
      throw new IllegalArgumentException("joint is not of this world, or was destroyed before");
    }
    if (joint.m_prev != null) {
      joint.m_prev.m_next = joint.m_next;
    } else {
      jointList = joint.m_next;
    }
    if (joint.m_next != null) {
      joint.m_next.m_prev = joint.m_prev;
    }
    Body a = joint.getBodyA();
    Body b = joint.getBodyB();
    a.setAwake(true);
    b.setAwake(true);
    unlink(joint.m_edgeA, a);
    if (a != b) {
      unlink(joint.m_edgeB, b);
    }
    joint.m_edgeA.joint = null;
    joint.m_edgeB.joint = null;
    joint.m_prev = null;
    joint.m_next = null;
    Joint.destroy(joint);
    jointCount--;
    if (!joint.getCollideConnected()) {
      // Their bounds may overlap already, and must be met as if new.
      a.touchProxies();
      b.touchProxies();
    }
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
    boolean atA = joint.getBodyA() == from;
    if (!atA && joint.getBodyB() != from) {
      throw new IllegalArgumentException("joint does not hold the body it is to be moved from");
    }
    JointEdge edge = atA ? joint.m_edgeA : joint.m_edgeB;
    Body other = atA ? joint.getBodyB() : joint.getBodyA();
    unlink(edge, from);
    joint.replaceBody(from, to);
    link(joint, edge, to, other);
    (atA ? joint.m_edgeB : joint.m_edgeA).other = to;
    from.setAwake(true);
    to.setAwake(true);
  }

  // --- Catching up ---

  /**
   * Returns for how long a body had the velocity it was given at a moment of the last step, s.
   *
   * @param alpha when, as a fraction of the step
   */
  public float timeSince(Body body, float alpha) {
    return (1f - alpha) * (step.dt + Laggards.timeOf(body));
  }

  /**
   * Lets a dynamic body make up in the next step for time that it has spent with a velocity which
   * was then taken back, as when what held it up has broken. In that step it moves on, besides, by
   * this time times the difference of its velocity, as then solved, and the one taken back; unless
   * it would be pushed into something that it touches. It does not pass through still bodies.
   *
   * @param time see {@link #timeSince}; no more than four steps are made up for
   * @param velocity the velocity taken back, of the centre of mass, m/s; copied
   * @param angularVelocity the angular velocity taken back, rad/s
   * @throws IllegalStateException if the world is locked
   * @throws IllegalArgumentException if the body is not of this world, or a value is not allowed
   */
  public void letCatchUp(Body body, float time, Vec2 velocity, float angularVelocity) {
    checkUnlocked("letCatchUp");
    checkBody(body, "body");
    Checks.notNegative(time, "time");
    Checks.finite(velocity, "velocity");
    Checks.finite(angularVelocity, "angularVelocity");
    laggards.add(body, time, step.dt, velocity, angularVelocity);
  }

  // --- Awake set ---

  /** Lets the step look at a body and its contacts, if it is awake, active and can move. */
  void enterAwakeSet(Body b) {
    if (b.m_type == BodyType.STATIC || !b.isActive() || !b.isAwake() || b.m_world == null) {
      return;
    }
    if (b.awakeIndex < 0) {
      b.standStill();
    }
    awake.add(b);
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      m_contactManager.activate(edge.contact);
    }
  }

  /**
   * The body has been put to sleep by hand; during a step it leaves the set only between phases.
   */
  void leaveAwakeSet(Body b) {
    if (b.awakeIndex < 0) {
      return;
    }
    if (isLocked()) {
      leaving.add(b);
    } else {
      removeFromAwakeSet(b);
    }
  }

  private void letLeave() {
    for (int i = 0; i < leaving.size(); i++) {
      Body b = leaving.get(i);
      if (!b.isAwake()) {
        removeFromAwakeSet(b);
      }
    }
    leaving.clear();
  }

  /** Puts a body to sleep between phases of the step. */
  void fallAsleep(Body b) {
    b.setAwake(false);
    removeFromAwakeSet(b);
  }

  private void removeFromAwakeSet(Body b) {
    awake.remove(b);
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      if (edge.other.awakeIndex < 0) {
        m_contactManager.letRest(edge.contact);
      }
    }
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
    return bodyList;
  }

  /** Returns the first joint of the list, the newest, or {@code null}. */
  public Joint getJointList() {
    return jointList;
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
    return bodyCount;
  }

  /** Returns the number of joints. */
  public int getJointCount() {
    return jointCount;
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
    if (flag == allowSleep) {
      return;
    }
    allowSleep = flag;
    if (!flag) {
      for (Body b = bodyList; b != null; b = b.m_next) {
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
    return allowSleep;
  }

  /** Returns whether bodies may fall asleep. */
  public boolean isSleepingAllowed() {
    return allowSleep;
  }

  /** Sets whether impulses of the last step start the next one's iterations; of use for tests. */
  public void setWarmStarting(boolean warmStarting) {
    this.warmStarting = warmStarting;
  }

  /** Returns whether impulses of the last step start the next one's iterations. */
  public boolean isWarmStarting() {
    return warmStarting;
  }

  /** Sets whether fast bodies are kept from passing through others. */
  public void setContinuousPhysics(boolean continuousPhysics) {
    this.continuousPhysics = continuousPhysics;
  }

  /** Returns whether fast bodies are kept from passing through others. */
  public boolean isContinuousPhysics() {
    return continuousPhysics;
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
