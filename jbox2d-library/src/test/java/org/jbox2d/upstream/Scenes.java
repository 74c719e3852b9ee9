package org.jbox2d.upstream;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.ConstantVolumeJointDef;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.FrictionJointDef;
import org.jbox2d.dynamics.joints.GearJointDef;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.jbox2d.dynamics.joints.PrismaticJointDef;
import org.jbox2d.dynamics.joints.PulleyJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.RopeJointDef;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.jbox2d.dynamics.joints.WheelJointDef;

/** Small scenes in terms of what both versions of the API have. Loaded for each {@link Engine}. */
final class Scenes {
  private final World world = new World(new Vec2(0f, -10f));
  private float friction = 0.2f;
  private float restitution;

  private Scenes() {}

  /**
   * Runs a scene at 60 Hz.
   *
   * @return x, y and angle of each body that can move, oldest first, for each step
   */
  static float[][] run(String scene, int steps) {
    Scenes s = new Scenes();
    s.build(scene);
    List<Body> bodies = s.moving();
    float[][] path = new float[steps][3 * bodies.size()];
    for (int i = 0; i < steps; i++) {
      s.world.step(1f / 60f, 8, 3);
      for (int k = 0; k < bodies.size(); k++) {
        path[i][3 * k] = bodies.get(k).getPosition().x;
        path[i][3 * k + 1] = bodies.get(k).getPosition().y;
        path[i][3 * k + 2] = bodies.get(k).getAngle();
      }
    }
    return path;
  }

  /** Runs a scene and returns how many dynamic bodies are awake then. */
  static int awakeAfter(String scene, int steps) {
    Scenes s = new Scenes();
    s.build(scene);
    for (int i = 0; i < steps; i++) {
      s.world.step(1f / 60f, 8, 3);
    }
    int awake = 0;
    for (Body b : s.moving()) {
      awake += b.isAwake() ? 1 : 0;
    }
    return awake;
  }

