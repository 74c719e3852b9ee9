package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What bore a heavy body stays where it is when that is taken away. The impulses kept from the step
 * before, those of the load, threw a stack of five boxes up at 1.2 m/s, or 0.2 to 0.5 m/s where the
 * load had ten times a box's mass, and a pyramid at 0.6 to 1.1 m/s.
 */
class RemovedLoadTest {
  /** Speed of a fall by 3 mm, less than the slop, m/s: nobody sees a hop of that. */
  private static final float HARMLESS = 0.25f;

  private static final int SECOND = 60;

  @ParameterizedTest
  @CsvSource({"4, 10", "4, 50", "0, 10", "0, 50"})
  void aStackStays(int substeps, float load) {
    World world = world(substeps);
    Body[] boxes = new Body[5];
    for (int i = 0; i < boxes.length; i++) {
      boxes[i] = box(world, 0f, i + 0.5f, 1f);
    }
    assertTrue(fastestWithout(world, box(world, 0f, boxes.length + 0.5f, load), boxes) < HARMLESS);
  }

  @ParameterizedTest
  @CsvSource({"4, 30", "4, 50", "0, 30", "0, 50"})
  void aPyramidStays(int substeps, float load) {
    World world = world(substeps);
    int rows = 5;
    Body[] boxes = new Body[rows * (rows + 1) / 2];
    int n = 0;
    for (int row = 0; row < rows; row++) {
      for (int i = 0; i < rows - row; i++) {
        boxes[n++] = box(world, 1.05f * (i - 0.5f * (rows - row - 1)), row + 0.5f, 1f);
      }
    }
    assertTrue(fastestWithout(world, box(world, 0f, rows + 0.5f, load), boxes) < HARMLESS);
  }

  private static World world(int substeps) {
    World world = new World(new Vec2(0f, -10f));
    world.setSolver(substeps > 0 ? Solver.softStep(substeps) : Solver.adaptive());
    world.setAllowSleep(false);
    Body floor = Make.body(world, BodyType.STATIC, 0f, -0.5f);
    floor.createFixture(Make.boxShape(20f, 0.5f), 0f);
    return world;
  }

  private static Body box(World world, float x, float y, float density) {
    Body box = Make.body(world, BodyType.DYNAMIC, x, y);
    box.createFixture(Make.boxShape(0.5f, 0.5f), density).setFriction(0.6f);
    return box;
  }

  /** Lets all come to rest, takes the load off, and returns the largest speed after that. */
  private static float fastestWithout(World world, Body load, Body[] rest) {
    for (int i = 0; i < 4 * SECOND; i++) {
      world.step(1f / SECOND, 8, 3);
    }
    world.destroyBody(load);
    float fastest = 0f;
    for (int i = 0; i < SECOND; i++) {
      world.step(1f / SECOND, 8, 3);
      for (Body body : rest) {
        fastest = Math.max(fastest, body.getLinearVelocity().length());
      }
    }
    return fastest;
  }
}
