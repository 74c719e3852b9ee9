package org.jbox2d.benchmarks.engines.box2d;

import org.jbox2d.benchmarks.engines.SimBody;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.PrismaticJointDef;
import org.jbox2d.dynamics.joints.PulleyJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.RopeJointDef;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.jbox2d.dynamics.joints.WheelJointDef;

/** Joints with JBox2D's API. */
final class Box2dJoints {
  private static final Vec2 UP = new Vec2(0f, 1f);

  private final World world;

  Box2dJoints(World world) {
    this.world = world;
  }

  private static Body of(SimBody body) {
    return ((Box2dBody) body).body;
  }

  private static RevoluteJointDef revolute(SimBody a, SimBody b, double x, double y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(of(a), of(b), Box2dSim.vec(x, y));
    return def;
  }

  void hinge(SimBody a, SimBody b, double x, double y) {
    world.createJoint(revolute(a, b, x, y));
  }

  void motor(SimBody a, SimBody b, double x, double y, double speed, double maxTorque) {
    RevoluteJointDef def = revolute(a, b, x, y);
    def.enableMotor = true;
    def.motorSpeed = (float) speed;
    def.maxMotorTorque = (float) maxTorque;
    world.createJoint(def);
  }

  void limited(SimBody a, SimBody b, double x, double y, double lower, double upper) {
    RevoluteJointDef def = revolute(a, b, x, y);
    def.enableLimit = true;
    def.lowerAngle = (float) lower;
    def.upperAngle = (float) upper;
    world.createJoint(def);
  }

  void spring(SimBody a, Vec2 anchorA, SimBody b, Vec2 anchorB, double hz, double ratio) {
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(of(a), of(b), anchorA, anchorB);
    def.frequencyHz = (float) hz;
    def.dampingRatio = (float) ratio;
    world.createJoint(def);
  }

  void rope(SimBody a, SimBody b, double length) {
    RopeJointDef def = new RopeJointDef();
    def.bodyA = of(a);
    def.bodyB = of(b);
    def.localAnchorA.setZero();
    def.localAnchorB.setZero();
    def.maxLength = (float) length;
    world.createJoint(def);
  }

  void rail(SimBody a, SimBody b, Vec2 anchor, Vec2 axis) {
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(of(a), of(b), anchor, axis);
    world.createJoint(def);
  }

  void weld(SimBody a, SimBody b, double x, double y) {
    WeldJointDef def = new WeldJointDef();
    def.initialize(of(a), of(b), Box2dSim.vec(x, y));
    world.createJoint(def);
  }

  void wheel(SimBody chassis, SimBody wheel, double hz, double ratio) {
    WheelJointDef def = new WheelJointDef();
    def.initialize(of(chassis), of(wheel), of(wheel).getPosition(), UP);
    def.frequencyHz = (float) hz;
    def.dampingRatio = (float) ratio;
    world.createJoint(def);
  }

  void pulley(SimBody a, Vec2 groundA, SimBody b, Vec2 groundB) {
    PulleyJointDef def = new PulleyJointDef();
    def.initialize(
        of(a), of(b), groundA, groundB, of(a).getWorldCenter(), of(b).getWorldCenter(), 1f);
    world.createJoint(def);
  }
}
