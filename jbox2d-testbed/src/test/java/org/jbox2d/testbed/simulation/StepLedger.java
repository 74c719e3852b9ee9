package org.jbox2d.testbed.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.IdentityHashMap;
import java.util.Map;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.fracture.Material;

/**
 * Keeps the books of momentum and energy over each step of a run.
 *
 * <p>What the moving bodies' momentum gains in a step is gravity's share and the impulses of
 * contacts and joints with bodies that are not dynamic; contacts among them and fractures add
 * nothing. The contacts' impulses are heard of in {@code postSolve}. A fracture gives back a part
 * of the impulse of its own contact: where that contact is with a body that is not dynamic, the
 * books can't be balanced from outside, and the step is left out. So are steps in which a body
 * wakes or falls asleep, which costs it its momentum and gravity's share, and those in which a
 * velocity reaches the engine's limit.
 */
final class StepLedger implements ContactListener {
  /**
   * Rounding, relative to the sum of the momenta's sizes and of the impulses: floats over a few
   * hundred additions.
   */
  private static final double ROUNDING = 2e-5;

  /** Rounding of the moving bodies' mass, relative; far less than any body weighs. */
  private static final double MASS_ROUNDING = 1e-5;

  /** Rounding of energy, relative. */
  private static final double ENERGY_ROUNDING = 1e-5;

  private final Simulation run;

  /** What the scene itself listens by; it may disable contacts or move their surfaces. */
  private final ContactListener ofScene;

  private final WorldManifold manifold = new WorldManifold();

  /**
   * Normals as they are solved: {@code postSolve} comes when bodies have moved on. Not so for an
   * impact within the step: its bodies are pushed apart first, and told of where they were solved.
   */
  private final Map<Contact, Vec2> normals = new IdentityHashMap<>();

  /** Whether contacts have been solved in this step, so that what follows is an impact. */
  private boolean solved;

  /** Impulses of a step on what breaks as one, for each body that strikes it. */
  private final Map<Object, Map<Body, Double>> blows = new IdentityHashMap<>();

  /** Which bodies were awake before the step. */
  private final Map<Body, Boolean> wasAwake = new IdentityHashMap<>();

  private final Vec2 reaction = new Vec2();
  private double impulseX;
  private double impulseY;
  private double impulseSize;
  private boolean brokenByScenery;
  private int stepsWithFracture;

  StepLedger(Simulation run) {
    this.run = run;
    ofScene = run.world().getContactManager().m_contactListener;
    run.world().setContactListener(this);
  }

