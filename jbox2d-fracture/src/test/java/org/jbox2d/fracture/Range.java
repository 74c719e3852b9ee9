package org.jbox2d.fracture;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Uniform;

/** A shooting range: bodies made in a line or two, for the tests. */
final class Range {
  private Range() {}

  static Uniform uniform(float rigidity, float shattering) {
    Uniform material = new Uniform();
    material.m_rigidity = rigidity;
    material.m_shattering = shattering;
    return material;
  }

  static Body body(World world, BodyType type, float x, float y) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    return world.createBody(def);
  }

  static Fixture fixture(Body body, Shape shape, float density, Material material) {
    FixtureDef def = new FixtureDef();
    def.shape = shape;
    def.density = density;
    def.material = material;
    return body.createFixture(def);
  }

  static PolygonShape box(float halfWidth, float halfHeight) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, halfHeight);
    return shape;
  }

  static Body wall(World world, BodyType type, float half, Material material) {
    Body wall = body(world, type, 0, 0);
    fixture(wall, box(half, half), 1f, material);
    return wall;
  }

  static Body disc(World world, float x, float y, float radius, float density, float vx, float vy) {
    Body disc = body(world, BodyType.DYNAMIC, x, y);
    CircleShape shape = new CircleShape();
    shape.m_radius = radius;
    fixture(disc, shape, density, null);
    disc.setLinearVelocity(new Vec2(vx, vy));
    return disc;
  }

  static void step(World world, float hz, float seconds) {
    int n = Math.round(hz * seconds);
    for (int i = 0; i < n; i++) {
      world.step(1f / hz, 8, 3);
    }
  }
}
