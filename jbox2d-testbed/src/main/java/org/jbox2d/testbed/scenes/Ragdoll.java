package org.jbox2d.testbed.scenes;

import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.FixtureDef;

/**
 * A doll of ten limbs on hinges that bend no further than ours. Upright it is 5 m high; its limbs
 * do not collide with each other.
 */
final class Ragdoll {
  private final Stage stage;
  private final int number;
  private final Vec2 velocity;
  private float originX;
  private float originY;
  private float cos;
  private float sin;
  private float angle;

  /**
   * A doll.
   *
   * @param number from 1, another for each doll
   * @param velocity of all limbs, m/s
   */
  Ragdoll(Stage stage, int number, Vec2 velocity) {
    this.stage = stage;
    this.number = number;
    this.velocity = velocity;
  }

  /** Builds it about a world point, turned by an angle. */
  void at(float x, float y, float turn) {
    originX = x;
    originY = y;
    angle = turn;
    cos = MathUtils.cos(turn);
    sin = MathUtils.sin(turn);
    Body chest = limb(0f, 0.9f, 0.5f, 0.65f);
    Body hips = limb(0f, -0.25f, 0.42f, 0.45f);
    Vec2 skull = place(0f, 2.05f);
    Body head = stage.disc(skull.x, skull.y, 0.45f, flesh());
    head.setLinearVelocity(velocity);
    hinge(chest, hips, 0f, 0.25f, -0.5f, 0.5f);
    hinge(chest, head, 0f, 1.58f, -0.6f, 0.6f);
    for (int side = -1; side <= 1; side += 2) {
      Body upperArm = limb(side * 0.68f, 0.95f, 0.16f, 0.5f);
      Body lowerArm = limb(side * 0.68f, 0f, 0.14f, 0.48f);
      hinge(chest, upperArm, side * 0.68f, 1.4f, -2.2f, 2.2f);
      hinge(upperArm, lowerArm, side * 0.68f, 0.47f, side < 0 ? -2f : 0f, side < 0 ? 0f : 2f);
      Body thigh = limb(side * 0.25f, -1.2f, 0.2f, 0.6f);
      Body shin = limb(side * 0.25f, -2.35f, 0.17f, 0.6f);
      hinge(hips, thigh, side * 0.25f, -0.65f, -1f, 1f);
      hinge(thigh, shin, side * 0.25f, -1.78f, side < 0 ? -1.6f : 0f, side < 0 ? 0f : 1.6f);
    }
  }

  private FixtureDef flesh() {
    FixtureDef def = Stage.substance(1f, 0.6f, null);
    def.filter.groupIndex = -number;
    return def;
  }

  private Body limb(float x, float y, float halfWidth, float halfHeight) {
    Vec2 middle = place(x, y);
    Body body = stage.tilted(middle.x, middle.y, angle, halfWidth, halfHeight, flesh());
    body.setAngularDamping(0.5f);
    body.setLinearVelocity(velocity);
    return body;
  }

  private void hinge(Body a, Body b, float x, float y, float least, float most) {
    Vec2 joint = place(x, y);
    stage.hinge(a, b, joint.x, joint.y, least, most);
  }

  private Vec2 place(float x, float y) {
    return new Vec2(originX + cos * x - sin * y, originY + sin * x + cos * y);
  }
}
