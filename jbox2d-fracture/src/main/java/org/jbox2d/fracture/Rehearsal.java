package org.jbox2d.fracture;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;

/** Discs that break boxes where nobody sees it. */
final class Rehearsal {
  /** Enough for the methods that take the time to be compiled. */
  private static final int ROUNDS = 30;

  private static final int STEPS = 4;
  private static final float DT = 1f / 60f;

  void run() {
    for (int i = 0; i < ROUNDS; i++) {
      play(i % 2 == 0 ? new Uniform() : new Glass(), i);
    }
  }

  private void play(Material material, long seed) {
    material.m_rigidity = 1f;
    material.m_shattering = 0.5f;
    World world = new World(new Vec2(0f, -9.81f));
    FractureSystem.of(world).setSeed(seed);
    PolygonShape box = new PolygonShape();
    box.setAsBox(2f, 2f);
    body(world, 0f, box, material);
    CircleShape disc = new CircleShape();
    disc.m_radius = 0.5f;
    body(world, -2.6f, disc, null).setLinearVelocity(new Vec2(40f, 0f));
    for (int i = 0; i < STEPS; i++) {
      world.step(DT, 8, 3);
    }
  }

  private static Body body(World world, float x, Shape shape, Material material) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, 0f);
    Body body = world.createBody(def);
    FixtureDef fixture = new FixtureDef();
    fixture.shape = shape;
    fixture.density = 1f;
    fixture.material = material;
    body.createFixture(fixture);
    return body;
  }
}
