package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** Impacts within a step: bounces, momentum, events, and what must not block. */
class ImpactTest {
  private static final float DT = 1f / 60f;
  private static final float G = 10f;

  private final World world = new World(new Vec2(0f, -G));

  private static CircleShape circle(float radius) {
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    return shape;
  }

  private static PolygonShape box(float hx, float hy) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(hx, hy);
    return shape;
  }

  private static Body body(World world, BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    return world.createBody(def);
  }

  private static Fixture fixture(Body body, Shape shape, float restitution, float friction) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = 1f;
    def.restitution = restitution;
    def.friction = friction;
    return body.createFixture(def);
  }

  private Body ground() {
    Body ground = body(world, BodyType.STATIC, 0f, -1f);
    fixture(ground, box(100f, 1f), 0f, 0f);
    return ground;
  }

  /** The listener of most tests: counts, and may disable. */
  private static class Listener implements ContactListener {
    int begun;
    int ended;
    int solved;
    float impulse;
    boolean passDownOnly;

    @Override
    public void beginContact(Contact contact) {
      begun++;
    }

    @Override
    public void endContact(Contact contact) {
      ended++;
    }

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {
      if (passDownOnly) {
        contact.setEnabled(false);
      }
    }

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
      solved++;
      for (int i = 0; i < impulse.count; i++) {
        this.impulse += impulse.normalImpulses[i];
      }
    }
  }

  // --- Bounces

  /**
   * A ball without loss comes back to its height. What it may gain is what pushes it out of the
   * depth at which impacts are found, up to 2 slops of 5 mm a bounce.
   */
  @Test
  void lossFreeBallKeepsItsHeight() {
    ground();
    for (float start : new float[] {2f, 4f, 7.3f, 15f}) {
      Body ball = body(world, BodyType.DYNAMIC, 3f * start, start);
      fixture(ball, circle(0.25f), 1f, 0f);
      int tops = 0;
      boolean rising = false;
      float last = start;
      for (int i = 0; i < 1800; i++) {
        world.step(DT, 8, 3);
        float y = ball.getPosition().y;
        if (rising && y < last) {
          tops++;
          assertEquals(start + 0.005f * tops, last, 0.0051f * tops, "top " + tops);
          rising = false;
        }
        rising |= y > last;
        last = y;
      }
      double period = 2 * Math.sqrt(2 * (start - 0.25) / G);
      assertEquals(30 / period, tops, 1.5);
      world.destroyBody(ball);
    }
  }

  /** In free space a bounce loses no time: the ball is where a mirror would have it. */
  @Test
  void bounceHappensWithinTheStep() {
    world.setGravity(new Vec2());
    ground();
    for (float v = 3f; v < 110f; v += 3.7f) {
      Body ball = body(world, BodyType.DYNAMIC, 0f, 2.5f);
      fixture(ball, circle(0.25f), 1f, 0f);
      ball.setLinearVelocity(new Vec2(0f, -v));
      int n = (int) (3.5f / (v * DT)) + 1;
      for (int i = 0; i < n; i++) {
        world.step(DT, 8, 3);
      }
      // It bounces within 3 slops of the ground, and is pushed out by at most 2.
      assertEquals(v * n * DT - 2.25f + 0.25f, ball.getPosition().y, 0.03f, "speed " + v);
      assertEquals(v, ball.getLinearVelocity().y, 1e-3f * v);
      world.destroyBody(ball);
    }
  }

  @Test
  void bulletAndTargetKeepMomentumAndEnergy() {
    world.setGravity(new Vec2());
    Random random = new Random(5);
    for (int i = 0; i < 100; i++) {
      Body target = body(world, BodyType.DYNAMIC, 0f, 0f);
      fixture(target, box(0.3f, 0.2f + random.nextFloat()), 1f, 0f);
      Body bullet = body(world, BodyType.DYNAMIC, -1.3f, 0.3f * random.nextFloat());
      fixture(bullet, circle(0.05f + 0.1f * random.nextFloat()), 1f, 0f);
      bullet.setBullet(true);
      bullet.setLinearVelocity(new Vec2(115f, 0f));
      double momentum = bullet.getMass() * 115.0;
      double energy = 0.5 * momentum * 115.0;
      double angular = -momentum * bullet.getWorldCenter().y;
      world.step(DT, 8, 3);
      assertEquals(1, world.getProfile().impacts);
      Vec2 v = bullet.getLinearVelocity();
      Vec2 u = target.getLinearVelocity();
      assertTrue(v.x < 100f);
      double px = bullet.getMass() * v.x + target.getMass() * u.x;
      double py = bullet.getMass() * v.y + target.getMass() * u.y;
      assertEquals(momentum, px, 1e-5 * momentum);
      assertEquals(0, py, 1e-5 * momentum);
      double spin = target.getInertia() * target.getAngularVelocity();
      double around =
          orbit(bullet) + orbit(target) + spin + bullet.getInertia() * bullet.getAngularVelocity();
      // The impact pushes both apart along its normal, which changes no angular momentum.
      assertEquals(angular, around, 0.01 * momentum);
      double after =
          0.5 * bullet.getMass() * v.lengthSquared()
              + 0.5 * target.getMass() * u.lengthSquared()
              + 0.5 * spin * target.getAngularVelocity();
      assertEquals(energy, after, 1e-3 * energy);
      world.destroyBody(bullet);
      world.destroyBody(target);
    }
  }

  private static double orbit(Body b) {
    Vec2 c = b.getWorldCenter();
    Vec2 v = b.getLinearVelocity();
    return b.getMass() * (c.x * v.y - c.y * v.x);
  }

  // --- Who is continuous

  @Test
  void onlyBulletsAreContinuousAgainstDynamicBodies() {
    world.setGravity(new Vec2());
    Body wall = body(world, BodyType.DYNAMIC, 0f, 0f);
    fixture(wall, box(0.05f, 5f), 0f, 0f);
    Body ball = body(world, BodyType.DYNAMIC, -1f, 0f);
    fixture(ball, circle(0.1f), 0f, 0f);
    ball.setLinearVelocity(new Vec2(115f, 0f));
    world.step(DT, 8, 3);
    assertTrue(ball.getPosition().x > 0.5f);
    ball.setTransform(new Vec2(-1f, 0f), 0f);
    ball.setBullet(true);
    world.step(DT, 8, 3);
    assertTrue(ball.getPosition().x < wall.getPosition().x);
  }

  @Test
  void sensorsDoNotBlock() {
    world.setGravity(new Vec2());
    Body gate = body(world, BodyType.STATIC, 0f, 0f);
    fixture(gate, box(0.05f, 5f), 0f, 0f).setSensor(true);
    Body ball = body(world, BodyType.DYNAMIC, -1f, 0f);
    fixture(ball, circle(0.1f), 0f, 0f);
    ball.setBullet(true);
    ball.setLinearVelocity(new Vec2(100f, 0f));
    world.step(DT, 8, 3);
    assertEquals(-1f + 100f * DT, ball.getPosition().x, 1e-5f);
    assertEquals(100f, ball.getLinearVelocity().x);
  }

  @Test
  void filteredFixturesDoNotBlock() {
    world.setGravity(new Vec2());
    Body wall = body(world, BodyType.STATIC, 0f, 0f);
    Filter filter = new Filter();
    filter.maskBits = 0;
    fixture(wall, box(0.05f, 5f), 0f, 0f).setFilterData(filter);
    Body ball = body(world, BodyType.DYNAMIC, -1f, 0f);
    fixture(ball, circle(0.1f), 0f, 0f);
    ball.setLinearVelocity(new Vec2(100f, 0f));
    world.step(DT, 8, 3);
    assertEquals(-1f + 100f * DT, ball.getPosition().x, 1e-5f);
    assertEquals(0, world.getContactCount());
  }

  /** A listener that disables the contact lets the bullet through, with its speed and its time. */
  @Test
  void disabledContactsDoNotBlock() {
    world.setGravity(new Vec2());
    Listener listener = new Listener();
    world.setContactListener(listener);
    Body platform = body(world, BodyType.STATIC, 0f, 0f);
    fixture(platform, box(5f, 0.05f), 0f, 0f);
    Body ball = body(world, BodyType.DYNAMIC, 0f, -1f);
    fixture(ball, circle(0.1f), 0f, 0f);
    ball.setBullet(true);
    listener.passDownOnly = true;
    ball.setLinearVelocity(new Vec2(0f, 100f));
    world.step(DT, 8, 3);
    assertEquals(-1f + 100f * DT, ball.getPosition().y, 1e-5f);
    assertEquals(100f, ball.getLinearVelocity().y);
    assertEquals(1, listener.begun);
    assertEquals(0, listener.solved);
    world.step(DT, 8, 3);
    assertEquals(1, listener.ended);

    listener.passDownOnly = false;
    ball.setLinearVelocity(new Vec2(0f, -110f));
    world.step(DT, 8, 3);
    world.step(DT, 8, 3);
    assertTrue(ball.getPosition().y > 0f);
    assertEquals(2, listener.begun);
    assertTrue(listener.solved >= 1);
    assertEquals(110f * ball.getMass(), listener.impulse, 0.01f * listener.impulse);
  }

  @Test
  void switchedOffNothingIsContinuous() {
    world.setGravity(new Vec2());
    world.setContinuousPhysics(false);
    fixture(body(world, BodyType.STATIC, 0f, 0f), box(0.05f, 5f), 0f, 0f);
    Body ball = body(world, BodyType.DYNAMIC, -1f, 0f);
    fixture(ball, circle(0.1f), 0f, 0f);
    ball.setLinearVelocity(new Vec2(100f, 0f));
    world.step(DT, 8, 3);
    assertTrue(ball.getPosition().x > 0.5f);
    assertEquals(0, world.getProfile().impacts);
  }

  @Test
  void subSteppingEndsTheStepAtTheImpact() {
    world.setGravity(new Vec2());
    world.setSubStepping(true);
    fixture(body(world, BodyType.STATIC, 0f, 0f), box(0.05f, 5f), 1f, 0f);
    Body ball = body(world, BodyType.DYNAMIC, -1f, 0f);
    fixture(ball, circle(0.1f), 1f, 0f);
    ball.setLinearVelocity(new Vec2(100f, 0f));
    world.step(DT, 8, 3);
    assertEquals(-0.15f, ball.getPosition().x, 0.02f);
    assertEquals(-100f, ball.getLinearVelocity().x, 0.1f);
    world.step(DT, 8, 3);
    assertEquals(-0.15f - 100f * DT, ball.getPosition().x, 0.02f);
  }

  @Test
  void fastKinematicPaddleTakesSlowAndSleepingBodiesAlong() {
    world.setGravity(new Vec2());
    for (boolean asleep : new boolean[] {false, true}) {
      Body paddle = body(world, BodyType.KINEMATIC, -1f, 0f);
      fixture(paddle, box(0.02f, 1f), 0f, 0f);
      Body ball = body(world, BodyType.DYNAMIC, 0f, 0.1f);
      fixture(ball, circle(0.1f), 0f, 0f);
      if (asleep) {
        ball.setAwake(false);
      }
      paddle.setLinearVelocity(new Vec2(90f, 0f));
      for (int i = 0; i < 5; i++) {
        world.step(DT, 8, 3);
        assertTrue(ball.getPosition().x > paddle.getPosition().x, "step " + i);
      }
      assertEquals(90f, ball.getLinearVelocity().x, 1f);
      world.destroyBody(ball);
      world.destroyBody(paddle);
    }
  }

  @Test
  void bulletsMeetOneAnother() {
    world.setGravity(new Vec2());
    Body left = body(world, BodyType.DYNAMIC, -1.4f, 0f);
    Body right = body(world, BodyType.DYNAMIC, 1.4f, 0.02f);
    for (Body b : new Body[] {left, right}) {
      fixture(b, circle(0.1f), 0f, 0f);
      b.setBullet(true);
      b.setLinearVelocity(new Vec2(-80f * b.getPosition().x, 0f));
    }
    world.step(DT, 8, 3);
    assertTrue(left.getPosition().x < right.getPosition().x);
    assertEquals(1, world.getProfile().impacts);
  }

  @Test
  void fastBallDoesNotPassAnEdge() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-5f, 0f), new Vec2(5f, 0f));
    body(world, BodyType.STATIC, 0f, 0f).createFixture(edge, 0f);
    Body ball = body(world, BodyType.DYNAMIC, 0f, 4f);
    fixture(ball, circle(0.05f), 0f, 0f);
    ball.setLinearVelocity(new Vec2(0f, -100f));
    for (int i = 0; i < 60; i++) {
      world.step(DT, 8, 3);
    }
    assertEquals(0.05f, ball.getPosition().y, 0.015f);
    assertFalse(ball.isAwake() && ball.getLinearVelocity().length() > 0.05f);
  }
}
