package org.jbox2d.benchmarks.scenes;

import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;

/** Scenes with joints. */
final class JointedScenes {
  private static final int GRID = 100;

  private JointedScenes() {}

  /** A net of 100 x 100 discs hung up in the middle of its upper edge. The discs do not collide. */
  static WorldScene jointGrid() {
    WorldScene scene = new WorldScene(-10f);
    FixtureDef disc = new FixtureDef();
    disc.shape = WorldScene.circle(0.4f);
    disc.density = 1f;
    disc.filter.categoryBits = 2;
    disc.filter.maskBits = ~2 & 0xffff;
    Body[] column = new Body[GRID];
    Vec2 below = new Vec2(0f, -0.5f);
    Vec2 above = new Vec2(0f, 0.5f);
    Vec2 right = new Vec2(0.5f, 0f);
    Vec2 left = new Vec2(-0.5f, 0f);
    for (int k = 0; k < GRID; k++) {
      for (int i = 0; i < GRID; i++) {
        boolean hook = i == 0 && Math.abs(k - GRID / 2) <= 3;
        Body body = scene.body(hook ? BodyType.STATIC : BodyType.DYNAMIC, k, -i);
        body.createFixture(disc);
        if (i > 0) {
          pin(scene, column[i - 1], body, below, above);
        }
        if (k > 0) {
          pin(scene, column[i], body, right, left);
        }
        column[i] = body;
      }
    }
    return scene;
  }

  private static void pin(WorldScene scene, Body a, Body b, Vec2 anchorA, Vec2 anchorB) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.bodyA = a;
    def.bodyB = b;
    def.localAnchorA.set(anchorA);
    def.localAnchorB.set(anchorB);
    scene.world.createJoint(def);
  }

  /** A long bar turns in a ring of 360 edges and stirs 6,075 small bodies. */
  static WorldScene spinner() {
    WorldScene scene = new WorldScene(-10f);
    Body ground = scene.body(BodyType.STATIC, 0f, 0f);
    WorldScene.fix(ground, ring(360, 40f), 0f, 0.1f);
    Body bar = scene.body(BodyType.DYNAMIC, 0f, -20f);
    WorldScene.fix(bar, WorldScene.box(0.6f, 20f), 1f, 0f);
    RevoluteJointDef motor = new RevoluteJointDef();
    motor.initialize(ground, bar, new Vec2(0f, -20f));
    motor.enableMotor = true;
    motor.motorSpeed = 5f;
    motor.maxMotorTorque = 40_000f;
    scene.world.createJoint(motor);
    PolygonShape square = WorldScene.box(0.17f, 0.17f);
    PolygonShape slab = WorldScene.box(0.25f, 0.12f);
    Shape disc = WorldScene.circle(0.17f);
    for (int i = 0; i < 6075; i++) {
      Shape shape = i % 3 == 0 ? slab : i % 3 == 1 ? disc : square;
      float x = -23.75f + 0.5f * (i % 96);
      float y = 2f + 0.4f * (i / 96);
      WorldScene.fix(scene.body(BodyType.DYNAMIC, x, y), shape, 0.25f, 0.1f);
    }
    return scene;
  }

  private static ChainShape ring(int points, float radius) {
    Vec2[] vertices = new Vec2[points];
    for (int i = 0; i < points; i++) {
      double angle = -2 * Math.PI * i / points;
      vertices[i] =
          new Vec2(
              (float) (radius * StrictMath.cos(angle)), (float) (radius * StrictMath.sin(angle)));
    }
    ChainShape chain = new ChainShape();
    chain.createLoop(vertices, points);
    return chain;
  }
}
