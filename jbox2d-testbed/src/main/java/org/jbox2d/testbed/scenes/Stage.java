package org.jbox2d.testbed.scenes;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.PolygonFixture;

/**
 * What scenes are put together from: a world, the static box around it, and bodies of one box or
 * disc. Lengths are in metres, boxes are given by their half-sizes.
 */
final class Stage {
  /** Friction of everything but discs, if a scene does not say otherwise. */
  static final float FRICTION = 0.2f;

  private static final float DISC_FRICTION = 0.4f;
  private static final float DISC_RESTITUTION = 0.1f;

  final World world;

  Stage(World world) {
    this.world = world;
  }

  /**
   * A stage with the box around it: that of the thesis, and a lid, as the tips of a beam that
   * breaks at 100 m/s fly higher than its walls.
   */
  static Stage inBox(World world) {
    Stage stage = new Stage(world);
    Body floor = stage.scenery(0f, -5f, 40f, 5f);
    stage.scenery(-41f, 30f, 2f, 40f);
    stage.scenery(41f, 30f, 2f, 40f);
    PolygonShape lid = new PolygonShape();
    lid.setAsBox(43f, 5f, floor.getLocalPoint(new Vec2(0f, Scenes.BOX_HEIGHT + 5f)), 0f);
    FixtureDef substance = substance(0f, FRICTION, null);
    substance.shape = lid;
    floor.createFixture(substance);
    return stage;
  }

  /** What a fixture without a special substance is made of: density 1 kg/m^2, no restitution. */
  static FixtureDef plain() {
    return substance(1f, FRICTION, null);
  }

  /** A plain substance that breaks. */
  static FixtureDef breakable(Material material) {
    return substance(1f, FRICTION, material);
  }

  /** A substance without restitution. */
  static FixtureDef substance(float density, float friction, Material material) {
    FixtureDef def = new FixtureDef();
    def.density = density;
    def.friction = friction;
    def.restitution = 0f;
    def.material = material;
    return def;
  }

  /** What the thesis' projectiles are made of. */
  static FixtureDef projectile(float density) {
    FixtureDef def = substance(density, DISC_FRICTION, null);
    def.restitution = DISC_RESTITUTION;
    return def;
  }

  /** Sets a material's values. */
  static <M extends Material> M tuned(M material, float rigidity) {
    material.m_rigidity = rigidity;
    return material;
  }

  /** Sets a material's values. */
  static <M extends Material> M tuned(M material, float rigidity, float shattering) {
    material.m_shattering = shattering;
    return tuned(material, rigidity);
  }

  /** Sets a material's values. */
  static <M extends Material> M tuned(M material, float rigidity, float shattering, float radius) {
    material.m_radius = radius;
    return tuned(material, rigidity, shattering);
  }

  /** A static box without mass. */
  Body scenery(float x, float y, float halfWidth, float halfHeight) {
    return box(BodyType.STATIC, x, y, halfWidth, halfHeight, substance(0f, FRICTION, null));
  }

  /** A dynamic box. */
  Body box(float x, float y, float halfWidth, float halfHeight, FixtureDef substance) {
    return box(BodyType.DYNAMIC, x, y, halfWidth, halfHeight, substance);
  }

  /** A box of any type. */
  Body box(
      BodyType type, float x, float y, float halfWidth, float halfHeight, FixtureDef substance) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight);
    Body body = body(type, x, y, 0f);
    substance.shape = shape;
    body.createFixture(substance);
    return body;
  }

  /** A dynamic disc. */
  Body disc(float x, float y, float radius, FixtureDef substance) {
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    Body body = body(BodyType.DYNAMIC, x, y, 0f);
    substance.shape = shape;
    body.createFixture(substance);
    return body;
  }

  /** A disc of the projectiles' substance that flies off. */
  Body shot(float x, float y, float radius, float density, float vx, float vy) {
    Body body = disc(x, y, radius, projectile(density));
    body.setLinearVelocity(new Vec2(vx, vy));
    return body;
  }

  /** A joint by which two bodies turn about a world point. */
  void hinge(Body a, Body b, float x, float y) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(x, y));
    world.createJoint(def);
  }

  /** A hinge that bends no further than the given angles, radians. */
  void hinge(Body a, Body b, float x, float y, float least, float most) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(x, y));
    def.enableLimit = true;
    def.lowerAngle = least;
    def.upperAngle = most;
    world.createJoint(def);
  }

  /** A dynamic box that is turned by an angle, radians. */
  Body tilted(
      float x, float y, float angle, float halfWidth, float halfHeight, FixtureDef substance) {
    Body body = box(x, y, halfWidth, halfHeight, substance);
    body.setTransform(new Vec2(x, y), angle);
    return body;
  }

  /** A static convex polygon without mass. */
  Body scenery(Vec2... outline) {
    PolygonShape shape = new PolygonShape();
    shape.set(outline, outline.length);
    Body body = body(BodyType.STATIC, 0f, 0f, 0f);
    FixtureDef substance = substance(0f, FRICTION, null);
    substance.shape = shape;
    body.createFixture(substance);
    return body;
  }

  /** A dynamic body of any outline. */
  Body whole(float x, float y, float angle, PolygonFixture outline, FixtureDef substance) {
    Body body = body(BodyType.DYNAMIC, x, y, angle);
    body.createFixture(substance, outline);
    return body;
  }

  /** A body without fixtures. */
  Body body(BodyType type, float x, float y, float angle) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    def.angle = angle;
    return world.createBody(def);
  }
}