  /** Does a step and balances it. */
  void step() {
    World world = run.world();
    // What the scene's script does to the world is none of the step's.
    run.prepare();
    Totals before = Totals.of(world);
    double work = workOfGravity(world, run.hz());
    int fracturesBefore = run.fractureCount();
    double mass = awakeMass(world);
    wasAwake.clear();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      wasAwake.put(b, b.isAwake());
    }
    impulseX = 0;
    impulseY = 0;
    impulseSize = 0;
    brokenByScenery = false;
    normals.clear();
    solved = false;
    blows.clear();
    run.step();
    addJoints(world);
    Totals after = Totals.of(world);
    boolean fracture = run.fractureCount() > fracturesBefore;
    boolean changed = Math.abs(awakeMass(world) - mass) > MASS_ROUNDING * mass || swapped(world);
    boolean capped = world.getProfile().cappedVelocities > 0;
    if (changed || capped || fracture && brokenByScenery) {
      return;
    }
    String what = "step " + run.steps() + (fracture ? " with a fracture" : "");
    double tolerance = ROUNDING * (momentumSize(world) + impulseSize) + 1e-6;
    assertEquals(impulseX, after.momentumX() - before.momentumX(), tolerance, what + ", x");
    double weight = world.getGravity().y * mass / run.hz();
    assertEquals(0f, world.getGravity().x);
    assertEquals(
        impulseY + weight, after.momentumY() - before.momentumY(), tolerance, what + ", y");
    if (fracture) {
      stepsWithFracture++;
      double most = before.kineticEnergy() * (1 + ENERGY_ROUNDING) + work;
      assertTrue(
          after.kineticEnergy() <= most,
          what + ": energy " + before.kineticEnergy() + " -> " + after.kineticEnergy());
    }
  }

  /** Returns how many steps with fractures were balanced. */
  int stepsWithFracture() {
    return stepsWithFracture;
  }

  /** The reaction of a joint is the force on its body B. */
  private void addJoints(World world) {
    for (Joint j = world.getJointList(); j != null; j = j.getNext()) {
      boolean movesA = j.getBodyA().getType() == BodyType.DYNAMIC;
      boolean movesB = j.getBodyB().getType() == BodyType.DYNAMIC;
      Body moving = movesB ? j.getBodyB() : j.getBodyA();
      if (movesA == movesB || !moving.isAwake()) {
        continue;
      }
      j.getReactionForce(run.hz(), reaction);
      reaction.mulLocal((movesB ? 1f : -1f) / run.hz());
      impulseX += reaction.x;
      impulseY += reaction.y;
      impulseSize += Math.abs(reaction.x) + Math.abs(reaction.y);
    }
  }

  /**
   * What gravity adds to the kinetic energy before contacts take from it: with dv = g dt, the sum
   * of {@code m (v . dv + dv^2 / 2)}. The way that bodies fall says less: one that is held up by
   * what breaks falls that way in the next step.
   */
  private static double workOfGravity(World world, double hz) {
    double work = 0;
    double dv = -9.81 / hz;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() == BodyType.DYNAMIC && b.isAwake()) {
        work += b.getMass() * (b.getLinearVelocity().y * dv + 0.5 * dv * dv);
      }
    }
    return work;
  }

  /**
   * Whether a body has woken or fallen asleep; another of the same mass may have done the other.
   */
  private boolean swapped(World world) {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (wasAwake.getOrDefault(b, b.isAwake()) != b.isAwake()) {
        return true;
      }
    }
    return false;
  }

  private static double awakeMass(World world) {
    double mass = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      mass += b.isAwake() && b.isActive() ? b.getMass() : 0;
    }
    return mass;
  }

  private static double momentumSize(World world) {
    double size = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      size += b.getMass() * b.getLinearVelocity().length();
    }
    return size;
  }

  @Override
  public void postSolve(Contact contact, ContactImpulse impulse) {
    if (ofScene != null) {
      ofScene.postSolve(contact, impulse);
    }
    solved = true;
    Body a = contact.getFixtureA().getBody();
    Body b = contact.getFixtureB().getBody();
    boolean movesA = a.getType() == BodyType.DYNAMIC;
    boolean movesB = b.getType() == BodyType.DYNAMIC;
    if (movesA && movesB) {
      return;
    }
    // Contacts of bodies that wake in this very step are solved as they were when they fell asleep.
    contact.getWorldManifold(manifold);
    Vec2 normal = normals.getOrDefault(contact, manifold.normal);
    double sign = movesB ? 1 : -1;
    double sum = 0;
    for (int i = 0; i < impulse.count; i++) {
      double n = impulse.normalImpulses[i];
      double t = impulse.tangentImpulses[i];
      impulseX += sign * (n * normal.x + t * normal.y);
      impulseY += sign * (n * normal.y - t * normal.x);
      impulseSize += Math.abs(n) + Math.abs(t);
      sum += n;
    }
    brokenByScenery |=
        yields(contact.getFixtureA(), b, sum) || yields(contact.getFixtureB(), a, sum);
  }

  /** The blows of one body on the parts of a compound add up. */
  private boolean yields(Fixture fixture, Body by, double impulse) {
    if (!(fixture.getMaterial() instanceof Material material)) {
      return false;
    }
    Object breakable = fixture.getCompound() == null ? fixture : fixture.getCompound();
    double all =
        blows
            .computeIfAbsent(breakable, key -> new IdentityHashMap<>())
            .merge(by, impulse, Double::sum);
    return all > material.m_rigidity;
  }

  @Override
  public void beginContact(Contact contact) {
    if (ofScene != null) {
      ofScene.beginContact(contact);
    }
  }

  @Override
  public void endContact(Contact contact) {
    if (ofScene != null) {
      ofScene.endContact(contact);
    }
  }

  @Override
  public void preSolve(Contact contact, Manifold oldManifold) {
    if (ofScene != null) {
      ofScene.preSolve(contact, oldManifold);
    }
    contact.getWorldManifold(manifold);
    if (solved) {
      normals.remove(contact);
    } else {
      normals.put(contact, new Vec2(manifold.normal));
    }
  }
}