  private List<Body> moving() {
    List<Body> bodies = new ArrayList<>();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() != BodyType.STATIC) {
        bodies.add(b);
      }
    }
    Collections.reverse(bodies);
    return bodies;
  }

  private void build(String scene) {
    switch (scene) {
      case "fall with damping" -> fallWithDamping();
      case "corner first" -> cornerFirst();
      case "bounce" -> bounce();
      case "oblique hit" -> obliqueHit();
      case "slide" -> slide();
      case "slope" -> slope(box(0.5f, 0.25f), 0.25f);
      case "roll" -> slope(circle(0.5f), 0.9f);
      case "kinematic push" -> kinematicPush();
      case "over a chain" -> overAChain();
      case "stack" -> stack();
      case "pyramid" -> pyramid();
      case "wedge" -> wedge();
      case "domino" -> domino();
      case "distance pendulum" -> distancePendulum(0f);
      case "spring" -> distancePendulum(2f);
      case "revolute pendulum" -> revolutePendulum(false);
      case "motor" -> revolutePendulum(true);
      case "prismatic" -> prismatic();
      case "wheel" -> wheel();
      case "weld" -> weld();
      case "rope" -> rope();
      case "pulley" -> pulley();
      case "gear" -> gear();
      case "friction joint" -> frictionJoint();
      case "mouse" -> mouse();
      case "constant volume" -> constantVolume();
      default -> throw new IllegalArgumentException(scene);
    }
  }

  // --- Parts

  private Body body(BodyType type, float x, float y, float angle, Shape... shapes) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    def.angle = angle;
    Body body = world.createBody(def);
    for (Shape shape : shapes) {
      FixtureDef fixture = new FixtureDef();
      fixture.shape = shape;
      fixture.density = 1f;
      fixture.friction = friction;
      fixture.restitution = restitution;
      body.createFixture(fixture);
    }
    return body;
  }

  private Body dynamic(float x, float y, Shape... shapes) {
    return body(BodyType.DYNAMIC, x, y, 0f, shapes);
  }

  private Body ground() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-50f, 0f), new Vec2(50f, 0f));
    return body(BodyType.STATIC, 0f, 0f, 0f, edge);
  }

  private static PolygonShape box(float hx, float hy) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(hx, hy);
    return shape;
  }

  private static CircleShape circle(float radius) {
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    return shape;
  }

  // --- Contacts

  private void fallWithDamping() {
    Body b = dynamic(0f, 10f, box(0.5f, 0.5f));
    b.setLinearDamping(0.3f);
    b.setAngularDamping(0.5f);
    b.setLinearVelocity(new Vec2(3f, 2f));
    b.setAngularVelocity(4f);
    b.applyForce(new Vec2(20f, 5f), new Vec2(0.2f, 10.3f));
    Body light = dynamic(5f, 10f, circle(0.4f));
    light.setGravityScale(-0.5f);
  }

  private void cornerFirst() {
    ground();
    body(BodyType.DYNAMIC, 0f, 2f, 0.3f, box(0.5f, 0.25f));
  }

  private void bounce() {
    ground();
    restitution = 0.8f;
    dynamic(0f, 4f, circle(0.5f));
  }

  private void obliqueHit() {
    world.setGravity(new Vec2());
    friction = 0.5f;
    restitution = 0.5f;
    dynamic(-3f, 0f, circle(0.5f)).setLinearVelocity(new Vec2(6f, 0f));
    dynamic(0f, 0.5f, circle(0.7f));
  }

  private void slide() {
    friction = 0.4f;
    ground();
    dynamic(0f, 0.265f, box(1f, 0.25f)).setLinearVelocity(new Vec2(8f, 0f));
  }

  private void slope(Shape shape, float mu) {
    friction = mu;
    float angle = 0.35f;
    float s = (float) Math.sin(angle);
    float c = (float) Math.cos(angle);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-40f * c, -40f * s), new Vec2(40f * c, 40f * s));
    body(BodyType.STATIC, 0f, 0f, 0f, edge);
    float height = shape instanceof CircleShape ? 0.505f : 0.265f;
    body(BodyType.DYNAMIC, -height * s, height * c, angle, shape);
  }

  private void kinematicPush() {
    ground();
    body(BodyType.KINEMATIC, -3f, 0.6f, 0f, box(0.5f, 0.5f)).setLinearVelocity(new Vec2(2f, 0f));
    dynamic(0f, 0.515f, box(0.5f, 0.5f));
  }

  private void overAChain() {
    Vec2[] points = new Vec2[30];
    for (int i = 0; i < points.length; i++) {
      points[i] = new Vec2(i - 10f, 0.02f * (i - 15) * (i - 15));
    }
    ChainShape chain = new ChainShape();
    chain.createChain(points, points.length);
    body(BodyType.STATIC, 0f, 0f, 0f, chain);
    dynamic(-8f, 8f, circle(0.5f));
  }

  private void stack() {
    ground();
    for (int i = 0; i < 10; i++) {
      dynamic(0f, 0.515f + 1.015f * i, box(0.5f, 0.5f));
    }
  }

  private void pyramid() {
    ground();
    for (int row = 0; row < 8; row++) {
      for (int i = 0; i < 8 - row; i++) {
        dynamic(1.1f * i + 0.55f * row, 0.515f + 1.015f * row, box(0.5f, 0.5f));
      }
    }
  }

  private void wedge() {
    friction = 0.5f;
    Vec2[] v = {new Vec2(-3f, 0f), new Vec2(3f, 0f), new Vec2(-3f, 2f)};
    PolygonShape ramp = new PolygonShape();
    ramp.set(v, 3);
    ground();
    body(BodyType.STATIC, 0f, 0f, 0f, ramp);
    dynamic(-1f, 3f, circle(0.4f));
    dynamic(3.5f, 0.515f, box(0.5f, 0.5f));
  }

  private void domino() {
    friction = 0.6f;
    ground();
    for (int i = 0; i < 6; i++) {
      dynamic(i, 1.015f, box(0.1f, 1f));
    }
    dynamic(-0.8f, 1.8f, circle(0.2f)).setLinearVelocity(new Vec2(4f, 0f));
  }

  // --- Joints

  private void distancePendulum(float hertz) {
    Body ground = ground();
    Body bob = dynamic(3f, 10f, circle(0.5f));
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(ground, bob, new Vec2(0f, 10f), bob.getPosition());
    def.frequencyHz = hertz;
    def.dampingRatio = 0.2f;
    world.createJoint(def);
  }

  private void revolutePendulum(boolean motor) {
    Body ground = ground();
    Body rod = dynamic(1.5f, 10f, box(1.5f, 0.1f));
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(ground, rod, new Vec2(0f, 10f));
    def.enableMotor = motor;
    def.motorSpeed = 2f;
    def.maxMotorTorque = 1000f;
    world.createJoint(def);
  }

  private void prismatic() {
    Body ground = ground();
    Body slider = dynamic(0f, 10f, box(0.5f, 0.5f));
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(ground, slider, slider.getPosition(), new Vec2(0.6f, -0.8f));
    def.enableLimit = true;
    def.upperTranslation = 4f;
    world.createJoint(def);
  }

  private void wheel() {
    Body car = dynamic(0f, 2f, box(1.5f, 0.3f));
    ground();
    for (float x : new float[] {-1f, 1f}) {
      Body wheel = dynamic(x, 1.5f, circle(0.4f));
      WheelJointDef def = new WheelJointDef();
      def.initialize(car, wheel, wheel.getPosition(), new Vec2(0f, 1f));
      def.frequencyHz = 4f;
      def.dampingRatio = 0.7f;
      def.enableMotor = true;
      def.motorSpeed = -5f;
      def.maxMotorTorque = 10f;
      world.createJoint(def);
    }
  }

  private void weld() {
    Body ground = ground();
    Body beam = dynamic(1f, 5f, box(1f, 0.1f));
    WeldJointDef def = new WeldJointDef();
    def.initialize(ground, beam, new Vec2(0f, 5f));
    world.createJoint(def);
  }

  private void rope() {
    Body ground = ground();
    Body bob = dynamic(2f, 10f, circle(0.5f));
    RopeJointDef def = new RopeJointDef();
    def.bodyA = ground;
    def.bodyB = bob;
    def.localAnchorA.set(0f, 10f);
    def.localAnchorB.set(0f, 0f);
    def.maxLength = 3f;
    world.createJoint(def);
  }

  private void pulley() {
    ground();
    Body heavy = dynamic(-3f, 8f, box(0.6f, 0.5f));
    Body light = dynamic(3f, 8f, box(0.5f, 0.5f));
    PulleyJointDef def = new PulleyJointDef();
    def.initialize(
        heavy,
        light,
        new Vec2(-3f, 12f),
        new Vec2(3f, 12f),
        heavy.getPosition(),
        light.getPosition(),
        1.5f);
    world.createJoint(def);
  }

  private void gear() {
    Body ground = ground();
    Body disc = dynamic(0f, 8f, circle(1f));
    RevoluteJointDef pin = new RevoluteJointDef();
    pin.initialize(ground, disc, disc.getPosition());
    Joint turn = world.createJoint(pin);
    Body rack = dynamic(2f, 8f, box(0.3f, 2f));
    PrismaticJointDef rail = new PrismaticJointDef();
    rail.initialize(ground, rack, rack.getPosition(), new Vec2(0f, 1f));
    Joint slide = world.createJoint(rail);
    GearJointDef def = new GearJointDef();
    def.bodyA = disc;
    def.bodyB = rack;
    def.joint1 = turn;
    def.joint2 = slide;
    def.ratio = 0.5f;
    world.createJoint(def);
  }

  private void frictionJoint() {
    world.setGravity(new Vec2());
    Body ground = ground();
    Body puck = dynamic(0f, 5f, box(0.5f, 0.5f));
    puck.setLinearVelocity(new Vec2(4f, 1f));
    puck.setAngularVelocity(5f);
    FrictionJointDef def = new FrictionJointDef();
    def.initialize(ground, puck, puck.getPosition());
    def.maxForce = 2f;
    def.maxTorque = 0.4f;
    world.createJoint(def);
  }

  private void mouse() {
    Body ground = ground();
    Body box = dynamic(0f, 2f, box(0.5f, 0.5f));
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = box;
    def.target.set(0.3f, 2.2f);
    def.maxForce = 100f;
    org.jbox2d.dynamics.joints.MouseJoint joint =
        (org.jbox2d.dynamics.joints.MouseJoint) world.createJoint(def);
    joint.setTarget(new Vec2(3f, 5f));
  }

  private void constantVolume() {
    ConstantVolumeJointDef def = new ConstantVolumeJointDef();
    ground();
    for (int i = 0; i < 12; i++) {
      double angle = 2 * Math.PI * i / 12;
      float x = 2f * (float) Math.cos(angle);
      float y = 4f + 2f * (float) Math.sin(angle);
      Body body = dynamic(x, y, circle(0.3f));
      body.setFixedRotation(true);
      def.addBody(body);
    }
    def.frequencyHz = 10f;
    def.dampingRatio = 1f;
    def.collideConnected = false;
    world.createJoint(def);
  }
}
