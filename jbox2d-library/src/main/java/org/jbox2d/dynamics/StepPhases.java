package org.jbox2d.dynamics;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * The phases of a step, in order: contacts, islands solved, bounds moved, continuous collision,
 * sleep. The world is locked while they run.
 */
final class StepPhases {
  /** Share of its old self down to which gravity may shrink in a step without more ado. */
  private static final float MOST_LOSS = 0.5f;

  Solver solver = Solver.sequentialImpulses();
  boolean allowSleep = true;
  boolean warmStarting = true;
  boolean continuousPhysics = true;
  final Laggards laggards = new Laggards();

  /** The last step, or the one that is going on. */
  final StepConfig config = new StepConfig();

  private final World world;
  private final ContactManager contacts;
  private final Profile profile;
  private final IslandSolver islandSolver;
  private final ContinuousCollision continuous;
  private float lastInvDt;
  private float lastGravityX;
  private float lastGravityY;

  StepPhases(World world) {
    this.world = world;
    contacts = world.m_contactManager;
    profile = world.profile;
    islandSolver = new IslandSolver(world);
    continuous = new ContinuousCollision(world);
  }

  /** Sets what the step is to be; nothing has changed if a value is refused. */
  void begin(float dt, int velocityIterations, int positionIterations, Vec2 gravity) {
    Checks.notNegative(dt, "dt");
    if (velocityIterations < 0 || positionIterations < 0) {
      throw new IllegalArgumentException(
          "iterations must not be negative, are " + velocityIterations + ", " + positionIterations);
    }
    profile.begin();
    config.dt = dt;
    config.invDt = dt > 0f ? 1f / dt : 0f;
    config.invStep = config.invDt;
    config.dtRatio = lastInvDt * dt * keptShare(gravity);
    config.velocityIterations = velocityIterations;
    config.positionIterations = positionIterations;
    config.warmStarting = warmStarting;
    config.gravityX = gravity.x;
    config.gravityY = gravity.y;
    config.readSettings();
    config.velocityTime = 0.5f;
    config.skinShare = 0f;
    if (!solver.isSequentialImpulses()) {
      config.velocityTime = 1f;
      config.skinShare = 0.5f;
      config.maxTranslation = Float.MAX_VALUE;
    }
  }

  /**
   * Share of the impulses of the last step to start from: what they carried is mostly weight. Where
   * gravity has been taken away or turned about they would throw up what they held. Where it but
   * rocks, all are kept: iterations cope with too much of them better than with too little.
   */
  private float keptShare(Vec2 gravity) {
    float before = lastGravityX * lastGravityX + lastGravityY * lastGravityY;
    float along = lastGravityX * gravity.x + lastGravityY * gravity.y;
    return along >= MOST_LOSS * before ? 1f : Math.max(0f, along / before);
  }

  /** Does the step that has been begun. */
  void run() {
    profile.stepInit.start();
    world.updatePairs();
    profile.stepInit.stop();
    collide();
    if (config.dt > 0f) {
      solve();
      synchronizeBroadPhase();
      solveContinuous();
      if (allowSleep) {
        islandSolver.updateSleep(config);
      }
      lastInvDt = config.invDt;
      lastGravityX = config.gravityX;
      lastGravityY = config.gravityY;
    }
    world.awake.letLeave();
  }

  private void collide() {
    profile.collide.start();
    contacts.collide();
    world.awake.letLeave();
    world.activeContacts = contacts.activeCount;
    profile.collide.stop();
  }

  private void solve() {
    profile.solve.start();
    islandSolver.solve(config, solver, profile);
    laggards.catchUp(islandSolver.late);
    profile.solve.stop();
  }

  /**
   * Moves the bounds of what has moved, and makes contacts for bounds that have come to overlap.
   */
  private void synchronizeBroadPhase() {
    profile.broadphase.start();
    islandSolver.synchronizeFixtures();
    contacts.findNewContacts();
    profile.broadphase.stop();
  }

  private void solveContinuous() {
    profile.solveTOI.start();
    if (continuousPhysics) {
      continuous.solve(config);
    }
    profile.solveTOI.stop();
  }
}
