package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import java.util.stream.Stream;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A splinter of two parts flies at a wall, at 30 Hz: the corner that both parts share meets it, and
 * the splinter turns about that in what is left of the step. Its centre, which lies in the one part
 * while it is the other that has met the wall, does not get into it.
 */
class CentreGuardTest {
  private static final int SEEDS = 400;
  private static final float STEP = 1f / 30f;

  /** The parts; their corners, in m from the centre: x, y, x, y... The wall is on the right. */
  private static final float[][] PARTS = {
    {-0.14f, 0.42f, 0.01f, -0.4f, 0.087f, -0.635f, 0.112f, -0.65f, 0.112f, -0.35f, -0.04f, 0.54f},
    {-0.04f, 0.54f, 0.112f, -0.35f, -0.04f, 0.65f},
  };

  /** Overlap that is accepted, m. */
  private static final float TOUCHING = 0.02f;

  static Stream<Solver> solvers() {
    return Stream.of(Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive());
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void noCentreGetsIntoAWall(Solver solver) {
    int inside = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      inside += getsInto(solver, new Random(seed)) ? 1 : 0;
    }
    assertEquals(0, inside);
  }

  private static boolean getsInto(Solver solver, Random random) {
    World world = Make.weightless();
    world.setSolver(solver);
    Make.box(world, BodyType.STATIC, 1f, 0f, 1f, 20f);
    Body splinter = Make.body(world, BodyType.DYNAMIC, -0.15f - 0.1f * random.nextFloat(), 0f);
    for (float[] part : PARTS) {
      Vec2[] corners = new Vec2[part.length / 2];
      for (int i = 0; i < corners.length; i++) {
        corners[i] = new Vec2(part[2 * i], part[2 * i + 1]);
      }
      PolygonShape shape = new PolygonShape();
      shape.set(corners, corners.length);
      splinter.createFixture(shape, 1f);
    }
    splinter.setTransform(splinter.getPosition(), 0.3f * (random.nextFloat() - 0.5f));
    splinter.setLinearVelocity(new Vec2(6f + 20f * random.nextFloat(), 4f));
    splinter.setAngularVelocity(10f * (random.nextFloat() - 0.5f));
    for (int i = 0; i < 20; i++) {
      world.step(STEP, 8, 3);
      if (splinter.getWorldCenter().x > TOUCHING) {
        return true;
      }
    }
    return false;
  }
}
