package org.jbox2d.benchmarks.engines.box2d;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.contacts.Contact;

/**
 * A world with JBox2D's API. The class is loaded twice: for this project's engine, and with JBox2D
 * 2.2.1.1, so it uses what both have.
 */
public class Box2dSim implements Sim {
  /** The world, for engines with more to set. */
  protected final World world = new World(new Vec2(0f, -10f));

  private final int velocityIterations;
  private final int positionIterations;
  private final Box2dJoints joints = new Box2dJoints(world);
  private final List<Box2dBody> pressed = new ArrayList<>();
  private final Vec2 rayStart = new Vec2();
  private final Vec2 rayEnd = new Vec2();
  private final RayCastCallback closest =
      (fixture, point, normal, fraction) -> {
        nearest = fraction;
        return fraction;
      };
  private float nearest;

  /** Creates an empty world. */
  public Box2dSim(int velocityIterations, int positionIterations) {
    this.velocityIterations = velocityIterations;
    this.positionIterations = positionIterations;
    world.setSleepingAllowed(false);
  }

  static Vec2 vec(double x, double y) {
    return new Vec2((float) x, (float) y);
  }

  @Override
  public final void gravity(double x, double y) {
    world.setGravity(vec(x, y));
  }

  @Override
  public final void allowSleep() {
    world.setSleepingAllowed(true);
  }

  @Override
  public final void listen() {
    world.setContactListener(new Press());
  }

  @Override
  public final SimBody body(Kind kind, double x, double y, double angle) {
    BodyDef def = new BodyDef();
    def.type = BodyType.valueOf(kind.name());
    def.position.set((float) x, (float) y);
    def.angle = (float) angle;
    return new Box2dBody(world.createBody(def));
  }

  @Override
  public final void remove(SimBody body) {
    world.destroyBody(((Box2dBody) body).body);
  }

  @Override
  public final void hinge(SimBody a, SimBody b, double x, double y) {
    joints.hinge(a, b, x, y);
  }

  @Override
  public final void motor(SimBody a, SimBody b, double x, double y, double speed, double torque) {
    joints.motor(a, b, x, y, speed, torque);
  }

  @Override
  public final void limited(SimBody a, SimBody b, double x, double y, double low, double high) {
    joints.limited(a, b, x, y, low, high);
  }

  @Override
  public final void rod(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    joints.spring(a, vec(ax, ay), b, vec(bx, by), 0, 0);
  }

  @Override
  public final void spring(
      SimBody a, double ax, double ay, SimBody b, double bx, double by, double hz, double ratio) {
    joints.spring(a, vec(ax, ay), b, vec(bx, by), hz, ratio);
  }

  @Override
  public final void rope(SimBody a, SimBody b, double length) {
    joints.rope(a, b, length);
  }

  @Override
  public final void rail(SimBody a, SimBody b, double x, double y, double ux, double uy) {
    joints.rail(a, b, vec(x, y), vec(ux, uy));
  }

  @Override
  public final void weld(SimBody a, SimBody b, double x, double y) {
    joints.weld(a, b, x, y);
  }

  @Override
  public final void wheel(SimBody chassis, SimBody wheel, double hz, double ratio) {
    joints.wheel(chassis, wheel, hz, ratio);
  }

  @Override
  public final void pulley(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    joints.pulley(a, vec(ax, ay), b, vec(bx, by));
  }

  @Override
  public final int bodies() {
    return world.getBodyCount();
  }

  @Override
  public final double ray(double ax, double ay, double bx, double by) {
    rayStart.set((float) ax, (float) ay);
    rayEnd.set((float) bx, (float) by);
    nearest = 1f;
    world.raycast(closest, rayStart, rayEnd);
    return nearest;
  }

  @Override
  public final void step(double dt) {
    if (!pressed.isEmpty()) {
      pressed.forEach(body -> body.pressed = 0);
      pressed.clear();
    }
    world.step((float) dt, velocityIterations, positionIterations);
  }

  /** Adds up impulses by body. */
  private final class Press implements ContactListener {
    @Override
    public void beginContact(Contact contact) {}

    @Override
    public void endContact(Contact contact) {}

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {}

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
      double sum = 0;
      for (int i = 0; i < impulse.count; i++) {
        sum += impulse.normalImpulses[i];
      }
      add(contact.getFixtureA(), sum);
      add(contact.getFixtureB(), sum);
    }

    private void add(Fixture fixture, double impulse) {
      Box2dBody body = (Box2dBody) fixture.getBody().getUserData();
      if (body.pressed == 0) {
        pressed.add(body);
      }
      body.pressed += impulse;
    }
  }
}
