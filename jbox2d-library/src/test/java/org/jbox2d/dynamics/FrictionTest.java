package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Coulomb friction: sticking and sliding on slopes, braking, rolling, conveyor belts. */
class FrictionTest {

  @ParameterizedTest
  @ValueSource(floats = {10f, 25f, 40f})
  void aBoxSticksJustBelowTheFrictionAngleAndSlidesJustAbove(float degrees) {
    float angle = degrees * MathUtils.PI / 180f;
    float tan = (float) Math.tan(angle);
    float seconds = 2f;
    float stuck = slideDownSlope(Make.boxShape(0.5f, 0.25f), angle, 1.015f * tan, seconds);
    assertEquals(0f, stuck, 0.01f);
    float slid = slideDownSlope(Make.boxShape(0.5f, 0.25f), angle, 0.985f * tan, seconds);
    double a = Make.G * (Math.sin(angle) - 0.985 * tan * Math.cos(angle));
    assertEquals(0.5 * a * seconds * seconds, slid, 0.1 * 0.5 * a * seconds * seconds);
  }

  @Test
  void aFrictionlessBoxSlidesByTheFullSlope() {
    float angle = 0.4f;
    float slid = slideDownSlope(Make.boxShape(0.5f, 0.25f), angle, 0f, 1f);
    assertEquals(0.5 * Make.G * Math.sin(angle), slid, 0.03 * slid);
  }

  @Test
  void aDiscRollsWithTwoThirdsOfTheSlope() {
    float angle = 0.3f;
    float rolled = slideDownSlope(Make.circle(0.5f), angle, 0.9f, 2f);
    double expected = 0.5 * 2 / 3 * Make.G * Math.sin(angle) * 4;
    assertEquals(expected, rolled, 0.02 * expected);
  }

  /** Way along the slope after a time, from rest. */
  private static float slideDownSlope(Shape shape, float angle, float friction, float seconds) {
    World world = Make.world();
    Body slope = Make.body(world, BodyType.STATIC, 0f, 0f);
    Vec2 down = new Vec2(-MathUtils.cos(angle), -MathUtils.sin(angle));
    EdgeShape edge = new EdgeShape();
    edge.set(down.mul(100f), down.mul(-100f));
    slope.createFixture(edge, 0f);
    Make.surface(slope, friction, 0f);
    float height = 0.01f + (shape.getType().ordinal() == 0 ? 0.5f : 0.26f);
    Body body = Make.dynamic(world, shape, -height * down.y * -1f, height * -down.x, angle);
    Make.surface(body, friction, 0f);
    body.setSleepingAllowed(false);
    Vec2 start = body.getPosition().clone();
    Make.steps(world, Math.round(seconds * 60f));
    return Vec2.dot(body.getPosition().sub(start), down);
  }

  @Test
  void slidingEndsAfterVSquaredOverTwoMuG() {
    World world = Make.world();
    Make.surface(Make.ground(world), 0.4f, 0f);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.26f, 1f, 0.25f);
    Make.surface(box, 0.4f, 0f);
    Make.steps(world, 30);
    float x = box.getPosition().x;
    box.setLinearVelocity(new Vec2(8f, 0f));
    Make.steps(world, 240);
    assertEquals(64.0 / (2 * 0.4 * Make.G), box.getPosition().x - x, 0.12);
    assertTrue(!box.isAwake() && box.getPosition().y < 0.3f);
  }

  @Test
  void aSpinningDiscGripsAndRolls() {
    World world = Make.world();
    Make.surface(Make.ground(world), 0.5f, 0f);
    Body disc = Make.disc(world, 0f, 0.5f, 0.5f);
    Make.surface(disc, 0.5f, 0f);
    disc.setAngularVelocity(-12f);
    Make.steps(world, 120);
    // Angular momentum about the contact: I w0 = I w + m r v, v = w r, I = m r^2 / 2
    assertEquals(12f * 0.5f / 3f, disc.getLinearVelocity().x, 0.03f);
    assertEquals(-disc.getLinearVelocity().x / 0.5f, disc.getAngularVelocity(), 0.05f);
  }

  @Test
  void aConveyorBeltCarriesAtItsSpeed() {
    World world = Make.world();
    Body belt = Make.box(world, BodyType.STATIC, 0f, -1f, 50f, 1f);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.surface(belt, 0.8f, 0f);
    Make.surface(box, 0.8f, 0f);
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void preSolve(Contact contact, org.jbox2d.collision.Manifold oldManifold) {
            boolean beltFirst = contact.m_fixtureA.m_body == belt;
            contact.setTangentSpeed(beltFirst ? 3f : -3f);
          }
        });
    Make.steps(world, 120);
    assertEquals(3f, Math.abs(box.getLinearVelocity().x), 0.01f);
  }

  @Test
  void frictionOfTwoSurfacesIsTheirGeometricMean() {
    World world = Make.world();
    Make.surface(Make.ground(world), 0.1f, 0f);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.25f, 1f, 0.25f);
    Make.surface(box, 0.9f, 0f);
    Make.steps(world, 20);
    box.setLinearVelocity(new Vec2(8f, 0f));
    Make.steps(world, 60);
    assertEquals(8f - 0.3f * Make.G, box.getLinearVelocity().x, 0.05f);
  }

  @Test
  void frictionWithoutBoundGripsAndStaysFinite() {
    World world = Make.world();
    Make.surface(Make.ground(world), Float.MAX_VALUE, 0f);
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.surface(box, Float.MAX_VALUE, 0f);
    box.setLinearVelocity(new Vec2(1f, 0f));
    Make.steps(world, 180);
    WorldInvariants.check(world);
    assertTrue(!box.isAwake());
  }
}
