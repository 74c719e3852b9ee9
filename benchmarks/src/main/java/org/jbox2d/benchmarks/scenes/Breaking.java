package org.jbox2d.benchmarks.scenes;

import org.jbox2d.benchmarks.engines.OurSim;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.materials.Uniform;

/** Blocks in rows fall on a floor and on each other, and break into some twenty pieces each. */
public final class Breaking extends SteppedScene {
  private static final int PIECES = 20;
  private static final int ROW = 25;
  private static final double SPACING = 3;

  /** A scene that ends with about so many bodies. */
  public Breaking(Sim sim, int bodies) {
    super(sim);
    int blocks = Math.max(1, bodies / PIECES);
    int row = Math.min(blocks, Math.max(ROW, (int) Math.sqrt(4.0 * blocks)));
    floor(sim, SPACING * row);
    World world = ((OurSim) sim).world();
    FractureSystem system = FractureSystem.of(world);
    system.setSeed(1);
    system.setFracturesPerStep(Integer.MAX_VALUE);
    system.setBodyLimit(Integer.MAX_VALUE);
    system.setMinimumArea(0.01f);
    Uniform stone = new Uniform();
    stone.m_rigidity = 10f;
    stone.m_shattering = 1.8f;
    stone.m_radius = 4f;
    stone.m_fragments = null;
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(1f, 1f);
    for (int i = 0; i < blocks; i++) {
      BodyDef def = new BodyDef();
      def.type = BodyType.DYNAMIC;
      def.position.set(
          (float) (SPACING * (i % row - 0.5 * (row - 1))), (float) (1.5 + 2.5 * (i / row)));
      Body body = world.createBody(def);
      FixtureDef fixture = new FixtureDef();
      fixture.shape = shape;
      fixture.density = 1f;
      fixture.friction = 0.6f;
      fixture.material = stone;
      body.createFixture(fixture);
      body.setLinearVelocity(new Vec2(0f, -10f));
    }
  }
}
