package org.jbox2d.benchmarks.charts;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;

/**
 * Breaks one box in a JVM of its own and prints the milliseconds of thread time that it took. The
 * world has made a step before, as a game's has.
 */
public final class FirstFracture {
  private FirstFracture() {}

  /** Breaks it: the first argument is the material, the second whether to warm up. */
  public static void main(String[] args) {
    if (args[1].equals("warmed-up")) {
      FractureSystem.warmUp();
    }
    World world = new World(new Vec2(0f, -9.81f));
    Body box = body(world, 0f);
    FixtureDef def = new FixtureDef();
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(5f, 5f);
    def.shape = shape;
    def.density = 1f;
    def.material = tuned(args[0].equals("glass") ? new Glass() : new Uniform());
    box.createFixture(def);
    FractureSystem system = FractureSystem.of(world);
    world.step(1f / 60f, 8, 3);
    FractureTimes.now();
    long start = FractureTimes.now();
    system.strike(box.getFixtureList(), new Vec2(-5f, 0.3f), new Vec2(1500f, 0f));
    double millis = 1e-6 * (FractureTimes.now() - start);
    if (system.getFractureCount() != 1) {
      throw new IllegalStateException("the box held");
    }
    System.out.println(millis);
  }

  private static Material tuned(Material material) {
    material.m_rigidity = 40f;
    material.m_radius = 2f;
    return material;
  }

  private static Body body(World world, float x) {
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.position.set(x, 0f);
    return world.createBody(def);
  }
}
