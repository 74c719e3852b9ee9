package org.jbox2d.testbed.simulation;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Predicate;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.MouseJoint;
import org.jbox2d.dynamics.joints.MouseJointDef;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.scenes.Scenes;

/** What the user does to the world. Runs on the simulation's thread, between steps. */
final class Interaction {
  /** Half-size of the box in which a body is looked for under the pointer, m. */
  private static final float REACH = 0.001f;

  /** Greatest acceleration that dragging gives a body, m/s^2. */
  private static final float DRAG_ACCELERATION = 1000f;

  /** How far from its target a shot starts, m. */
  private static final float SHOT_DISTANCE = 25f;

  private final Simulation run;
  private final World world;

  Interaction(Simulation run) {
    this.run = run;
    world = run.world();
  }

  /** Does what the user does to the world. */
  void act(Input input) {
    float x = input.action() == Input.Action.RELEASE ? 0f : input.real(0);
    switch (input.action()) {
      case GRAB:
        grab(x, input.real(1));
        break;
      case DRAG:
        dragTo(x, input.real(1));
        break;
      case RELEASE:
        release();
        break;
      case THROW:
        shoot(x, input.real(1));
        break;
      case BREAK:
        breakAt(x, input.real(1));
        break;
      case CUT:
        cut(x, input.real(1), input.real(2), input.real(3));
        break;
      case EXPLODE:
        explode(x, input.real(1));
        break;
      default:
        throw new IllegalArgumentException("not done to the world: " + input);
    }
  }

  /** Takes hold of the dynamic body at a world point, if there is one. */
  private void grab(float x, float y) {
    release();
    Vec2 point = new Vec2(x, y);
    Fixture fixture = fixtureAt(point, f -> f.getBody().getType() == BodyType.DYNAMIC);
    Body ground = anyStatic();
    if (fixture == null || ground == null) {
      return;
    }
    Body body = fixture.getBody();
    MouseJointDef def = new MouseJointDef();
    def.bodyA = ground;
    def.bodyB = body;
    def.userData = this;
    def.target.set(point);
    def.maxForce = DRAG_ACCELERATION * body.getMass();
    world.createJoint(def);
    body.setAwake(true);
  }

  /** Pulls what has been grabbed towards a world point. */
  private void dragTo(float x, float y) {
    MouseJoint joint = held();
    if (joint != null) {
      joint.getBodyB().setAwake(true);
      joint.setTarget(new Vec2(x, y));
    }
  }

  /** Lets go. */
  private void release() {
    MouseJoint joint = held();
    if (joint != null) {
      world.destroyJoint(joint);
    }
  }

  /** Throws a heavy disc at a world point, from the left and a little above. */
  private void shoot(float x, float y) {
    float radius = (float) run.value(Tools.SHOT_RADIUS);
    float inside = Scenes.BOX_HALF_WIDTH - 2f * radius;
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.bullet = true;
    def.position.set(Math.max(-inside, Math.min(inside, x - SHOT_DISTANCE)), Math.max(y, radius));
    def.linearVelocity.set((float) run.value(Tools.SHOT_SPEED), 0f);
    Body body = world.createBody(def);
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    FixtureDef substance = new FixtureDef();
    substance.shape = shape;
    substance.density = (float) run.value(Tools.SHOT_DENSITY);
    body.createFixture(substance);
    run.massBalance().leaveOut(body);
  }

  /** Strikes what is at a world point, from above, twice as hard as it bears. */
  private void breakAt(float x, float y) {
    Vec2 point = new Vec2(x, y);
    Fixture fixture = fixtureAt(point, f -> f.getMaterial() instanceof Material);
    if (fixture != null) {
      float rigidity = ((Material) fixture.getMaterial()).m_rigidity;
      FractureSystem.of(world).strike(fixture, point, new Vec2(0f, -2f * rigidity));
    }
  }

  /** Cuts every body that a segment between two world points goes through; scenery stays whole. */
  private void cut(float x1, float y1, float x2, float y2) {
    Vec2 from = new Vec2(x1, y1);
    Vec2 to = new Vec2(x2, y2);
    if (from.equals(to)) {
      return;
    }
    Set<Body> hit = new LinkedHashSet<>();
    world.raycast(
        (fixture, point, normal, fraction) -> {
          if (fixture.getBody().getType() == BodyType.DYNAMIC || fixture.getMaterial() != null) {
            hit.add(fixture.getBody());
          }
          return 1f;
        },
        from,
        to);
    for (Body body : hit) {
      FractureSystem.of(world).cut(body, from, to);
    }
  }

  /** Sets off an explosion. */
  private void explode(float x, float y) {
    FractureSystem.of(world)
        .explode(
            new Vec2(x, y),
            (float) run.value(Tools.BLAST_RADIUS),
            (float) run.value(Tools.BLAST_IMPULSE));
  }

  /**
   * The joint of the last grab. It is looked up, not kept: it goes with its body when that breaks,
   * or is replaced by one that holds the fragment.
   */
  private MouseJoint held() {
    for (Joint j = world.getJointList(); j != null; j = j.getNext()) {
      if (j.getUserData() == this && j instanceof MouseJoint mouse) {
        return mouse;
      }
    }
    return null;
  }

  private Body anyStatic() {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() == BodyType.STATIC) {
        return b;
      }
    }
    return null;
  }

  private Fixture fixtureAt(Vec2 point, Predicate<Fixture> wanted) {
    AABB box =
        new AABB(
            new Vec2(point.x - REACH, point.y - REACH), new Vec2(point.x + REACH, point.y + REACH));
    Fixture[] found = new Fixture[1];
    world.queryAABB(
        fixture -> {
          if (wanted.test(fixture) && fixture.testPoint(point)) {
            found[0] = fixture;
          }
          return found[0] == null;
        },
        box);
    return found[0];
  }
}
