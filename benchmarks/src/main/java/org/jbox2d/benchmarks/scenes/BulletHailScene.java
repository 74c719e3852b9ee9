package org.jbox2d.benchmarks.scenes;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;

/**
 * 400 bullets at 200 m/s against 40 thin posts. Each frame 20 of them start anew, so that each
 * flies for a third of a second.
 */
final class BulletHailScene extends WorldScene {
  private static final int BULLETS = 400;
  private static final int POSTS = 40;
  private static final int SALVO = 20;
  private static final float SPEED = 200f;

  private final Body[] bullets = new Body[BULLETS];
  private final Vec2 place = new Vec2();
  private final Vec2 velocity = new Vec2(SPEED, 0f);
  private int next;

  BulletHailScene() {
    super(-10f);
    fix(body(BodyType.STATIC, 0f, -10f), box(100f, 1f), 0f, 0.6f);
    PolygonShape post = box(0.05f, 0.3f);
    for (int i = 0; i < POSTS; i++) {
      fix(body(BodyType.STATIC, 20f + i % 4, 0.25f * i), post, 0f, 0.6f);
    }
    CircleShape ball = circle(0.05f);
    for (int i = 0; i < BULLETS; i++) {
      bullets[i] = body(BodyType.DYNAMIC, -100f + 0.3f * i, -5f);
      bullets[i].setBullet(true);
      fix(bullets[i], ball, 4f, 0.6f);
    }
  }

  @Override
  public void step() {
    for (int i = 0; i < SALVO; i++) {
      Body bullet = bullets[next];
      place.set(0.5f * i, 0.025f * next);
      bullet.setTransform(place, 0f);
      bullet.setLinearVelocity(velocity);
      bullet.setAngularVelocity(0f);
      next = (next + 1) % BULLETS;
    }
    super.step();
  }
}
