package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.joints.DistanceJoint;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.FrictionJointDef;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.dynamics.joints.JointEdge;
import org.jbox2d.dynamics.joints.PrismaticJoint;
import org.jbox2d.dynamics.joints.PrismaticJointDef;
import org.jbox2d.dynamics.joints.RevoluteJoint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.RopeJoint;
import org.jbox2d.dynamics.joints.RopeJointDef;
import org.jbox2d.dynamics.joints.WeldJoint;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.jbox2d.dynamics.joints.WheelJointDef;

/**
 * Boxes and joints of many kinds above ground, to which in every third step or so something is done
 * that joints depend on. The same seed does the same.
 */
final class DisturbedJoints implements ContactListener {
  private static final int BODIES = 24;
  private static final int JOINTS = 60;

  /** N s; usual ones are below 1. */
  private static final float MOST_IMPULSE = 1e4f;

  final World world = Make.world();
  private final Random random;
  private final List<Body> still = new ArrayList<>();
  private final List<Body> bodies = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();

  /** Vectors of joints that have been handed out. */
  private final List<Vec2> exposed = new ArrayList<>();

  private float dt = Make.STEP;
  private int steps;
  private int reads;
  private int met;
  private long heard;

  DisturbedJoints(int seed) {
    random = new Random(seed);
    world.setContactListener(this);
    switchSolver(seed);
    still.add(Make.ground(world));
    still.add(Make.box(world, BodyType.STATIC, 3f, 1f, 0.5f, 1f));
    still.add(Make.box(world, BodyType.STATIC, 9f, 2f, 0.5f, 2f));
    Body lift = Make.box(world, BodyType.KINEMATIC, 6f, 3f, 0.5f, 0.1f);
    lift.setAngularVelocity(0.3f);
    still.add(lift);
    for (int i = 0; i < BODIES; i++) {
      bodies.add(box());
    }
    for (int i = 0; i < JOINTS; i++) {
      tie();
    }
  }

  void step() {
    world.step(dt, 6, 2);
  }

  /** Of the states, and now and then of the joints' reactions: these may not be read in between. */
  long hash() {
    long hash = 31 * StateHash.of(world) + heard;
    if (++steps % 10 == 0) {
      hash = 31 * hash + reactions();
      joints.removeIf(this::tears);
    }
    return hash;
  }

  /** Joints that contradict each other pull harder and harder. */
  private boolean tears(Joint joint) {
    Vec2 force = new Vec2();
    joint.getReactionForce(1f, force);
    boolean torn = !(force.length() < MOST_IMPULSE);
    if (torn) {
      world.destroyJoint(joint);
    }
    return torn;
  }

  /** Of all joints, whether awake or not. */
  long reactions() {
    long hash = 0;
    for (Joint joint : joints) {
      hash = 31 * hash + reaction(joint);
    }
    return hash;
  }

  /** One of those there are, another each time: any of them may be asked for first. */
  private long reaction(Joint joint) {
    switch (reads++ % 3) {
      case 0 -> {
        Vec2 force = new Vec2();
        joint.getReactionForce(1f, force);
        return 31L * Float.floatToRawIntBits(force.x) + Float.floatToRawIntBits(force.y);
      }
      case 1 -> {
        return Float.floatToRawIntBits(joint.getReactionTorque(1f));
      }
      default -> {
        if (joint instanceof RevoluteJoint j) {
          return Float.floatToRawIntBits(j.getMotorTorque(1f));
        } else if (joint instanceof PrismaticJoint j) {
          return Float.floatToRawIntBits(j.getMotorForce(1f));
        }
        return joint instanceof RopeJoint j ? j.getLimitState().ordinal() : 0;
      }
    }
  }

  // --- What there is ---

  private Body box() {
    float x = 12f * random.nextFloat();
    return Make.box(world, BodyType.DYNAMIC, x, 1f + 5f * random.nextFloat(), 0.3f, 0.2f);
  }

  private Body any() {
    return bodies.get(random.nextInt(bodies.size()));
  }

  private float between(float a, float b) {
    return a + (b - a) * random.nextFloat();
  }

