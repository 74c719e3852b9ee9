package org.jbox2d.benchmarks.engines;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.ChainShape;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.Shape;

/** A body of gdx-box2d. */
final class GdxBody implements SimBody {
  final Body body;
  double pressed;

  GdxBody(Body body) {
    this.body = body;
    body.setUserData(this);
  }

  @Override
  public SimBody box(double halfWidth, double halfHeight, double x, double y, Matter matter) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox((float) halfWidth, (float) halfHeight, new Vector2((float) x, (float) y), 0f);
    return fix(shape, matter);
  }

  @Override
  public SimBody polygon(Matter matter, double... vertices) {
    PolygonShape shape = new PolygonShape();
    shape.set(floats(vertices));
    return fix(shape, matter);
  }

  @Override
  public SimBody disc(double radius, double x, double y, Matter matter) {
    CircleShape shape = new CircleShape();
    shape.setRadius((float) radius);
    shape.setPosition(new Vector2((float) x, (float) y));
    return fix(shape, matter);
  }

  @Override
  public SimBody chain(Matter matter, double... vertices) {
    ChainShape shape = new ChainShape();
    shape.createChain(floats(vertices));
    return fix(shape, matter);
  }

  private static float[] floats(double[] values) {
    float[] result = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      result[i] = (float) values[i];
    }
    return result;
  }

  private SimBody fix(Shape shape, Matter matter) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = (float) matter.density();
    def.friction = (float) matter.friction();
    def.restitution = (float) matter.restitution();
    if (matter.ghost()) {
      def.filter.categoryBits = 2;
      def.filter.maskBits = ~2;
    }
    body.createFixture(def);
    shape.dispose();
    return this;
  }

  @Override
  public SimBody move(double vx, double vy, double w) {
    body.setLinearVelocity((float) vx, (float) vy);
    body.setAngularVelocity((float) w);
    return this;
  }

  @Override
  public SimBody place(double x, double y) {
    body.setTransform((float) x, (float) y, 0f);
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
    body.applyForceToCenter((float) fx, (float) fy, true);
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
