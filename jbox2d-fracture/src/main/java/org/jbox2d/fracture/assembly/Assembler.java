package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.DestructionListener;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.fracture.Material;

/**
 * Carries a plan out: replaces a body by its pieces.
 *
 * <p>All pieces keep the frame of the old body: origin, angle and local coordinates are the same,
 * so anchors of joints and a game's textures stay where they are. If something stays, its largest
 * part is the old body itself, with its joints and its other fixtures; what no longer hangs
 * together with it, and each splinter, becomes a body of its own. If nothing stays, the old body is
 * destroyed.
 *
 * <p>Every piece moves on as the part of the rigid body that it was: {@code v_f = v + w x (c_f -
 * c)}, with c the centres of mass. As the masses and inertias of the pieces add up to the body's,
 * so do linear and angular momentum.
 */
public final class Assembler {
  private Assembler() {}

  /**
   * Carries out a plan that breaks something.
   *
   * @param splinterMaterial material of the splinters; may be {@code null}
   * @return the bodies made: what stays first, then the splinters
   */
  public static List<Body> carryOut(World world, Plan plan, Material splinterMaterial) {
    Body old = plan.request.body;
    Motion motion = new Motion(old);
    List<Cluster> clusters = Clusters.of(plan);
    Cluster kept = Clusters.largest(clusters);
    List<Body> bodies = new ArrayList<>();
    List<Body> made = new ArrayList<>();
    for (Cluster cluster : clusters) {
      if (cluster != kept) {
        Body body = makeCluster(world, old, plan, cluster);
        made.add(body);
      }
    }
    makeSplinters(world, old, plan, splinterMaterial, made);
    moveJoints(world, old, kept, plan, clusters, made);
    if (kept != null) {
      keep(world, old, plan, kept);
      bodies.add(old);
    } else {
      world.destroyBody(old);
    }
    bodies.addAll(made);
    motion.giveTo(bodies);
    return bodies;
  }

  private static void makeSplinters(
      World world, Body old, Plan plan, Material material, List<Body> made) {
    BodyDef bodyDef = definition(old, BodyType.DYNAMIC);
    FixtureDef def = brokenTemplate(plan);
    def.material = material;
    float density = def.density;
    for (Piece splinter : plan.splinters) {
      Body body = world.createBody(bodyDef);
      def.density = density * splinter.densityFactor;
      body.createFixture(def, splinter);
      made.add(body);
    }
  }

  private static Body makeCluster(World world, Body old, Plan plan, Cluster cluster) {
    Body body = world.createBody(definition(old, old.getType()));
    for (Piece remainder : cluster.remainders) {
      addRemainder(body, brokenTemplate(plan), plan, remainder);
    }
    for (List<Fixture> group : cluster.others) {
      copyGroup(body, group);
    }
    return body;
  }

  /** Makes fixtures like those of a group on another body; a compound stays a compound. */
  private static void copyGroup(Body body, List<Fixture> group) {
    Fixture first = group.get(0);
    if (first.getCompound() != null && group.size() == first.getCompound().getParts().length) {
      inherit(first, body.createFixture(template(first), first.getCompound()));
      return;
    }
    for (Fixture f : group) {
      FixtureDef def = template(f);
      def.shape = f.getShape();
      body.createFixture(def).m_materialState = f.m_materialState;
    }
  }

  /** What stays remembers the blows that did not break it. */
  private static void inherit(Fixture from, List<Fixture> to) {
    for (Fixture f : to) {
      f.m_materialState = from.m_materialState;
    }
  }

  /**
   * The old body goes on as the kept cluster: what broke and what has left go, its remainders come.
   */
  private static void keep(World world, Body old, Plan plan, Cluster kept) {
    FixtureDef def = brokenTemplate(plan);
    List<Fixture> leaving = new ArrayList<>();
    for (Fixture f = old.getFixtureList(); f != null; f = f.getNext()) {
      if (!kept.holds(f)) {
        leaving.add(f);
      }
    }
    DestructionListener listener = world.getDestructionListener();
    if (listener != null) {
      for (Fixture f : leaving) {
        listener.sayGoodbye(f);
      }
    }
    old.destroyFixtures(leaving);
    for (Piece remainder : kept.remainders) {
      addRemainder(old, def, plan, remainder);
    }
  }

