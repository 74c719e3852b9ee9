package org.jbox2d.benchmarks.scenes;

import org.jbox2d.benchmarks.SteppedScene;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;

/**
 * A scene that steps a world, with the helpers that scenes share. Scenes use what JBox2D 2.2.1.1
 * has, since they run on it too.
 */
class WorldScene implements SteppedScene {
  static final float DT = 1f / 60f;
  static final int VELOCITY_ITERATIONS = 8;
  static final int POSITION_ITERATIONS = 3;

  final World world;

  /** A world that keeps everything awake. */
  WorldScene(float gravity) {
    world = new World(new Vec2(0f, gravity));
    world.setSleepingAllowed(false);
  }

  @Override
  public void step() {
    world.step(DT, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
  }

  @Override
  public int bodyCount() {
    return world.getBodyCount();
  }

  final Body body(BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    return world.createBody(def);
  }

  static void fix(Body body, Shape shape, float density, float friction) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = density;
    def.friction = friction;
    body.createFixture(def);
  }

  static PolygonShape box(float halfWidth, float halfHeight) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight);
    return shape;
  }

  static PolygonShape box(float halfWidth, float halfHeight, float x, float y, float angle) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight, new Vec2(x, y), angle);
    return shape;
  }

  static CircleShape circle(float radius) {
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    return shape;
  }

  /** Floor with its top at y = 0 and two walls, open above. */
  final void container(float halfWidth, float height) {
    Body ground = body(BodyType.STATIC, 0f, 0f);
    fix(ground, box(halfWidth + 1f, 0.5f, 0f, -0.5f, 0f), 0f, 0.6f);
    fix(ground, box(0.5f, 0.5f * height, -halfWidth - 0.5f, 0.5f * height, 0f), 0f, 0.6f);
    fix(ground, box(0.5f, 0.5f * height, halfWidth + 0.5f, 0.5f * height, 0f), 0f, 0.6f);
  }

  /** A triangle of boxes that stands on y = {@code floor}, with {@code base} boxes at its foot. */
  final void pyramid(int base, float half, float left, float floor) {
    PolygonShape shape = box(half, half);
    for (int row = 0; row < base; row++) {
      float y = floor + (2 * row + 1) * half;
      for (int i = row; i < base; i++) {
        float x = left + (row + 1) * half + 2 * (i - row) * half;
        fix(body(BodyType.DYNAMIC, x, y), shape, 1f, 0.6f);
      }
    }
  }
}
