package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A splinter of some grams that keeps a wheel's or a rail's joint metres outside of it, on a floor,
 * under a ball that comes down on it. With substeps the bend of its path was followed without
 * bound, and each pass between contact and joint made it greater: the splinter left at 10^14 m/s,
 * or as NaN, in one scene of five hundred.
 */
class FarRailTest {
  /**
   * The ball comes at 22 m/s and weighs some hundred times as much; so a splinter may well be fast.
   */
  private static final float FAST = 200f;

  private Random random;
  private World world;

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aSplinterDoesNotRunAway(boolean wheel) {
    for (int seed = 0; seed < 200; seed++) {
      random = new Random(seed);
      build(wheel);
      for (int i = 0; i < 60; i++) {
        world.step(1f / 60f, 8, 3);
        for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
          assertTrue(b.getLinearVelocity().length() < FAST, "seed " + seed + ", step " + i);
        }
      }
    }
  }

  private void build(boolean wheel) {
    world = new World(new Vec2(0f, -10f));
    world.setSolver(Solver.softStep());
    body(BodyType.STATIC, 0f, -0.5f, 0f, box(10f, 0.5f), 0f);
    float x = 2f + random.nextFloat();
    float y = 0.5f + random.nextFloat();
    Body heavy = body(BodyType.DYNAMIC, x, y, 0f, box(0.5f, 0.5f), 5f);
    float half = 0.05f + 0.1f * random.nextFloat();
    float at = -random.nextFloat();
    float height = 0.03f + 0.02f * random.nextFloat();
    float angle = 3f * random.nextFloat();
    Body splinter = body(BodyType.DYNAMIC, at, height, angle, box(half, 0.02f), 1f);
    Vec2 anchor = new Vec2(x - 0.5f + random.nextFloat(), y - 0.5f + random.nextFloat());
    join(heavy, splinter, anchor, wheel);
    CircleShape disc = new CircleShape();
    disc.m_radius = 0.2f;
    Body ball = body(BodyType.DYNAMIC, at - 0.3f * random.nextFloat(), 1.2f, 0f, disc, 10f);
    ball.setBullet(true);
    ball.setLinearVelocity(new Vec2(10f * random.nextFloat(), -20f * random.nextFloat()));
  }

  private void join(Body a, Body b, Vec2 anchor, boolean wheel) {
    if (wheel) {
      WheelJointDef def = new WheelJointDef();
      def.initialize(a, b, anchor, new Vec2(0f, 1f));
      def.frequencyHz = 3f;
      world.createJoint(def);
    } else {
      PrismaticJointDef def = new PrismaticJointDef();
      def.initialize(a, b, anchor, new Vec2(0f, 1f));
      world.createJoint(def);
    }
  }

  private static Shape box(float halfWidth, float halfHeight) {
    PolygonShape box = new PolygonShape();
    box.setAsBox(halfWidth, halfHeight);
    return box;
  }

  private Body body(BodyType type, float x, float y, float angle, Shape shape, float density) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    def.angle = angle;
    Body body = world.createBody(def);
    body.createFixture(shape, density).setFriction(0.5f);
    return body;
  }
}