  private static void addRemainder(Body body, FixtureDef def, Plan plan, Piece remainder) {
    float density = def.density;
    def.density = density * remainder.densityFactor;
    inherit(plan.request.fixture, body.createFixture(def, remainder));
    def.density = density;
  }

  private static BodyDef definition(Body old, BodyType type) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(old.getPosition());
    def.angle = old.getAngle();
    def.linearDamping = old.getLinearDamping();
    def.angularDamping = old.getAngularDamping();
    def.gravityScale = old.getGravityScale();
    def.allowSleep = old.isSleepingAllowed();
    def.fixedRotation = old.isFixedRotation();
    def.bullet = old.isBullet();
    def.userData = old.getUserData();
    return def;
  }

  /**
   * The attributes of what breaks, with the density that it would have without the factor of its
   * last breaking.
   */
  private static FixtureDef brokenTemplate(Plan plan) {
    FixtureDef def = template(plan.request.fixture);
    def.density /= plan.breakable.densityFactor;
    return def;
  }

  private static FixtureDef template(Fixture f) {
    FixtureDef def = new FixtureDef();
    def.density = f.getDensity();
    def.friction = f.getFriction();
    def.restitution = f.getRestitution();
    def.isSensor = f.isSensor();
    def.filter.set(f.m_filter);
    def.userData = f.getUserData();
    def.material = f.getMaterial();
    return def;
  }

  /**
   * Joints go to the piece that holds their anchor; those whose anchor no piece holds stay with the
   * old body.
   */
  private static void moveJoints(
      World world, Body old, Cluster kept, Plan plan, List<Cluster> clusters, List<Body> made) {
    if (old.getJointList() == null) {
      return;
    }
    AnchorSearch search = new AnchorSearch(old, kept, plan, clusters, made);
    for (Joint joint : search.jointsOf(old)) {
      Body target = search.bodyAtAnchor(joint);
      if (target != null) {
        world.moveJoint(joint, old, target);
      }
    }
  }

  /** The motion of the old body when it broke. */
  private static final class Motion {
    private final double mass;
    private final double inertia;
    private final double x;
    private final double y;
    private final double vx;
    private final double vy;
    private final double w;

    Motion(Body b) {
      mass = b.m_mass;
      inertia = b.m_I;
      x = b.getWorldCenter().x;
      y = b.getWorldCenter().y;
      vx = b.getLinearVelocity().x;
      vy = b.getLinearVelocity().y;
      w = b.getAngularVelocity();
    }

    /**
     * Lets the pieces go on as one rigid body with the old one's momentum and angular momentum.
     * Rounding has moved their common centre and changed their common inertia a little, so the
     * motion is that of these: with M, C and J of the pieces together, {@code V = m v / M} and
     * {@code W = (I w + m (c - C) x v) / J}.
     */
    void giveTo(List<Body> pieces) {
      double sumMass = 0;
      double cx = 0;
      double cy = 0;
      for (Body b : pieces) {
        sumMass += b.m_mass;
        cx += (double) b.m_mass * b.getWorldCenter().x;
        cy += (double) b.m_mass * b.getWorldCenter().y;
      }
      if (!(mass > 0 && sumMass > 0)) {
        move(pieces, x, y, vx, vy, w);
        return;
      }
      cx /= sumMass;
      cy /= sumMass;
      double sumInertia = 0;
      for (Body b : pieces) {
        double dx = b.getWorldCenter().x - cx;
        double dy = b.getWorldCenter().y - cy;
        sumInertia += b.m_I + b.m_mass * (dx * dx + dy * dy);
      }
      double spin = inertia * w + mass * ((x - cx) * vy - (y - cy) * vx);
      boolean turns = inertia > 0 && sumInertia > 0;
      move(pieces, cx, cy, mass * vx / sumMass, mass * vy / sumMass, turns ? spin / sumInertia : w);
    }

    private static void move(
        List<Body> pieces, double cx, double cy, double vx, double vy, double w) {
      for (Body b : pieces) {
        if (b.getType() != BodyType.STATIC) {
          b.setAwake(true);
          b.m_linearVelocity.x = (float) (vx - w * (b.getWorldCenter().y - cy));
          b.m_linearVelocity.y = (float) (vy + w * (b.getWorldCenter().x - cx));
          b.m_angularVelocity = (float) w;
        }
      }
    }
  }
}
