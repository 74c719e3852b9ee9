package org.jbox2d.dynamics;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;

/** What tests of chains have in common. */
final class Chains {
  private Chains() {}

  /**
   * Hangs links in a row on a still body at the origin, which touch nothing, and a box of a metre
   * on the last.
   *
   * @param angle of the row from straight down, rad
   * @param ratio mass of the box over that of a link
   * @return the box
   */
  static Body hangWeight(World world, int links, float length, float angle, float ratio) {
    Vec2 along = new Vec2((float) StrictMath.sin(angle), -(float) StrictMath.cos(angle));
    Body last = Make.body(world, BodyType.STATIC, 0f, 0f);
    for (int i = 0; i < links; i++) {
      Vec2 centre = along.mul((i + 0.5f) * length);
      Body link = Make.body(world, BodyType.DYNAMIC, centre.x, centre.y);
      link.setTransform(centre, angle);
      link.createFixture(Make.boxShape(0.05f, 0.5f * length), 1f).setSensor(true);
      hinge(world, last, link, along.mul(i * length));
      last = link;
    }
    Vec2 end = along.mul(links * length);
    Body weight = Make.body(world, BodyType.DYNAMIC, end.x, end.y);
    weight.createFixture(Make.boxShape(0.5f, 0.5f), 1f).setSensor(true);
    setMass(weight, ratio * last.getMass());
    hinge(world, last, weight, end);
    return weight;
  }

  /** Gives a body another mass, and an inertia in proportion. */
  static void setMass(Body body, float mass) {
    MassData data = new MassData();
    body.getMassData(data);
    data.I *= mass / data.mass;
    data.mass = mass;
    body.setMassData(data);
  }

  static void hinge(World world, Body a, Body b, Vec2 anchor) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, anchor);
    world.createJoint(def);
  }

  /** Kinetic energy of all bodies, and that of their heights with the given gravity, J. */
  static float energy(World world, float gravity) {
    float sum = 0f;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      float spin = b.getAngularVelocity();
      float inertia = b.getInertia() - b.getMass() * b.getLocalCenter().lengthSquared();
      sum += 0.5f * b.getMass() * b.getLinearVelocity().lengthSquared();
      sum += 0.5f * inertia * spin * spin;
      sum += b.getMass() * gravity * b.getWorldCenter().y;
    }
    return sum;
  }

  /** Largest distance of the two points of a joint, m. */
  static float largestGap(World world) {
    float gap = 0f;
    Vec2 a = new Vec2();
    Vec2 b = new Vec2();
    for (Joint joint = world.getJointList(); joint != null; joint = joint.getNext()) {
      joint.getAnchorA(a);
      joint.getAnchorB(b);
      gap = Math.max(gap, a.sub(b).length());
    }
    return gap;
  }
}