  /**
   * Ties a body that hangs on none yet to one before it: joints in a ring may contradict others.
   */
  private void tie() {
    Body a = random.nextInt(3) == 0 ? still.get(random.nextInt(still.size())) : any();
    Body b = any();
    if (!canHang(b, a)) {
      return;
    }
    Vec2 at = b.getWorldPoint(new Vec2(between(-0.3f, 0.3f), 0.1f));
    boolean collide = random.nextInt(4) == 0;
    switch (random.nextInt(10)) {
      case 0 -> {
        WeldJointDef def = new WeldJointDef();
        def.initialize(a, b, at);
        def.frequencyHz = random.nextBoolean() ? 0f : 4f;
        def.dampingRatio = 0.5f;
        add(def, collide);
      }
      case 1, 2 -> {
        DistanceJointDef def = new DistanceJointDef();
        def.initialize(a, b, a.getWorldCenter(), at);
        def.frequencyHz = random.nextInt(3) > 0 ? 0f : 4f;
        def.dampingRatio = 0.5f;
        add(def, collide);
      }
      case 3 -> {
        RopeJointDef def = new RopeJointDef();
        def.bodyA = a;
        def.bodyB = b;
        def.localAnchorB.set(0.1f, 0f);
        def.maxLength = 0.001f + random.nextInt(2) * a.getWorldCenter().sub(at).length();
        add(def, collide);
      }
      case 4 -> {
        PrismaticJointDef def = new PrismaticJointDef();
        def.initialize(a, b, at, new Vec2(0.6f, 0.8f));
        def.enableLimit = random.nextBoolean();
        def.lowerTranslation = -0.5f;
        def.upperTranslation = 0.3f;
        def.enableMotor = random.nextBoolean();
        def.motorSpeed = 1f;
        def.maxMotorForce = 10f;
        add(def, collide);
      }
      case 5 -> {
        WheelJointDef def = new WheelJointDef();
        def.initialize(a, b, at, new Vec2(0f, 1f));
        add(def, collide);
      }
      case 6 -> {
        FrictionJointDef def = new FrictionJointDef();
        def.initialize(a, b, at);
        def.maxForce = 1f;
        def.maxTorque = 0.1f;
        add(def, collide);
      }
      default -> {
        RevoluteJointDef def = new RevoluteJointDef();
        def.initialize(a, b, at);
        def.enableLimit = random.nextBoolean();
        def.lowerAngle = -0.3f;
        def.upperAngle = 0.2f;
        def.enableMotor = random.nextBoolean();
        def.motorSpeed = 2f;
        def.maxMotorTorque = 1f;
        add(def, collide);
      }
    }
  }

  private boolean canHang(Body b, Body on) {
    return bodies.indexOf(on) < bodies.indexOf(b)
        && joints.stream().noneMatch(j -> j.getBodyB() == b);
  }

  private void add(JointDef def, boolean collide) {
    def.collideConnected = collide;
    joints.add(world.createJoint(def));
  }

  // --- What is done ---

  void disturb() {
    switch (random.nextInt(60)) {
      case 0, 1, 2, 3, 4 -> changeJoint();
      case 5, 6, 7, 8 -> changeBody();
      case 9, 18 -> changeSets();
      case 10 -> world.setWarmStarting(random.nextInt(4) > 0);
      case 11 -> dt = random.nextInt(5) == 0 ? 0f : between(0.01f, 0.02f);
      case 12 -> switchSolver(random.nextInt(4));
      case 13 -> expose();
      case 14, 15 -> moveExposed();
      case 16 -> heard = 31 * heard + reactions();
      case 17 -> world.setGravity(new Vec2(between(-3f, 3f), -10f));
      default -> {}
    }
  }

  private void switchSolver(int which) {
    world.setSolver(
        switch (which % 4) {
          case 0 -> Solver.sequentialImpulses();
          case 1 -> Solver.softStep();
          case 2 -> Solver.softStep(3);
          default -> Solver.adaptive();
        });
  }

  private void changeJoint() {
    if (joints.isEmpty()) {
      return;
    }
    Joint joint = joints.get(random.nextInt(joints.size()));
    int what = random.nextInt(5);
    float value = between(0f, 2f);
    boolean flag = random.nextBoolean();
    if (joint instanceof RevoluteJoint j) {
      switch (what) {
        case 0 -> j.enableLimit(flag);
        case 1 -> j.setLimits(-value, 0.5f * value);
        case 2 -> j.enableMotor(flag);
        case 3 -> j.setMotorSpeed(value - 1f);
        default -> j.setMaxMotorTorque(value);
      }
    } else if (joint instanceof PrismaticJoint j) {
      switch (what) {
        case 0 -> j.enableLimit(flag);
        case 1 -> j.setLimits(-value, 0.5f * value);
        case 2 -> j.enableMotor(flag);
        case 3 -> j.setMotorSpeed(value - 1f);
        default -> j.setMaxMotorForce(5f * value);
      }
    } else if (joint instanceof WeldJoint j) {
      switch (what) {
        case 0, 1, 2 -> j.setFrequency(flag ? 0f : 3f * value);
        default -> j.setDampingRatio(value);
      }
    } else if (joint instanceof DistanceJoint j) {
      switch (what) {
        case 0, 1 -> j.setFrequency(flag ? 0f : 3f * value);
        case 2 -> j.setDampingRatio(value);
        default -> j.setLength(flag ? 0f : value);
      }
    } else if (joint instanceof RopeJoint j) {
      j.setMaxLength(flag ? 0f : value);
    }
  }

  /** Gets hold of a vector of each joint, so that none is kept in its row. */
  void exposeAll() {
    for (Joint joint : joints) {
      vectorOf(joint, 0);
    }
  }

