package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What breaks, and into what, does not depend on the length of the step, nor on the solver. */
class FrameRateTest {
  private static final float[] RATES = {30f, 60f, 120f, 240f};

  private static final Solver[] SOLVERS = {
    Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()
  };

  /** Bound on the spread of the speed at which a bullet just breaks a wall, relative. */
  private static final double SPREAD = 0.05;

  /** Halvings of the interval in which that speed is looked for: to 1/500 of it. */
  private static final int HALVINGS = 9;

  private static Material material(String name) {
    Material m =
        name.equals("uniform")
            ? new Uniform()
            : name.equals("glass") ? new Glass() : new Diffusion();
    m.m_rigidity = 10f;
    m.m_shattering = name.equals("uniform") ? 3f : 1f;
    m.m_radius = 1f;
    m.m_fragments = null;
    return m;
  }

  /** At 55 m/s the region reaches 1.83 m ahead, more than its radius. */
  @ParameterizedTest
  @ValueSource(strings = {"uniform", "diffusion", "glass"})
  void sameBlowSamePieces(String name) {
    int expected = 0;
    for (float hz : RATES) {
      World world = new World(new Vec2());
      Body wall = Range.body(world, BodyType.STATIC, 0f, 0f);
      Range.fixture(wall, Range.box(5f, 10f), 1f, material(name));
      Range.disc(world, -9f, 0.37f, 0.5f, 5f, 55f, 0f).setBullet(true);
      int[] first = {0};
      FractureSystem.of(world)
          .setListener((m, i, pieces) -> first[0] = first[0] == 0 ? pieces.size() : first[0]);
      Range.step(world, hz, 0.5f);
      expected = expected == 0 ? first[0] : expected;
      assertTrue(first[0] > 3, first[0] + " pieces");
      assertEquals(expected, first[0], "pieces at " + hz + " Hz");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "STATIC, 0, 0, 0",
    "DYNAMIC, 0, 0, 0",
    "STATIC, 0.3, 0, 0.5",
    "DYNAMIC, -20, 0, 0.5",
    "DYNAMIC, 0, 30, 0",
    "STATIC, -30, 0, 0"
  })
  void thresholdSpeed(BodyType type, float gravityX, float gravityY, float restitution) {
    double low = Double.POSITIVE_INFINITY;
    double high = 0;
    for (Solver solver : SOLVERS) {
      for (float hz : RATES) {
        Case c = new Case(type, new Vec2(gravityX, gravityY), restitution, solver, hz);
        double speed = threshold(c);
        low = Math.min(low, speed);
        high = Math.max(high, speed);
      }
    }
    assertTrue(high < (1 + SPREAD) * low, "from " + low + " to " + high + " m/s");
  }

  private record Case(BodyType type, Vec2 gravity, float restitution, Solver solver, float hz) {}

  private static double threshold(Case c) {
    double holds = 0;
    double breaks = 55;
    for (int i = 0; i < HALVINGS; i++) {
      double speed = 0.5 * (holds + breaks);
      if (breaksAt(speed, c)) {
        breaks = speed;
      } else {
        holds = speed;
      }
    }
    assertTrue(breaks < 55, "never broke: " + c);
    return breaks;
  }

  /** Whether a bullet that arrives with the given speed breaks a wall 2 m away. */
  private static boolean breaksAt(double speed, Case c) {
    World world = new World(c.gravity);
    world.setSolver(c.solver);
    Body wall = Range.body(world, c.type, 0f, 0f);
    wall.setGravityScale(0f);
    Range.fixture(wall, Range.box(1f, 4f), 1f, Range.uniform(20f, 1f));
    double way = 2;
    double square = speed * speed - 2 * c.gravity.x * way;
    if (square <= 0) {
      return false;
    }
    float start = (float) (-1 - 0.3 - way);
    Body bullet = Range.disc(world, start, 0.1f, 0.3f, 5f, (float) Math.sqrt(square), 0f);
    bullet.setBullet(true);
    bullet.getFixtureList().setRestitution(c.restitution);
    FractureSystem system = FractureSystem.of(world);
    for (int i = 0; i < 0.8f * c.hz && system.getFractureCount() == 0; i++) {
      world.step(1f / c.hz, 8, 3);
    }
    return system.getFractureCount() > 0;
  }
}
