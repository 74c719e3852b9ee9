package org.jbox2d.benchmarks.engines;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.contact.SolvedContact;
import org.dyn4j.dynamics.joint.DistanceJoint;
import org.dyn4j.dynamics.joint.Joint;
import org.dyn4j.dynamics.joint.PrismaticJoint;
import org.dyn4j.dynamics.joint.PulleyJoint;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.dynamics.joint.WeldJoint;
import org.dyn4j.dynamics.joint.WheelJoint;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Ray;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.ContactCollisionData;
import org.dyn4j.world.DetectFilter;
import org.dyn4j.world.World;
import org.dyn4j.world.listener.ContactListenerAdapter;
import org.dyn4j.world.result.RaycastResult;

/** A dyn4j world. Settings but the iterations are the engine's own. */
final class Dyn4jSim implements Sim {
  private final World<Body> world = new World<>();
  private final List<Dyn4jBody> pressed = new ArrayList<>();

  Dyn4jSim(int velocityIterations, int positionIterations) {
    world.setGravity(0, -10);
    world.getSettings().setAtRestDetectionEnabled(false);
    world.getSettings().setVelocityConstraintSolverIterations(velocityIterations);
    world.getSettings().setPositionConstraintSolverIterations(positionIterations);
  }

  @Override
  public void gravity(double x, double y) {
    world.setGravity(x, y);
  }

  @Override
  public void allowSleep() {
    world.getSettings().setAtRestDetectionEnabled(true);
  }

  @Override
  public void listen() {
    world.addContactListener(
        new ContactListenerAdapter<Body>() {
          @Override
          public void postSolve(ContactCollisionData<Body> collision, SolvedContact contact) {
            add(collision.getBody1(), contact.getNormalImpulse());
            add(collision.getBody2(), contact.getNormalImpulse());
          }
        });
  }

  private void add(Body target, double impulse) {
    Dyn4jBody body = (Dyn4jBody) target.getUserData();
    if (body.pressed == 0) {
      pressed.add(body);
    }
    body.pressed += impulse;
  }

  @Override
  public SimBody body(Kind kind, double x, double y, double angle) {
    Body body = new Body();
    body.rotate(angle);
    body.translate(x, y);
    // Its default is 0.01, which no scene asks for.
    body.setAngularDamping(0);
    if (kind != Kind.DYNAMIC) {
      body.setMassType(MassType.INFINITE);
    }
    world.addBody(body);
    return new Dyn4jBody(body, kind);
  }

  @Override
  public void remove(SimBody body) {
    world.removeBody(of(body));
  }

  private static Body of(SimBody body) {
    return ((Dyn4jBody) body).body;
  }

  private void add(Joint<Body> joint) {
    world.addJoint(joint);
  }

  @Override
  public void hinge(SimBody a, SimBody b, double x, double y) {
    add(revolute(a, b, x, y));
  }

  /** dyn4j measures the turn of the first body against the second. */
  private static RevoluteJoint<Body> revolute(SimBody a, SimBody b, double x, double y) {
    return new RevoluteJoint<>(of(b), of(a), new Vector2(x, y));
  }

  @Override
  public void motor(SimBody a, SimBody b, double x, double y, double speed, double maxTorque) {
    RevoluteJoint<Body> joint = revolute(a, b, x, y);
    joint.setMotorEnabled(true);
    // Positive speeds turn the second body, which is the one that stands here.
    joint.setMotorSpeed(-speed);
    joint.setMaximumMotorTorqueEnabled(true);
    joint.setMaximumMotorTorque(maxTorque);
    add(joint);
  }

  @Override
  public void limited(SimBody a, SimBody b, double x, double y, double lower, double upper) {
    RevoluteJoint<Body> joint = revolute(a, b, x, y);
    joint.setLimitsEnabled(lower, upper);
    add(joint);
  }

  @Override
  public void rod(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    add(new DistanceJoint<>(of(a), of(b), new Vector2(ax, ay), new Vector2(bx, by)));
  }

  @Override
  public void spring(
      SimBody a, double ax, double ay, SimBody b, double bx, double by, double hz, double ratio) {
    DistanceJoint<Body> joint =
        new DistanceJoint<>(of(a), of(b), new Vector2(ax, ay), new Vector2(bx, by));
    joint.setSpringEnabled(true);
    joint.setSpringFrequency(hz);
    joint.setSpringDamperEnabled(ratio > 0);
    joint.setSpringDampingRatio(Math.max(ratio, Double.MIN_NORMAL));
    add(joint);
  }

  @Override
  public void rope(SimBody a, SimBody b, double length) {
    DistanceJoint<Body> joint =
        new DistanceJoint<>(of(a), of(b), new Vector2(a.x(), a.y()), new Vector2(b.x(), b.y()));
    joint.setLimitsEnabled(0, length);
    add(joint);
  }

  @Override
  public void rail(SimBody a, SimBody b, double x, double y, double ux, double uy) {
    add(new PrismaticJoint<>(of(a), of(b), new Vector2(x, y), new Vector2(ux, uy)));
  }

  @Override
  public void weld(SimBody a, SimBody b, double x, double y) {
    add(new WeldJoint<>(of(a), of(b), new Vector2(x, y)));
  }

  @Override
  public void wheel(SimBody chassis, SimBody wheel, double hz, double ratio) {
    WheelJoint<Body> joint =
        new WheelJoint<>(
            of(chassis), of(wheel), new Vector2(wheel.x(), wheel.y()), new Vector2(0, 1));
    joint.setSpringEnabled(true);
    joint.setSpringFrequency(hz);
    joint.setSpringDamperEnabled(true);
    joint.setSpringDampingRatio(ratio);
    add(joint);
  }

  @Override
  public void pulley(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    add(
        new PulleyJoint<>(
            of(a),
            of(b),
            new Vector2(ax, ay),
            new Vector2(bx, by),
            new Vector2(a.x(), a.y()),
            new Vector2(b.x(), b.y())));
  }

  @Override
  public int bodies() {
    return world.getBodyCount();
  }

  @Override
  public double ray(double ax, double ay, double bx, double by) {
    double length = Math.hypot(bx - ax, by - ay);
    Ray ray = new Ray(new Vector2(ax, ay), new Vector2(bx - ax, by - ay).getNormalized());
    RaycastResult<Body, BodyFixture> hit =
        world.raycastClosest(ray, length, new DetectFilter<>(true, true, null));
    return hit == null ? 1 : hit.getRaycast().getDistance() / length;
  }

  @Override
  public void step(double dt) {
    for (Dyn4jBody body : pressed) {
      body.pressed = 0;
    }
    pressed.clear();
    world.getSettings().setStepFrequency(1 / dt);
    world.step(1, dt);
  }
}
