package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.callbacks.TreeCallback;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Keeps fast bodies from passing through others within a step.
 *
 * <p>After the step has moved everything, each fast dynamic body is followed along its way. What it
 * hits first stops it there, the impact is solved with the velocities of both, and the body goes on
 * for the rest of the step with its new velocity; this repeats until it hits nothing more, or has
 * had {@link Settings#maxSubSteps} impacts: then it stays where it is until the next step. What it
 * may hit are static and kinematic bodies, and others if one of the two is a bullet.
 *
 * <p>Bodies are followed one after another, in the order of the awake set, not in the order of the
 * times of all impacts of the world: so only fast bodies cost anything, and an impact costs what
 * its own bodies' candidates cost. A dynamic body that was hit is followed again.
 *
 * <p>A body with joints, and one hit that has joints, is not sent on alone, as that would tear the
 * joints. It is stopped, with all that joints tie to it, at the time of the impact; the next step
 * then finds it touching and solves impact and joints together.
 *
 * <p>With sub-stepping a body's step always ends at its first impact, after that has been solved.
 *
 * <p>Afterwards {@link Sweep#c0} of a body is where its last impact was, {@link Sweep#alpha0} when,
 * until the next step begins; both are as they were if it had none.
 */
final class ContinuousCollision implements TreeCallback {
  /** Way of the surface, as a share of the body's thickness, above which it moves fast. */
  private static final float FAST = 0.25f;

  /**
   * Least margin of a body's boxes in the broad phase, as a share of its thickness, where {@link
   * Settings#aabbExtension} is larger: an eighth of width plus height, each at least twice the
   * thickness.
   */
  private static final float MARGIN_SHARE = 0.5f;

  private final World world;
  private final ImpactSearch search;
  private final ImpactCheck check = new ImpactCheck();
  private final ImpactSolver solver;
  private final CentreGuard centreGuard = new CentreGuard();
  private final JointedBodies jointed = new JointedBodies();
  private final Sweep otherWay = new Sweep();
  private final Transform startOfBody = new Transform();
  private final Transform startOfOther = new Transform();
  private final AABB bounds = new AABB();
  private final Vec2 nowhere = new Vec2();

  /** Bodies still to be followed, marked by {@link Body#e_islandFlag}. */
  private Body[] queue = new Body[32];

  private int queued;

  /** Kinematic bodies that move. */
  private Body[] kinematic = new Body[8];

  private int kinematics;

  /** Bodies that are no longer where the step put them, marked by {@link Body#e_toiFlag}. */
  private Body[] moved = new Body[32];

  private int movedCount;

  private StepConfig step;
  private Profile profile;

  /** Greatest margin of the broad phase's boxes, m. */
  private float margin;

  /** Way in which a contact that bounces moves in the step at least, m. */
  private float slowWay;

  /** Least thickness of the awake dynamic bodies, m. */
  private float thinnest;

  /** Whether the candidates of a slow body may lie beyond its contacts. */
  private boolean farMovers;

  private Body striker;

  ContinuousCollision(World world) {
    this.world = world;
    search = new ImpactSearch(world.m_contactManager);
    solver = new ImpactSolver(world.m_contactManager);
  }

  void solve(StepConfig step) {
    if (world.bodies.obstacles == 0) {
      // Nothing stops anything within a step.
      return;
    }
    this.step = step;
    jointed.beginStep();
    profile = world.profile;
    margin = Settings.aabbExtension;
    slowWay = step.velocityThreshold * step.dt;
    farMovers = false;
    try {
      boolean bullets = collectFast();
      dropSlowKinematic();
      coverWays(kinematic, kinematics);
      if (bullets) {
        coverWays(queue, queued);
      }
      for (int i = 0; i < kinematics; i++) {
        strike(kinematic[i]);
      }
      for (int i = 0; i < queued; i++) {
        queue[i].m_flags &= ~Body.e_islandFlag;
        follow(queue[i]);
      }
      if (movedCount > 0) {
        synchronizeMoved();
      }
    } finally {
      release();
    }
  }

  // --- What is fast ---

  /**
   * Queues the fast dynamic bodies and lists the kinematic ones; returns whether one is a bullet.
   */
  private boolean collectFast() {
    AwakeSet awake = world.awake;
    boolean bullets = false;
    thinnest = Float.MAX_VALUE;
    for (int i = 0; i < awake.count; i++) {
      Body b = awake.bodies[i];
      if (b.thickness < 0f) {
        BodyExtents.compute(b);
      }
      if (b.m_type == BodyType.KINEMATIC) {
        addKinematic(b);
        continue;
      }
      thinnest = Math.min(thinnest, b.thickness);
      if (mustBeFollowed(b)) {
        enqueue(b);
        bullets |= b.isBullet();
      }
    }
    return bullets;
  }

  /** The longest way of a point of the body's surface on the rest of its way, m, at most. */
  private static float way(Body b) {
    Sweep s = b.m_sweep;
    float dx = s.c.x - s.c0.x;
    float dy = s.c.y - s.c0.y;
    return (float) Math.sqrt(dx * dx + dy * dy) + Math.abs(s.a - s.a0) * b.reach;
  }

  /** Whether the broad phase's boxes of a body cover the start of its way as well as the end. */
  private boolean boxesCoverWay(Body b) {
    return way(b) <= Math.min(margin, MARGIN_SHARE * b.thickness) || search.boxesCoverWay(b);
  }

  /**
   * Whether a body might pass through something, or bounce off it: a way of a share of its
   * thickness may carry it half through; and where it meets something faster than the threshold of
   * restitution, the bounce comes out right only if it happens at the right time. A body with
   * joints is stopped by an impact, so it is left to the step as long as it is not fast for its
   * size. What is not a number is not followed.
   */
  private boolean mustBeFollowed(Body b) {
    float way = way(b);
    float fast = FAST * b.thickness;
    float least = b.m_jointList != null ? fast : Math.min(slowWay, fast);
    return way > least && b.m_fixtureCount > 0;
  }

  private void enqueue(Body b) {
    if ((b.m_flags & Body.e_islandFlag) != 0) {
      return;
    }
    b.m_flags |= Body.e_islandFlag;
    if (queued == queue.length) {
      queue = Arrays.copyOf(queue, 2 * queued);
    }
    queue[queued++] = b;
  }

  private void addKinematic(Body b) {
    if (kinematics == kinematic.length) {
      kinematic = Arrays.copyOf(kinematic, 2 * kinematics);
    }
    kinematic[kinematics++] = b;
  }

  private void dropSlowKinematic() {
    // How thin those are that sleep is not known.
    float slow = Math.min(FAST * thinnest, margin);
    int kept = 0;
    for (int i = 0; i < kinematics; i++) {
      Body k = kinematic[i];
      if (way(k) > slow && k.m_fixtureCount > 0) {
        kinematic[kept++] = k;
      }
    }
    Arrays.fill(kinematic, kept, kinematics, null);
    kinematics = kept;
  }

  // --- Moving bodies against one another ---

  /**
   * Lets the boxes of what has moved far cover its whole way, so that others on theirs find it.
   * Only where moving bodies may meet: kinematic ones may be in the way of all, others in that of
   * bullets.
   */
  private void coverWays(Body[] bodies, int count) {
    for (int i = 0; i < count; i++) {
      Body b = bodies[i];
      if (boxesCoverWay(b)) {
        continue;
      }
      farMovers = true;
      for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
        for (int k = 0; k < f.m_proxyCount; k++) {
          search.boundsOfWay(b, f.m_proxies[k], bounds);
          world.m_contactManager.m_broadPhase.moveProxy(f.m_proxies[k].proxyId, bounds, nowhere);
        }
      }
    }
  }

  /** Queues the dynamic bodies that a kinematic one may pass through. */
  private void strike(Body k) {
    striker = k;
    search.boundsOfWay(k, bounds);
    world.m_contactManager.m_broadPhase.query(this, bounds);
    striker = null;
  }

  @Override
  public boolean treeCallback(int proxyId) {
    Object proxy = world.m_contactManager.m_broadPhase.getUserData(proxyId);
    Body b = ((FixtureProxy) proxy).fixture.m_body;
    if (b.m_type != BodyType.DYNAMIC) {
      return true;
    }
    if (b.thickness < 0f) {
      BodyExtents.compute(b);
    }
    if (b.awakeIndex < 0) {
      b.standStill();
    }
    Sweep k = striker.m_sweep;
    float dx = b.m_sweep.c.x - k.c.x;
    float dy = b.m_sweep.c.y - k.c.y;
    float arm = Math.min(striker.reach, (float) Math.sqrt(dx * dx + dy * dy) + b.reach);
    float mx = k.c.x - k.c0.x;
    float my = k.c.y - k.c0.y;
    float there = (float) Math.sqrt(mx * mx + my * my) + Math.abs(k.a - k.a0) * arm;
    if (there > FAST * b.thickness) {
      enqueue(b);
    }
    return true;
  }

  // --- One body ---

  private void follow(Body b) {
    followWay(b);
    if (centreGuard.shorten(b, step.linearSlop)) {
      noteMoved(b);
    }
  }

  private void followWay(Body b) {
    search.reset();
    boolean goesOn = b.impacts < Settings.maxSubSteps;
    while (goesOn) {
      float way = way(b);
      boolean far = farMovers || !boxesCoverWay(b);
      goesOn = search.find(b, far, way > FAST * b.thickness) && meet(b, search.other, search.time);
    }
    search.reset();
  }

  /** Handles what the search has found; returns whether the body goes on. */
  private boolean meet(Body b, Body o, float t) {
    float alpha0 = b.m_sweep.alpha0;
    float alpha = alpha0 + t * (1f - alpha0);
    if (!(alpha < 1f)) {
      // At the very end; the next step finds it touching.
      return false;
    }
    if (search.contact == null) {
      stop(b, t);
      return false;
    }
    ImpactSearch.restOfWay(o, alpha0, otherWay);
    startOfBody.set(b.m_xf);
    startOfOther.set(o.m_xf);
    boolean hit = false;
    try {
      b.m_sweep.getTransform(b.m_xf, t);
      if (o.m_type != BodyType.STATIC) {
        otherWay.getTransform(o.m_xf, t);
      }
      hit = isHit(b, (1f - alpha) * step.dt);
      if (hit) {
        impact(b, o, t, alpha);
      }
    } finally {
      if (!hit) {
        b.m_xf.set(startOfBody);
      }
      if (!hit || o.m_type != BodyType.DYNAMIC) {
        o.m_xf.set(startOfOther);
      }
    }
    return !hit || goOn(b, o);
  }

  /** Whether there is an impact that nobody objects to; if not, the contact is left out. */
  private boolean isHit(Body b, float h) {
    Contact c = search.contact;
    if (jointed.mustLetGo(b, search.time)) {
      c.m_flags |= Contact.LEFT_FLAG;
    } else if (check.isImpact(b, search, h, step)) {
      c.update(world.m_contactManager.m_contactListener);
      if (c.isTouching() && c.isEnabled()) {
        return true;
      }
    }
    search.ignore(c);
    return false;
  }

  private void impact(Body b, Body o, float t, float alpha) {
    profile.impacts++;
    search.contact.m_toi = alpha;
    boolean otherMoves = o.m_type == BodyType.DYNAMIC;
    if (otherMoves) {
      o.setAwake(true);
    }
    if (b.m_jointList != null || (otherMoves && o.m_jointList != null)) {
      b.impacts = Settings.maxSubSteps;
      search.contact.m_flags |= Contact.LEFT_FLAG;
      float rest = 1f - o.m_sweep.alpha0;
      float tOther = (alpha - o.m_sweep.alpha0) / rest;
      stop(b, t);
      if (otherMoves && !isAmong(o)) {
        stop(o, Math.max(0f, Math.min(tOther, 1f)));
      }
      return;
    }
    b.impacts++;
    if (otherMoves) {
      solver.begin(b, o);
    }
    startAt(b, b.m_sweep, t, alpha);
    if (otherMoves) {
      o.impacts++;
      startAt(o, otherWay, t, Math.max(alpha, o.m_sweep.alpha0));
    }
    solver.solve(b, o, search.contact, alpha, step);
  }

  private boolean isAmong(Body o) {
    for (int i = 0; i < jointed.count; i++) {
      if (jointed.bodies[i] == o) {
        return true;
      }
    }
    return false;
  }

  /** Ends the way of a body, and of all that joints tie to it, at the fraction t of its rest. */
  private void stop(Body b, float t) {
    jointed.collect(b);
    jointed.stopAt(t);
    for (int i = 0; i < jointed.count; i++) {
      noteMoved(jointed.bodies[i]);
    }
  }

  /** Lets the rest of a body's way start at the fraction t of {@code way}; it ends there too. */
  private void startAt(Body b, Sweep way, float t, float alpha) {
    Sweep s = b.m_sweep;
    s.c0.set(way.c0.x + t * (way.c.x - way.c0.x), way.c0.y + t * (way.c.y - way.c0.y));
    s.a0 = way.a0 + t * (way.a - way.a0);
    s.alpha0 = alpha;
    s.c.set(s.c0);
    s.a = s.a0;
    noteMoved(b);
  }

  /** Sends the bodies of an impact on; returns whether {@code b} has a way to go. */
  private boolean goOn(Body b, Body o) {
    if (b.m_jointList != null || (o.m_type == BodyType.DYNAMIC && o.m_jointList != null)) {
      return false;
    }
    if (o.m_type == BodyType.DYNAMIC) {
      sendOn(o);
      if (o.impacts < Settings.maxSubSteps && mustBeFollowed(o)) {
        enqueue(o);
      }
    }
    return sendOn(b);
  }

  /** Moves a body by its velocity for the rest of the step, if it may have further impacts. */
  private boolean sendOn(Body b) {
    if (b.impacts >= Settings.maxSubSteps || world.isSubStepping()) {
      b.synchronizeTransform();
      return false;
    }
    Sweep s = b.m_sweep;
    float h = (1f - s.alpha0) * (step.dt + Laggards.timeOf(b));
    float vx = b.m_linearVelocity.x;
    float vy = b.m_linearVelocity.y;
    float way = h * (float) Math.sqrt(vx * vx + vy * vy);
    if (way > step.maxTranslation) {
      b.m_linearVelocity.mulLocal(step.maxTranslation / way);
      profile.cappedVelocities++;
    }
    float turn = h * Math.abs(b.m_angularVelocity);
    if (turn > step.maxRotation) {
      b.m_angularVelocity *= step.maxRotation / turn;
      profile.cappedVelocities++;
    }
    s.c.x = s.c0.x + h * b.m_linearVelocity.x;
    s.c.y = s.c0.y + h * b.m_linearVelocity.y;
    s.a = s.a0 + h * b.m_angularVelocity;
    b.synchronizeTransform();
    return true;
  }

  // --- End ---

  private void noteMoved(Body b) {
    if ((b.m_flags & Body.e_toiFlag) != 0) {
      return;
    }
    b.m_flags |= Body.e_toiFlag;
    if (movedCount == moved.length) {
      moved = Arrays.copyOf(moved, 2 * movedCount);
    }
    moved[movedCount++] = b;
  }

  private void synchronizeMoved() {
    for (int i = 0; i < movedCount; i++) {
      moved[i].synchronizeFixtures();
    }
    world.m_contactManager.findNewContacts();
  }

  private void release() {
    for (int i = 0; i < queued; i++) {
      queue[i].m_flags &= ~Body.e_islandFlag;
      queue[i] = null;
    }
    for (int i = 0; i < movedCount; i++) {
      moved[i].m_flags &= ~Body.e_toiFlag;
      moved[i].impacts = 0;
      moved[i] = null;
    }
    Arrays.fill(kinematic, 0, kinematics, null);
    queued = 0;
    movedCount = 0;
    kinematics = 0;
    jointed.release();
  }
}
