package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Bodies that touch nothing follow the closed forms of the time stepping. */
class FreeMotionTest {
  private static final float H = Make.STEP;

  @Test
  void fallFollowsTheSumOfSteps() {
    World world = Make.world();
    Body body = Make.disc(world, 0f, 0f, 0.5f);
    int n = 120;
    Make.steps(world, n);
    assertEquals(-n * H * Make.G, body.getLinearVelocity().y, 1e-3f);
    // y_n = -g h^2 (1 + 2 + ... + n)
    assertEquals(-Make.G * H * H * n * (n + 1) / 2, body.getPosition().y, 1e-3f);
  }

  @Test
  void aProjectileKeepsItsHorizontalSpeed() {
    World world = Make.world();
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 0.5f, 0.2f);
    body.setLinearVelocity(new Vec2(7f, 12f));
    body.setAngularVelocity(3f);
    int n = 90;
    Make.steps(world, n);
    assertEquals(7f, body.getLinearVelocity().x, 0f);
    assertEquals(7f * n * H, body.getPosition().x, 1e-4f);
    assertEquals(12f * n * H - Make.G * H * H * n * (n + 1) / 2, body.getPosition().y, 1e-3f);
    assertEquals(3f * n * H, body.getAngle(), 1e-4f);
    assertEquals(MathUtils.sin(body.getAngle()), body.getTransform().q.s, 1e-6f);
  }

  @Test
  void dampingIsImplicitEuler() {
    World world = Make.world();
    Body body = Make.disc(world, 0f, 0f, 0.5f);
    float c = 2.5f;
    body.setLinearDamping(c);
    body.setAngularDamping(c);
    body.setAngularVelocity(8f);
    body.setLinearVelocity(new Vec2(5f, 0f));
    int n = 100;
    Make.steps(world, n);
    double decay = Math.pow(1 + H * c, -n);
    assertEquals(5 * decay, body.getLinearVelocity().x, 1e-4);
    assertEquals(8 * decay, body.getAngularVelocity(), 1e-4);
    // towards the terminal speed g / c
    assertEquals(-Make.G / c * (1 - decay), body.getLinearVelocity().y, 1e-3);
  }

  @Test
  void dampingOfAnyStrengthIsStable() {
    World world = Make.weightless();
    Body body = Make.disc(world, 0f, 0f, 0.5f);
    body.setLinearDamping(1e6f);
    body.setLinearVelocity(new Vec2(50f, 0f));
    Make.steps(world, 2);
    assertTrue(body.getLinearVelocity().x >= 0f && body.getLinearVelocity().x < 0.01f);
  }

  @Test
  void gravityScaleScalesGravity() {
    World world = Make.world();
    Body heavy = Make.disc(world, 0f, 0f, 0.5f);
    Body light = Make.disc(world, 5f, 0f, 0.5f);
    Body floating = Make.disc(world, 10f, 0f, 0.5f);
    heavy.setGravityScale(2f);
    light.setGravityScale(-1f);
    floating.setGravityScale(0f);
    Make.steps(world, 30);
    assertEquals(-2f * light.getLinearVelocity().y, heavy.getLinearVelocity().y, 1e-3f);
    assertEquals(0f, floating.getPosition().y);
  }

  @Test
  void aForceAcceleratesOverOneStepOnly() {
    World world = Make.weightless();
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 0.5f);
    // mass 2, inertia m (w^2 + h^2) / 12
    float inertia = 2f * (4f + 1f) / 12f;
    assertEquals(2f, body.getMass(), 1e-6f);
    assertEquals(inertia, body.getInertia(), 1e-3f);
    body.applyForce(new Vec2(0f, 6f), new Vec2(1f, 0f));
    body.applyTorque(3f);
    Make.steps(world, 1);
    assertEquals(H * 6f / 2f, body.getLinearVelocity().y, 1e-6f);
    assertEquals(H * (6f + 3f) / body.m_I, body.getAngularVelocity(), 1e-5f);
    Make.steps(world, 10);
    assertEquals(H * 6f / 2f, body.getLinearVelocity().y, 1e-6f);
  }

  @Test
  void forcesStayWhereTheyAreNotClearedAutomatically() {
    World world = Make.weightless();
    world.setAutoClearForces(false);
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 0.5f);
    body.applyForceToCenter(new Vec2(6f, 0f));
    Make.steps(world, 10);
    assertEquals(10f * H * 3f, body.getLinearVelocity().x, 1e-5f);
    world.clearForces();
    Make.steps(world, 10);
    assertEquals(10f * H * 3f, body.getLinearVelocity().x, 1e-5f);
  }

  @Test
  void anImpulseActsAtOnce() {
    World world = Make.weightless();
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 0f, 1f, 0.5f);
    body.applyLinearImpulse(new Vec2(0f, 4f), new Vec2(-0.5f, 0f));
    assertEquals(2f, body.getLinearVelocity().y, 1e-6f);
    assertEquals(-2f / body.m_I, body.getAngularVelocity(), 1e-5f);
    body.applyAngularImpulse(2f);
    assertEquals(0f, body.getAngularVelocity(), 1e-5f);
  }

  @Test
  void theSpeedCapIsCounted() {
    World world = Make.weightless();
    Body body = Make.disc(world, 0f, 0f, 0.5f);
    body.setLinearVelocity(new Vec2(1000f, 0f));
    Make.steps(world, 1);
    assertEquals(Settings.maxTranslation, body.getPosition().x, 1e-4f);
    assertEquals(1, world.getProfile().cappedVelocities);
    Body slow = Make.disc(world, 0f, 50f, 0.5f);
    slow.setLinearVelocity(new Vec2(100f, 0f));
    body.setLinearVelocity(new Vec2());
    Make.steps(world, 1);
    assertEquals(0, world.getProfile().cappedVelocities);
  }

  @Test
  void aBodyWithFixedRotationDoesNotTurn() {
    World world = Make.world();
    Make.ground(world);
    Body body = Make.box(world, BodyType.DYNAMIC, 0f, 3f, 0.5f, 0.5f);
    body.setFixedRotation(true);
    body.applyLinearImpulse(new Vec2(5f, 0f), new Vec2(0f, 3.4f));
    body.applyTorque(100f);
    Make.steps(world, 120);
    assertEquals(0f, body.getAngle());
    assertEquals(0f, body.getAngularVelocity());
  }

  @Test
  void aStepOfLengthZeroMovesNothing() {
    World world = Make.world();
    Body body = Make.disc(world, 0f, 5f, 0.5f);
    body.setLinearVelocity(new Vec2(3f, 1f));
    world.step(0f, 8, 3);
    assertEquals(5f, body.getPosition().y);
    assertEquals(3f, body.getLinearVelocity().x);
    WorldInvariants.check(world);
  }
}
