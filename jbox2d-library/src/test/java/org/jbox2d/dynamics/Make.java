package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;

/** Short ways to build what the tests need. Density 1, friction 0.2, restitution 0 unless given. */
final class Make {
  static final float STEP = 1f / 60f;
  static final float G = 10f;

  private Make() {}

  static World world() {
    return new World(new Vec2(0f, -G));
  }

  static World weightless() {
    return new World(new Vec2());
  }

  static void steps(World world, int count) {
    for (int i = 0; i < count; i++) {
      world.step(STEP, 8, 3);
    }
  }

  static Body body(World world, BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    return world.createBody(def);
  }

  static Body box(World world, BodyType type, float x, float y, float hx, float hy) {
    Body body = body(world, type, x, y);
    body.createFixture(boxShape(hx, hy), 1f);
    return body;
  }

  static Body disc(World world, float x, float y, float radius) {
    Body body = body(world, BodyType.DYNAMIC, x, y);
    body.createFixture(circle(radius), 1f);
    return body;
  }

  /** Flat ground at height 0. */
  static Body ground(World world) {
    Body body = body(world, BodyType.STATIC, 0f, 0f);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-200f, 0f), new Vec2(200f, 0f));
    body.createFixture(edge, 0f);
    return body;
  }

  static PolygonShape boxShape(float hx, float hy) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(hx, hy);
    return shape;
  }

  static CircleShape circle(float radius) {
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    return shape;
  }

  /** A convex polygon of 3 to 8 corners on an ellipse, at random. */
  static PolygonShape polygon(Random random, float size) {
    int count = 3 + random.nextInt(6);
    float a = size * (0.6f + 0.4f * random.nextFloat());
    float b = size * (0.6f + 0.4f * random.nextFloat());
    Vec2[] corners = new Vec2[count];
    for (int i = 0; i < count; i++) {
      float angle = 2f * MathUtils.PI * (i + 0.6f * random.nextFloat()) / count;
      corners[i] = new Vec2(a * MathUtils.cos(angle), b * MathUtils.sin(angle));
    }
    PolygonShape shape = new PolygonShape();
    shape.set(corners, count);
    return shape;
  }

  static Body dynamic(World world, Shape shape, float x, float y, float angle) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, y);
    def.angle = angle;
    Body body = world.createBody(def);
    body.createFixture(shape, 1f);
    return body;
  }

  static void surface(Body body, float friction, float restitution) {
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      f.setFriction(friction);
      f.setRestitution(restitution);
    }
  }

  /** Boxes on a circle that fly at its centre at about the given speed, and turn. */
  static List<Body> thrownTogether(World world, int count, float speed, Random random) {
    List<Body> bodies = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      float angle = 2f * MathUtils.PI * (i + 0.3f * random.nextFloat()) / count;
      Shape shape = boxShape(0.2f + 0.6f * random.nextFloat(), 0.2f + 0.6f * random.nextFloat());
      float x = 2.5f * MathUtils.cos(angle);
      float y = 2.5f * MathUtils.sin(angle);
      Body body = dynamic(world, shape, x, y, 0f);
      float aim = angle + MathUtils.PI + 0.3f * (float) random.nextGaussian();
      float own = speed * (0.5f + random.nextFloat());
      body.setLinearVelocity(new Vec2(own * MathUtils.cos(aim), own * MathUtils.sin(aim)));
      body.setAngularVelocity(2f * (float) random.nextGaussian());
      bodies.add(body);
    }
    return bodies;
  }

  /**
   * A box open at the top, into which random polygons and discs fall: the scene of the tests of
   * determinism and of allocation.
   */
  static World debris(int count, long seed) {
    World world = world();
    Body walls = body(world, BodyType.STATIC, 0f, 0f);
    EdgeShape edge = new EdgeShape();
    Vec2[] corners = {new Vec2(-6f, 40f), new Vec2(-6f, 0f), new Vec2(6f, 0f), new Vec2(6f, 40f)};
    for (int i = 0; i < 3; i++) {
      edge.set(corners[i], corners[i + 1]);
      walls.createFixture(edge, 0f);
    }
    Random random = new Random(seed);
    for (int i = 0; i < count; i++) {
      Shape shape = i % 3 == 0 ? circle(0.2f + 0.2f * random.nextFloat()) : polygon(random, 0.45f);
      float x = -5f + 10f * (i % 11) / 10f;
      Body body = dynamic(world, shape, x, 1f + (i / 11), 6f * random.nextFloat());
      surface(body, 0.4f, 0.1f);
    }
    return world;
  }

  /** Discs and polygons, half of them bullets, that fly to and fro between four walls for ever. */
  static World bullets(int count, long seed) {
    World world = weightless();
    Body walls = body(world, BodyType.STATIC, 0f, 0f);
    for (int i = 0; i < 4; i++) {
      PolygonShape wall = new PolygonShape();
      float angle = 0.5f * MathUtils.PI * i;
      Vec2 middle = new Vec2(10f * MathUtils.cos(angle), 10f * MathUtils.sin(angle));
      wall.setAsBox(0.05f, 10f, middle, angle);
      walls.createFixture(wall, 0f);
    }
    Random random = new Random(seed);
    for (int i = 0; i < count; i++) {
      Shape shape = i % 2 == 0 ? circle(0.1f + 0.1f * random.nextFloat()) : polygon(random, 0.2f);
      Body body = dynamic(world, shape, -8f + 2f * (i % 9), -8f + 2f * (i / 9), 0f);
      body.setBullet(i % 4 < 2);
      body.setSleepingAllowed(false);
      float angle = 6f * random.nextFloat();
      body.setLinearVelocity(new Vec2(80f * MathUtils.cos(angle), 80f * MathUtils.sin(angle)));
      surface(body, 0f, 1f);
    }
    return world;
  }

  /** A pyramid of unit boxes. */
  static World pyramid(int rows) {
    World world = world();
    ground(world);
    for (int row = 0; row < rows; row++) {
      for (int i = 0; i < rows - row; i++) {
        box(world, BodyType.DYNAMIC, i + 0.5f * row, 0.5f + 1.02f * row, 0.45f, 0.5f);
      }
    }
    return world;
  }

  /** Discs in a turning kinematic drum of four walls. */
  static World tumbler(int count) {
    World world = world();
    Body drum = body(world, BodyType.KINEMATIC, 0f, 0f);
    PolygonShape wall = new PolygonShape();
    for (int i = 0; i < 4; i++) {
      float angle = 0.5f * MathUtils.PI * i;
      wall.setAsBox(
          0.5f, 6f, new Vec2(5.5f * MathUtils.cos(angle), 5.5f * MathUtils.sin(angle)), angle);
      drum.createFixture(wall, 1f);
    }
    drum.setAngularVelocity(0.5f);
    for (int i = 0; i < count; i++) {
      Shape shape = i % 2 == 0 ? circle(0.2f) : boxShape(0.2f, 0.2f);
      dynamic(world, shape, -4f + 0.6f * (i % 14), -4f + 0.6f * (i / 14), 0f);
    }
    return world;
  }
}
