package org.jbox2d.benchmarks.engines;

import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Link;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Rectangle;
import org.dyn4j.geometry.Vector2;

/** A body of dyn4j. */
final class Dyn4jBody implements SimBody {
  private static final CategoryFilter GHOST = new CategoryFilter(2, ~2L);

  final Body body;
  double pressed;

  private final Kind kind;

  Dyn4jBody(Body body, Kind kind) {
    this.body = body;
    this.kind = kind;
    body.setUserData(this);
  }

  @Override
  public SimBody box(double halfWidth, double halfHeight, double x, double y, Matter matter) {
    Rectangle shape = Geometry.createRectangle(2 * halfWidth, 2 * halfHeight);
    shape.translate(x, y);
    return fix(shape, matter);
  }

  @Override
  public SimBody polygon(Matter matter, double... vertices) {
    return fix(Geometry.createPolygon(points(vertices)), matter);
  }

  @Override
  public SimBody disc(double radius, double x, double y, Matter matter) {
    Convex shape = Geometry.createCircle(radius);
    shape.translate(x, y);
    return fix(shape, matter);
  }

  @Override
  public SimBody chain(Matter matter, double... vertices) {
    for (Link link : Geometry.createLinks(points(vertices), false)) {
      fix(link, matter);
    }
    return this;
  }

  private static Vector2[] points(double[] vertices) {
    Vector2[] points = new Vector2[vertices.length / 2];
    for (int i = 0; i < points.length; i++) {
      points[i] = new Vector2(vertices[2 * i], vertices[2 * i + 1]);
    }
    return points;
  }

  private SimBody fix(Convex shape, Matter matter) {
    BodyFixture fixture = body.addFixture(shape);
    // Its density must be positive; that of what does not move is of no account.
    fixture.setDensity(matter.density() > 0 ? matter.density() : 1);
    fixture.setFriction(matter.friction());
    fixture.setRestitution(matter.restitution());
    if (matter.ghost()) {
      fixture.setFilter(GHOST);
    }
    body.setMass(kind == Kind.DYNAMIC ? MassType.NORMAL : MassType.INFINITE);
    return this;
  }

  @Override
  public SimBody move(double vx, double vy, double w) {
    body.setLinearVelocity(vx, vy);
    body.setAngularVelocity(w);
    body.setAtRest(false);
    return this;
  }

  @Override
  public SimBody place(double x, double y) {
    body.getTransform().identity();
    body.translate(x, y);
    body.setAtRest(false);
    return this;
  }

  @Override
  public SimBody damp(double linear, double angular) {
    body.setLinearDamping(linear);
    body.setAngularDamping(angular);
    return this;
  }

  @Override
  public SimBody bullet() {
    body.setBullet(true);
    return this;
  }

  @Override
  public void push(double fx, double fy) {
    body.applyForce(new Vector2(fx, fy));
  }

  @Override
  public double x() {
    return body.getTransform().getTranslationX();
  }

  @Override
  public double y() {
    return body.getTransform().getTranslationY();
  }

  @Override
  public double angle() {
    return body.getTransform().getRotationAngle();
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
    return !body.isAtRest();
  }

  @Override
  public double pressed() {
    return pressed;
  }
}
