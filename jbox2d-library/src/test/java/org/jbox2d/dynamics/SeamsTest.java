package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What slides over a floor of butted parts is neither stopped nor lifted at their seams. dyn4j and
 * Box2D 3.2 stop it in their continuous phase.
 */
class SeamsTest {
  private static final float DT = 1f / 60f;
  private static final int PARTS = 100;
  private static final float[] WIDTHS = {0.25f, 1f, 2f};
  private static final float HALF = 0.25f;

  /** Where a box and a ball rest: their skin and that of the floor overlap by one slop. */
  private static final float BOX_AT_REST = HALF + 0.015f;

  private static final float BALL_AT_REST = HALF + 0.005f;

  private interface Floor {
    void lay(World world, float width);
  }

  private static World world(Floor floor, float width) {
    World world = new World(new Vec2(0f, -10f));
    floor.lay(world, width);
    return world;
  }

  private static void fix(World world, Shape shape) {
    world.createBody(new BodyDef()).createFixture(shape, 0f).setFriction(0f);
  }

  private static void layTiles(World world, float width) {
    for (int i = 0; i < PARTS; i++) {
      PolygonShape shape = new PolygonShape();
      shape.setAsBox(0.5f * width, 0.5f * width, new Vec2((i + 0.5f) * width, -0.5f * width), 0f);
      fix(world, shape);
    }
  }

  private static void layEdges(World world, float width) {
    for (int i = 0; i < PARTS; i++) {
      EdgeShape shape = new EdgeShape();
      shape.set(new Vec2(i * width, 0f), new Vec2((i + 1) * width, 0f));
      fix(world, shape);
    }
  }

  private static void layChain(World world, float width) {
    Vec2[] vertices = new Vec2[PARTS + 1];
    for (int i = 0; i <= PARTS; i++) {
      vertices[i] = new Vec2((PARTS - i) * width, 0f);
    }
    ChainShape chain = new ChainShape();
    chain.createChain(vertices, vertices.length);
    fix(world, chain);
  }

  private static Body slider(World world, Shape shape, float density, float y, float speed) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(0.31f, y);
    def.linearVelocity.set(speed, 0f);
    Body body = world.createBody(def);
    body.createFixture(shape, density).setFriction(0f);
    return body;
  }

  private static PolygonShape box() {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(HALF, HALF);
    return shape;
  }

  private static CircleShape ball() {
    CircleShape shape = new CircleShape();
    shape.m_radius = HALF;
    return shape;
  }

  /** Slides towards the end of the floor; nothing but the way changes. */
  private static void slides(World world, Body body, float speed, float width) {
    float y = body.getPosition().y;
    int steps = Math.min(400, (int) ((PARTS * width - 4f * HALF) / (speed * DT)));
    for (int i = 0; i < steps; i++) {
      world.step(DT, 8, 3);
      String where = speed + " m/s, width " + width + ", step " + i;
      assertEquals(speed, body.getLinearVelocity().x, 1e-3f * speed, where);
      assertEquals(y, body.getPosition().y, 0.01f, where);
      assertEquals(0f, body.getAngle(), 0.01f, where);
    }
  }

  private static void boxSlides(Floor floor, float speed) {
    for (float width : WIDTHS) {
      World world = world(floor, width);
      slides(world, slider(world, box(), 1f, BOX_AT_REST, speed), speed, width);
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 3f, 7f, 13f, 31f, 67f, 110f})
  void boxOverTiles(float speed) {
    boxSlides(SeamsTest::layTiles, speed);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 3f, 7f, 13f, 31f, 67f, 110f})
  void boxOverEdges(float speed) {
    boxSlides(SeamsTest::layEdges, speed);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 3f, 7f, 13f, 31f, 67f, 110f})
  void boxOverChain(float speed) {
    boxSlides(SeamsTest::layChain, speed);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 3f, 7f, 13f, 31f, 67f, 110f})
  void ballOverChain(float speed) {
    for (float width : WIDTHS) {
      World world = world(SeamsTest::layChain, width);
      slides(world, slider(world, ball(), 1f, BALL_AT_REST, speed), speed, width);
    }
  }

  /** A box that has been pressed into the floor comes out again, and meets no wall in its seams. */
  @ParameterizedTest
  @ValueSource(floats = {3f, 13f, 31f, 67f, 110f})
  void sunkBoxOverTiles(float speed) {
    for (float width : WIDTHS) {
      for (float depth = 0.004f; depth < 0.021f; depth += 0.002f) {
        World world = world(SeamsTest::layTiles, width);
        Body box = slider(world, box(), 1f, BOX_AT_REST - depth, speed);
        for (int i = 0; i < 10; i++) {
          world.step(DT, 8, 3);
          String where = speed + " m/s, width " + width + ", step " + i + ", depth " + depth;
          assertEquals(speed, box.getLinearVelocity().x, 1e-3f * speed, where);
        }
      }
    }
  }
}
