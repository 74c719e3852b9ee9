package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A fracture keeps mass, momentum and angular momentum, and never gains kinetic energy. */
class ConservationTest {
  private static Material material(String name, float rigidity) {
    Material m =
        name.equals("uniform")
            ? new Uniform()
            : name.equals("glass") ? new Glass() : new Diffusion();
    m.m_rigidity = rigidity;
    m.m_shattering = name.equals("uniform") ? 3f : 0.7f;
    return m;
  }

  @ParameterizedTest
  @CsvSource({
    "uniform, 40, 100, 60",
    "uniform, 1, 30, 60",
    "uniform, 100, 100, 240",
    "glass, 20, 100, 60",
    "glass, 5, 40, 30",
    "diffusion, 20, 100, 60",
    "diffusion, 8, 20, 120"
  })
  void bulletAndFreeBox(String name, float rigidity, float speed, float hz) {
    World world = new World(new Vec2());
    Range.wall(world, BodyType.DYNAMIC, 5f, material(name, rigidity));
    Range.disc(world, -12f, 1.3f, 1f, 5f, speed, 3f);
    Conservation.assertConserves(world, hz, 1f);
    assertTrue(FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
    assertTrue(world.getBodyCount() > 10, "only " + world.getBodyCount() + " bodies");
  }

  @Test
  void bothBodiesBreakable() {
    for (float ratio : new float[] {1f, 3f, 100f}) {
      World world = new World(new Vec2());
      Range.wall(world, BodyType.DYNAMIC, 3f, Range.uniform(10f, 2f));
      Body other = Range.body(world, BodyType.DYNAMIC, -9f, 0.5f);
      Range.fixture(other, Range.box(1.5f, 1.5f), 2f, Range.uniform(10f * ratio, 1f));
      other.setLinearVelocity(new Vec2(25f, 0f));
      other.setAngularVelocity(0.7f);
      Conservation.assertConserves(world, 60f, 1.5f);
      assertTrue(FractureSystem.of(world).getFractureCount() >= 1);
    }
  }

  @Test
  void spinningDiscBreaks() {
    World world = new World(new Vec2());
    Body disc = Range.body(world, BodyType.DYNAMIC, 0, 0);
    CircleShape shape = new CircleShape();
    shape.m_radius = 2.5f;
    Range.fixture(disc, shape, 1f, Range.uniform(8f, 3f));
    disc.setAngularVelocity(4f);
    Range.disc(world, -9f, 0.4f, 0.5f, 5f, 60f, 0f);
    Conservation.assertConserves(world, 60f, 1f);
    assertTrue(FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
  }

  @Test
  void concaveBodyBreaks() {
    World world = new World(new Vec2());
    Body body = Range.body(world, BodyType.DYNAMIC, 0, 0);
    FixtureDef def = new FixtureDef();
    def.density = 1f;
    def.material = Range.uniform(10f, 3f);
    Vec2[] u = {
      new Vec2(-5, 5), new Vec2(-4, 5), new Vec2(-4, 0), new Vec2(4, 0),
      new Vec2(4, 5), new Vec2(5, 5), new Vec2(5, -5), new Vec2(-5, -5)
    };
    body.createFixture(def, new PolygonFixture(u));
    Range.disc(world, -12f, 3f, 0.5f, 10f, 80f, 0f);
    Conservation.assertConserves(world, 60f, 1f);
    assertTrue(FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
  }

  /**
   * The floor takes momentum, in a fracture too if it is one of the two bodies of a blow; mass and
   * energy are kept.
   */
  @Test
  void boxOnTheFloor() {
    World world = new World(new Vec2(0, -9.81f));
    Body floor = Range.body(world, BodyType.STATIC, 0, -10f);
    Range.fixture(floor, Range.box(60f, 5f), 0f, null);
    Range.wall(world, BodyType.DYNAMIC, 5f, Range.uniform(40f, 3f));
    Range.disc(world, -20f, 0.3f, 1f, 5f, 100f, 0f);
    Conservation.assertConserves(world, 60f, 5f);
    assertTrue(FractureSystem.of(world).getFractureCount() > 0, "nothing broke");
  }

  @Test
  void splintersDoNotOverlapWhenBorn() {
    World world = new World(new Vec2());
    Range.wall(world, BodyType.DYNAMIC, 5f, Range.uniform(40f, 3f));
    Range.disc(world, -12f, 1.3f, 1f, 5f, 100f, 3f);
    double[] deepest = {0};
    FractureSystem.of(world)
        .setListener(
            (m, intensity, pieces) -> deepest[0] = Math.max(deepest[0], Overlap.deepest(pieces)));
    Range.step(world, 60f, 1f);
    // Each piece merges vertices nearer than half a slop on its own, so a corner may stick out by
    // less than that; the skins of two
    // pieces together are a slop, and a slop is what a resting contact keeps.
    assertTrue(deepest[0] < 0.6 * Settings.linearSlop, "cores overlap by " + deepest[0] + " m");
    assertTrue(FractureSystem.of(world).getFractureCount() > 0);
  }

  @Test
  void listenerHearsOfEveryPiece() {
    World world = new World(new Vec2());
    Body box = Range.wall(world, BodyType.DYNAMIC, 5f, Range.uniform(40f, 3f));
    Range.disc(world, -12f, 0f, 1f, 5f, 100f, 0f);
    float mass = box.getMass();
    boolean[] heard = {false};
    FractureSystem.of(world)
        .setListener(
            (material, intensity, pieces) -> {
              if (!heard[0]) {
                heard[0] = true;
                assertTrue(intensity > material.m_rigidity);
                assertEquals(mass, massOf(pieces), 1e-4 * mass);
              }
            });
    Range.step(world, 60f, 0.5f);
    assertTrue(heard[0]);
  }

  private static double massOf(List<Body> bodies) {
    double sum = 0;
    for (Body b : bodies) {
      sum += b.getMass();
    }
    return sum;
  }
}