  private void expose() {
    Vec2 vector = vectorOf(joints.get(random.nextInt(joints.size())), random.nextInt(4));
    if (vector != null) {
      exposed.add(vector);
    }
  }

  private static Vec2 vectorOf(Joint joint, int which) {
    boolean a = which % 2 == 0;
    if (joint instanceof RevoluteJoint j) {
      return a ? j.getLocalAnchorA() : j.getLocalAnchorB();
    } else if (joint instanceof PrismaticJoint j) {
      return which == 2 ? j.getLocalAxisA() : a ? j.getLocalAnchorA() : j.getLocalAnchorB();
    } else if (joint instanceof WeldJoint j) {
      return a ? j.getLocalAnchorA() : j.getLocalAnchorB();
    } else if (joint instanceof DistanceJoint j) {
      return a ? j.getLocalAnchorA() : j.getLocalAnchorB();
    } else if (joint instanceof RopeJoint j) {
      return a ? j.getLocalAnchorA() : j.getLocalAnchorB();
    }
    return null;
  }

  private void moveExposed() {
    if (!exposed.isEmpty()) {
      exposed.get(random.nextInt(exposed.size())).x += between(-0.05f, 0.05f);
    }
  }

  /** Changes that leave the set of awake bodies as it is, if the body is awake. */
  private void changeBody() {
    Body b = any();
    switch (random.nextInt(10)) {
      case 0 -> {
        MassData data = new MassData();
        b.getMassData(data);
        data.center.x += 0.05f;
        data.I = 0.1f + data.mass * data.center.lengthSquared();
        b.setMassData(data);
      }
      case 1 -> b.getLocalCenter().y += 0.01f;
      case 2 -> b.resetMassData();
      case 3 -> b.setFixedRotation(!b.isFixedRotation());
      case 4 -> b.createFixture(Make.circle(between(0.1f, 0.3f)), 2f);
      case 5 -> {
        if (b.m_fixtureCount > 1) {
          b.destroyFixture(b.getFixtureList());
        }
      }
      case 6 -> b.setTransform(b.getPosition().add(new Vec2(0f, 0.1f)), b.getAngle() + 0.1f);
      case 7 -> b.m_linearVelocity.set(between(-3f, 3f), between(0f, 3f));
      case 8 -> still.get(1).getLocalCenter().x = between(-0.1f, 0.1f);
      default -> b.applyLinearImpulse(new Vec2(0f, 1f), any().getPosition());
    }
  }

  private void changeSets() {
    Body b = any();
    switch (random.nextInt(11)) {
      case 0 -> tie();
      case 1 -> {
        if (joints.size() > BODIES / 2) {
          Joint joint = joints.remove(random.nextInt(joints.size()));
          world.destroyJoint(joint);
          heard = 31 * heard + reaction(joint);
        }
      }
      case 2 -> b.setAwake(false);
      case 3 -> b.setAwake(true);
      case 4 -> b.setActive(!b.isActive());
      case 5 -> b.setType(BodyType.values()[random.nextInt(3)]);
      case 6 -> {
        bodies.remove(b);
        joints.removeIf(j -> j.getBodyA() == b || j.getBodyB() == b);
        world.destroyBody(b);
        bodies.add(box());
      }
      case 7 -> still.get(1).setActive(!still.get(1).isActive());
      case 8 -> moveJoint();
      case 9 -> world.setAllowSleep(random.nextBoolean());
      default -> b.setType(BodyType.DYNAMIC);
    }
  }

  private void moveJoint() {
    Joint joint = joints.get(random.nextInt(joints.size()));
    Body to = any();
    if (canHang(to, joint.getBodyA())) {
      world.moveJoint(joint, joint.getBodyB(), to);
    }
  }

  // --- In the middle of a step ---

  @Override
  public void beginContact(Contact contact) {
    hear(contact.getFixtureB().getBody());
  }

  @Override
  public void endContact(Contact contact) {}

  @Override
  public void preSolve(Contact contact, Manifold oldManifold) {
    hear(contact.getFixtureB().getBody());
  }

  @Override
  public void postSolve(Contact contact, ContactImpulse impulse) {
    hear(contact.getFixtureB().getBody());
  }

  /** Looks at the reactions of a body's joints, or changes one of them. */
  private void hear(Body body) {
    met++;
    for (JointEdge edge = body.getJointList(); edge != null; edge = edge.next) {
      if (met % 31 == 0) {
        heard = 31 * heard + reaction(edge.joint);
      } else if (met % 67 == 0 && edge.joint instanceof RevoluteJoint j) {
        j.setMotorSpeed(1f - j.getMotorSpeed());
      } else if (met % 67 == 0 && edge.joint instanceof WeldJoint j) {
        j.setFrequency(j.getFrequency() > 0f ? 0f : 5f);
      }
    }
  }
}
