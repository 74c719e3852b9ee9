package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.LongRange;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** Collisions obey Newton's law of impact and keep what must be kept. */
class CollisionResponseTest {

  /** Two discs head on: v' = v_cm +- e (v_rel) m / M. */
  @Property(tries = 60, seed = "1")
  void headOnImpactFollowsNewton(
      @ForAll @DoubleRange(min = 0.2, max = 2) double radius,
      @ForAll @DoubleRange(min = 0, max = 1) double e,
      @ForAll @DoubleRange(min = 1.5, max = 20) double speed) {
    World world = Make.weightless();
    Body a = Make.disc(world, -3f, 0f, 0.5f);
    Body b = Make.disc(world, 1f, 0f, (float) radius);
    Make.surface(a, 0.3f, (float) e);
    a.setLinearVelocity(new Vec2((float) speed, 0f));
    Make.steps(world, 150);
    double m1 = a.getMass();
    double m2 = b.getMass();
    double common = m1 * speed / (m1 + m2);
    assertEquals(common - e * speed * m2 / (m1 + m2), a.getLinearVelocity().x, 2e-4 * speed);
    assertEquals(common + e * speed * m1 / (m1 + m2), b.getLinearVelocity().x, 2e-4 * speed);
    assertEquals(0, a.getLinearVelocity().y, 1e-4 * speed);
    assertEquals(0, a.getAngularVelocity(), 1e-3 * speed);
  }

  @Test
  void slowImpactsDoNotBounceFastOnesDo() {
    assertEquals(0f, speedOfPartingAfter(0.98f), 1e-4f);
    assertEquals(1.02f, speedOfPartingAfter(1.02f), 1e-4f);
  }

  private static float speedOfPartingAfter(float speed) {
    World world = Make.weightless();
    Body a = Make.disc(world, -0.6f, 0f, 0.5f);
    Body b = Make.disc(world, 0.6f, 0f, 0.5f);
    Make.surface(a, 0f, 1f);
    a.setLinearVelocity(new Vec2(speed, 0f));
    Make.steps(world, 60);
    return b.getLinearVelocity().x - a.getLinearVelocity().x;
  }

