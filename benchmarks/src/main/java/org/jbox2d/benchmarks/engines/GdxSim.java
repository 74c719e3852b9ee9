package org.jbox2d.benchmarks.engines;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.Contact;
import com.badlogic.gdx.physics.box2d.ContactImpulse;
import com.badlogic.gdx.physics.box2d.ContactListener;
import com.badlogic.gdx.physics.box2d.Manifold;
import com.badlogic.gdx.physics.box2d.RayCastCallback;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.physics.box2d.joints.DistanceJointDef;
import com.badlogic.gdx.physics.box2d.joints.PrismaticJointDef;
import com.badlogic.gdx.physics.box2d.joints.PulleyJointDef;
import com.badlogic.gdx.physics.box2d.joints.RevoluteJointDef;
import com.badlogic.gdx.physics.box2d.joints.RopeJointDef;
import com.badlogic.gdx.physics.box2d.joints.WeldJointDef;
import com.badlogic.gdx.physics.box2d.joints.WheelJointDef;
import com.badlogic.gdx.utils.GdxNativesLoader;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** A world of gdx-box2d: Box2D in C++ behind JNI. */
final class GdxSim implements Sim {
  private final World world;
  private final int velocityIterations;
  private final int positionIterations;
  private final Set<GdxBody> bodies = new LinkedHashSet<>();
  private final List<GdxBody> pressed = new ArrayList<>();
  private final RayCastCallback closest =
      (fixture, point, normal, fraction) -> {
        nearest = fraction;
        return fraction;
      };
  private float nearest;
  private boolean sleep;

  static {
    GdxNativesLoader.load();
    Box2D.init();
  }

  GdxSim(int velocityIterations, int positionIterations) {
    this.velocityIterations = velocityIterations;
    this.positionIterations = positionIterations;
    world = new World(new Vector2(0f, -10f), true);
  }

  private static Vector2 vec(double x, double y) {
    return new Vector2((float) x, (float) y);
  }

  @Override
  public void gravity(double x, double y) {
    world.setGravity(vec(x, y));
  }

  @Override
  public void allowSleep() {
    sleep = true;
    for (GdxBody body : bodies) {
      body.body.setSleepingAllowed(true);
    }
  }

  @Override
  public void listen() {
    world.setContactListener(new Press());
  }

  @Override
  public SimBody body(Kind kind, double x, double y, double angle) {
    BodyDef def = new BodyDef();
    def.type =
        switch (kind) {
          case STATIC -> BodyDef.BodyType.StaticBody;
          case KINEMATIC -> BodyDef.BodyType.KinematicBody;
          case DYNAMIC -> BodyDef.BodyType.DynamicBody;
        };
    def.position.set((float) x, (float) y);
    def.angle = (float) angle;
    def.allowSleep = sleep;
    GdxBody body = new GdxBody(world.createBody(def));
    bodies.add(body);
    return body;
  }

  @Override
  public void remove(SimBody body) {
    bodies.remove((GdxBody) body);
    world.destroyBody(of(body));
  }

  private static Body of(SimBody body) {
    return ((GdxBody) body).body;
  }

  private static RevoluteJointDef revolute(SimBody a, SimBody b, double x, double y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(of(a), of(b), vec(x, y));
    return def;
  }

  @Override
  public void hinge(SimBody a, SimBody b, double x, double y) {
    world.createJoint(revolute(a, b, x, y));
  }

  @Override
  public void motor(SimBody a, SimBody b, double x, double y, double speed, double maxTorque) {
    RevoluteJointDef def = revolute(a, b, x, y);
    def.enableMotor = true;
    def.motorSpeed = (float) speed;
    def.maxMotorTorque = (float) maxTorque;
    world.createJoint(def);
  }

  @Override
  public void limited(SimBody a, SimBody b, double x, double y, double lower, double upper) {
    RevoluteJointDef def = revolute(a, b, x, y);
    def.enableLimit = true;
    def.lowerAngle = (float) lower;
    def.upperAngle = (float) upper;
    world.createJoint(def);
  }

  @Override
  public void rod(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    spring(a, ax, ay, b, bx, by, 0, 0);
  }

  @Override
  public void spring(
      SimBody a, double ax, double ay, SimBody b, double bx, double by, double hz, double ratio) {
    DistanceJointDef def = new DistanceJointDef();
    def.initialize(of(a), of(b), vec(ax, ay), vec(bx, by));
    def.frequencyHz = (float) hz;
    def.dampingRatio = (float) ratio;
    world.createJoint(def);
  }

  @Override
  public void rope(SimBody a, SimBody b, double length) {
    RopeJointDef def = new RopeJointDef();
    def.bodyA = of(a);
    def.bodyB = of(b);
    def.localAnchorA.setZero();
    def.localAnchorB.setZero();
    def.maxLength = (float) length;
    world.createJoint(def);
  }

  @Override
  public void rail(SimBody a, SimBody b, double x, double y, double ux, double uy) {
    PrismaticJointDef def = new PrismaticJointDef();
    def.initialize(of(a), of(b), vec(x, y), vec(ux, uy));
    world.createJoint(def);
  }

  @Override
  public void weld(SimBody a, SimBody b, double x, double y) {
    WeldJointDef def = new WeldJointDef();
    def.initialize(of(a), of(b), vec(x, y));
    world.createJoint(def);
  }

  @Override
  public void wheel(SimBody chassis, SimBody wheel, double hz, double ratio) {
    WheelJointDef def = new WheelJointDef();
    def.initialize(of(chassis), of(wheel), of(wheel).getPosition(), vec(0, 1));
    def.frequencyHz = (float) hz;
    def.dampingRatio = (float) ratio;
    world.createJoint(def);
  }

  @Override
  public void pulley(SimBody a, double ax, double ay, SimBody b, double bx, double by) {
    PulleyJointDef def = new PulleyJointDef();
    def.initialize(
        of(a), of(b), vec(ax, ay), vec(bx, by), vec(a.x(), a.y()), vec(b.x(), b.y()), 1f);
    world.createJoint(def);
  }

  @Override
  public int bodies() {
    return world.getBodyCount();
  }

  @Override
  public double ray(double ax, double ay, double bx, double by) {
    nearest = 1f;
    world.rayCast(closest, (float) ax, (float) ay, (float) bx, (float) by);
    return nearest;
  }

  @Override
  public void step(double dt) {
    for (GdxBody body : pressed) {
      body.pressed = 0;
    }
    pressed.clear();
    world.step((float) dt, velocityIterations, positionIterations);
  }

  @Override
  public void close() {
    world.dispose();
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
      float[] normal = impulse.getNormalImpulses();
      for (int i = 0; i < impulse.getCount(); i++) {
        sum += normal[i];
      }
      add((GdxBody) contact.getFixtureA().getBody().getUserData(), sum);
      add((GdxBody) contact.getFixtureB().getBody().getUserData(), sum);
    }

    private void add(GdxBody body, double impulse) {
      if (body.pressed == 0) {
        pressed.add(body);
      }
      body.pressed += impulse;
    }
  }
}
