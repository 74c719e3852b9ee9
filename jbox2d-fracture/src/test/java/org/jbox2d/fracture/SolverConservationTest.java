package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Mass, momentum and energy over fractures with each solver, from 30 to 240 Hz: pairs and what
 * stands on the floor, one or both breakable, rigidities to 1:100, concave, compound.
 */
class SolverConservationTest {
  private static final float[] RATES = {30f, 60f, 120f, 240f};
  private static final float SECONDS = 0.4f;

  /** What hits what. */
  enum Case {
    BOX(world -> target(world, 20f, 2f)),
    BOTH_1_TO_1(world -> pair(world, 1f)),
    BOTH_1_TO_100(world -> pair(world, 100f)),
    BOTH_100_TO_1(world -> pair(world, 0.01f)),
    CONCAVE(Case::concave),
    COMPOUND(Case::compound),
    STATIC(Case::staticWall),
    ON_THE_FLOOR(Case::onTheFloor);

    private final Consumer<World> maker;

    Case(Consumer<World> maker) {
      this.maker = maker;
    }

    World make() {
      boolean falls = this == ON_THE_FLOOR;
      World world = new World(falls ? new Vec2(0f, -9.81f) : new Vec2());
      maker.accept(world);
      return world;
    }

    private static void shoot(World world, float y) {
      // At 30 Hz a body is no faster than 60 m/s.
      Range.disc(world, -9f, y, 0.5f, 8f, 55f, 2f);
    }

    private static void target(World world, float rigidity, float shattering) {
      Range.wall(world, BodyType.DYNAMIC, 3f, Range.uniform(rigidity, shattering));
      shoot(world, 0.7f);
    }

    private static void pair(World world, float ratio) {
      Range.wall(world, BodyType.DYNAMIC, 3f, Range.uniform(10f, 2f));
      Body other = Range.body(world, BodyType.DYNAMIC, -9f, 0.5f);
      Range.fixture(other, Range.box(1.5f, 1.5f), 2f, Range.uniform(10f * ratio, 1f));
      other.setLinearVelocity(new Vec2(45f, 0f));
      other.setAngularVelocity(0.7f);
    }

    private static void concave(World world) {
      FixtureDef def = new FixtureDef();
      def.density = 1f;
      def.material = Range.uniform(10f, 3f);
      Vec2[] u = {
        new Vec2(-5f, 5f), new Vec2(-4f, 5f), new Vec2(-4f, 0f), new Vec2(4f, 0f),
        new Vec2(4f, 5f), new Vec2(5f, 5f), new Vec2(5f, -5f), new Vec2(-5f, -5f)
      };
      Range.body(world, BodyType.DYNAMIC, 0f, 0f).createFixture(def, new PolygonFixture(u));
      shoot(world, 3f);
    }

    private static void compound(World world) {
      Body body = Range.wall(world, BodyType.DYNAMIC, 3f, Range.uniform(20f, 2f));
      Range.fixture(body, Range.box(5f, 0.4f), 1f, Range.uniform(5f, 1f));
      Range.fixture(body, Range.box(0.4f, 5f), 3f, null);
      shoot(world, 0.7f);
    }

    private static void staticWall(World world) {
      Body wall = Range.body(world, BodyType.STATIC, 0f, 0f);
      Range.fixture(wall, Range.box(1f, 5f), 1f, Range.uniform(20f, 2f));
      shoot(world, 0.7f);
    }

    private static void onTheFloor(World world) {
      Body floor = Range.body(world, BodyType.STATIC, 0f, -8f);
      Range.fixture(floor, Range.box(60f, 5f), 0f, null);
      Body weak = Range.body(world, BodyType.DYNAMIC, 8f, 0f);
      Range.fixture(weak, Range.box(2f, 3f), 1f, Range.uniform(5f, 2f));
      target(world, 40f, 2f);
    }
  }

  private static Solver[] solvers() {
    return new Solver[] {Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()};
  }

  @ParameterizedTest
  @EnumSource(Case.class)
  void keepsWhatItMust(Case scene) {
    for (Solver solver : solvers()) {
      for (float hz : RATES) {
        World world = scene.make();
        world.setSolver(solver);
        Conservation.assertConserves(world, hz, SECONDS, solver + " at " + hz + " Hz, ");
        boolean broke = FractureSystem.of(world).getFractureCount() > 0;
        assertTrue(broke, "nothing broke with " + solver + " at " + hz + " Hz");
      }
    }
  }
}