  @Test
  void withoutFrictionOnlyTheNormalComponentChanges() {
    World world = Make.weightless();
    Body a = Make.disc(world, -3f, 0f, 0.5f);
    Body b = Make.disc(world, 0f, 0.6f, 0.5f);
    Make.surface(a, 0f, 1f);
    Make.surface(b, 0f, 1f);
    a.setLinearVelocity(new Vec2(6f, 0f));
    Vec2 normal = new Vec2();
    world.setContactListener(
        new QuietListener() {
          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            WorldManifold manifold = new WorldManifold();
            contact.getWorldManifold(manifold);
            normal.set(manifold.normal);
            if (contact.m_fixtureA.m_body == b) {
              normal.negateLocal();
            }
          }
        });
    Make.steps(world, 90);
    // Equal masses swap their normal components; the tangential ones stay.
    float along = 6f * normal.x;
    assertTrue(normal.x > 0.5f && normal.x < 0.95f, "oblique");
    assertEquals(along * normal.x, b.getLinearVelocity().x, 1e-3f);
    assertEquals(along * normal.y, b.getLinearVelocity().y, 1e-3f);
    assertEquals(6f - along * normal.x, a.getLinearVelocity().x, 1e-3f);
    assertEquals(-along * normal.y, a.getLinearVelocity().y, 1e-3f);
    assertEquals(0f, b.getAngularVelocity(), 1e-5f);
  }

  @Test
  void aBallDroppedOnTheGroundRisesToRestitutionSquared() {
    World world = Make.world();
    Make.ground(world);
    Body ball = Make.disc(world, 0f, 5.5f, 0.5f);
    Make.surface(ball, 0.2f, 0.8f);
    float top = 0f;
    boolean down = false;
    for (int i = 0; i < 150; i++) {
      world.step(Make.STEP, 8, 3);
      down |= ball.getLinearVelocity().y > 0f;
      if (down) {
        top = Math.max(top, ball.getPosition().y - 0.5f);
      }
    }
    assertEquals(5f * 0.64f, top, 0.15f);
  }

  /**
   * Without forces from outside, whatever collides keeps its momentum, and its angular momentum as
   * well as long as positions are not corrected.
   */
  @Property(tries = 12, seed = "2")
  void randomCollisionsKeepMomentum(@ForAll @LongRange(min = 1, max = 1_000_000) long seed) {
    World world = swarm(seed, 0.5f);
    double[] before = totals(world);
    for (int i = 0; i < 200; i++) {
      world.step(Make.STEP, 8, 0);
    }
    double[] after = totals(world);
    assertTrue(world.getContactCount() > 0, "they meet");
    double scale = before[4];
    assertEquals(before[0], after[0], 1e-5 * scale);
    assertEquals(before[1], after[1], 1e-5 * scale);
    assertEquals(before[2], after[2], 2e-4 * scale);
  }

  @Property(tries = 12, seed = "3")
  void inelasticCollisionsNeverGainEnergy(@ForAll @LongRange(min = 1, max = 1_000_000) long seed) {
    World world = swarm(seed, 0f);
    double energy = totals(world)[3];
    double first = energy;
    for (int i = 0; i < 200; i++) {
      world.step(Make.STEP, 8, 3);
      double now = totals(world)[3];
      assertTrue(now <= energy + 1e-4 * first, () -> "energy rises to " + now);
      energy = now;
    }
    assertTrue(energy < 0.9 * first, "something was lost in collisions");
    WorldInvariants.check(world);
  }

  private static World swarm(long seed, float restitution) {
    World world = Make.weightless();
    Random random = new Random(seed);
    for (int i = 0; i < 36; i++) {
      Shape shape = i % 4 == 0 ? Make.circle(0.4f) : Make.polygon(random, 0.5f);
      float x = 1.1f * (i % 6) - 2.75f;
      float y = 1.1f * (i / 6) - 2.75f;
      Body body = Make.dynamic(world, shape, x, y, 6f * random.nextFloat());
      Make.surface(body, 0.5f, restitution);
      body.setSleepingAllowed(false);
      // inwards, so that they meet
      body.setLinearVelocity(
          new Vec2(-x + random.nextFloat() - 0.5f, -y + random.nextFloat() - 0.5f));
      body.setAngularVelocity(4f * random.nextFloat() - 2f);
    }
    return world;
  }

  /** Momentum x, y, angular momentum about the origin, kinetic energy, sum of |m v|. */
  private static double[] totals(World world) {
    double[] t = new double[5];
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      double m = b.getMass();
      double vx = b.getLinearVelocity().x;
      double vy = b.getLinearVelocity().y;
      double w = b.getAngularVelocity();
      Vec2 c = b.getWorldCenter();
      t[0] += m * vx;
      t[1] += m * vy;
      t[2] += m * (c.x * vy - c.y * vx) + b.m_I * w;
      t[3] += 0.5 * m * (vx * vx + vy * vy) + 0.5 * b.m_I * w * w;
      t[4] += m * Math.hypot(vx, vy);
    }
    return t;
  }

  @Test
  void overlapIsRemovedWithoutAddingSpeed() {
    World world = Make.weightless();
    Body a = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 0.5f, 0.5f);
    Body b = Make.box(world, BodyType.DYNAMIC, 0.7f, 0f, 0.5f, 0.5f);
    Make.steps(world, 60);
    float overlap = 1f - (b.getPosition().x - a.getPosition().x);
    assertTrue(overlap < 0.005f, () -> "overlap left: " + overlap);
    assertTrue(overlap > -0.02f, () -> "pushed too far: " + overlap);
    assertEquals(0f, a.getLinearVelocity().length(), 0f);
    assertEquals(0f, b.getLinearVelocity().length(), 0f);
    assertEquals(0.7f, a.getPosition().x + b.getPosition().x, 1e-5f);
  }

  @Test
  void postSolveTellsTheImpulseOfTheImpact() {
    World world = Make.weightless();
    Body a = Make.disc(world, -2f, 0f, 0.5f);
    Body b = Make.disc(world, 0f, 0f, 0.5f);
    a.setLinearVelocity(new Vec2(5f, 0f));
    float[] sum = new float[1];
    world.setContactListener(
        new QuietListener() {
          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {
            for (int i = 0; i < impulse.count; i++) {
              sum[0] += impulse.normalImpulses[i];
            }
          }
        });
    Make.steps(world, 60);
    assertEquals(b.getMass() * b.getLinearVelocity().x, sum[0], 1e-4f);
    assertEquals(2.5f * b.getMass(), sum[0], 1e-3f);
  }

  /** Hears of everything and does nothing. */
  static class QuietListener implements ContactListener {
    @Override
    public void beginContact(Contact contact) {}

    @Override
    public void endContact(Contact contact) {}

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {}

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {}
  }
}
