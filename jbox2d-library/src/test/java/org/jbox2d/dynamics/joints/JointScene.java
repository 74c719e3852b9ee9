package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;

/** A world with a static ground body at the origin and boxes that collide with nothing. */
final class JointScene {
  static final float H = 1f / 60f;
  static final float G = 10f;

  final World world;
  final Body ground;

  JointScene(float gravity) {
    world = new World(new Vec2(0f, -gravity));
    ground = body(BodyType.STATIC, 0f, 0f);
  }

  /** A body without fixtures. */
  Body body(BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    def.allowSleep = false;
    return world.createBody(def);
  }

  /** A box of density 1 that collides with nothing and never sleeps. */
  Body box(float x, float y, float halfWidth, float halfHeight) {
    Body b = body(BodyType.DYNAMIC, x, y);
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight);
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = 1f;
    def.filter.maskBits = 0;
    b.createFixture(def);
    return b;
  }

  void step(int n) {
    for (int i = 0; i < n; i++) {
      world.step(H, 8, 3);
    }
  }

  /** Kinetic and potential energy, J. */
  double energy() {
    double e = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() == BodyType.DYNAMIC) {
        e += 0.5 * b.getMass() * b.getLinearVelocity().lengthSquared();
        e += 0.5 * centralInertia(b) * b.getAngularVelocity() * b.getAngularVelocity();
        e -= b.getMass() * world.getGravity().y * b.getWorldCenter().y;
      }
    }
    return e;
  }

  static double centralInertia(Body b) {
    return b.getInertia() - b.getMass() * b.getLocalCenter().lengthSquared();
  }

  /** Momentum x, y and angular momentum about the origin of the world. */
  double[] momentum() {
    double[] p = new double[3];
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      Vec2 v = b.getLinearVelocity();
      Vec2 c = b.getWorldCenter();
      p[0] += b.getMass() * v.x;
      p[1] += b.getMass() * v.y;
      p[2] += b.getMass() * (c.x * v.y - c.y * v.x) + centralInertia(b) * b.getAngularVelocity();
    }
    return p;
  }

  static Vec2 force(Joint joint) {
    Vec2 out = new Vec2();
    joint.getReactionForce(1f / H, out);
    return out;
  }

  /** Distance of the anchors, m. */
  static float gap(Joint joint) {
    Vec2 a = new Vec2();
    Vec2 b = new Vec2();
    joint.getAnchorA(a);
    joint.getAnchorB(b);
    return b.sub(a).length();
  }

  void assertFinite() {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      assertTrue(
          Float.isFinite(b.getPosition().x)
              && Float.isFinite(b.getPosition().y)
              && Float.isFinite(b.getAngle())
              && Float.isFinite(b.getLinearVelocity().lengthSquared())
              && Float.isFinite(b.getAngularVelocity()),
          "body at " + b.getPosition() + ", angle " + b.getAngle());
    }
  }
}
