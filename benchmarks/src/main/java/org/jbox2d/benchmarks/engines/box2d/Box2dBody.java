package org.jbox2d.benchmarks.engines.box2d;

import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.SimBody;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.FixtureDef;

/** A body with JBox2D's API. */
final class Box2dBody implements SimBody {
  final Body body;
  double pressed;

  /** For what the engine copies: timed scenes are not to allocate. */
  private final Vec2 scratch = new Vec2();

  Box2dBody(Body body) {
    this.body = body;
    body.setUserData(this);
  }

  @Override
  public SimBody box(double halfWidth, double halfHeight, double x, double y, Matter matter) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox((float) halfWidth, (float) halfHeight, Box2dSim.vec(x, y), 0f);
    return fix(shape, matter);
  }

  @Override
  public SimBody polygon(Matter matter, double... vertices) {
    PolygonShape shape = new PolygonShape();
    shape.set(points(vertices), vertices.length / 2);
    return fix(shape, matter);
  }

  @Override
  public SimBody disc(double radius, double x, double y, Matter matter) {
    CircleShape shape = new CircleShape();
    shape.m_radius = (float) radius;
    shape.m_p.set((float) x, (float) y);
    return fix(shape, matter);
  }

  @Override
  public SimBody chain(Matter matter, double... vertices) {
    ChainShape shape = new ChainShape();
    shape.createChain(points(vertices), vertices.length / 2);
    return fix(shape, matter);
  }

  private static Vec2[] points(double[] vertices) {
    Vec2[] points = new Vec2[vertices.length / 2];
    for (int i = 0; i < points.length; i++) {
      points[i] = Box2dSim.vec(vertices[2 * i], vertices[2 * i + 1]);
    }
    return points;
  }

  private SimBody fix(Shape shape, Matter matter) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = (float) matter.density();
    def.friction = (float) matter.friction();
    def.restitution = (float) matter.restitution();
    if (matter.ghost()) {
      def.filter.categoryBits = 2;
      def.filter.maskBits = 0xffff & ~2;
    }
    body.createFixture(def);
    return this;
  }

  @Override
  public SimBody move(double vx, double vy, double w) {
    scratch.set((float) vx, (float) vy);
    body.setLinearVelocity(scratch);
    body.setAngularVelocity((float) w);
    return this;
  }

  @Override
  public SimBody place(double x, double y) {
    scratch.set((float) x, (float) y);
    body.setTransform(scratch, 0f);
    return this;
  }

  @Override
  public SimBody damp(double linear, double angular) {
    body.setLinearDamping((float) linear);
    body.setAngularDamping((float) angular);
    return this;
  }

  @Override
  public SimBody bullet() {
    body.setBullet(true);
    return this;
  }

  @Override
  public void push(double fx, double fy) {
    scratch.set((float) fx, (float) fy);
    body.applyForceToCenter(scratch);
  }

  @Override
  public double x() {
    return body.getPosition().x;
  }

  @Override
  public double y() {
    return body.getPosition().y;
  }

  @Override
  public double angle() {
    return body.getAngle();
  }

  @Override
  public double vx() {
    return body.getLinearVelocity().x;
  }

  @Override
  public double vy() {
    return body.getLinearVelocity().y;
  }

  @Override
  public double w() {
    return body.getAngularVelocity();
  }

  @Override
  public boolean awake() {
    return body.isAwake();
  }

  @Override
  public double pressed() {
    return pressed;
  }
}
