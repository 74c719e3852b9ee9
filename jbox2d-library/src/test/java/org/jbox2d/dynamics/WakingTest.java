package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A stack asleep of which the top alone is woken. The others wake while islands are built; their
 * sets were made anew after each, so that each contact was solved as an island of its own, lost the
 * load that it bore, and the stack sank by 9 mm at 0.27 m/s.
 */
class WakingTest {
  static Stream<Solver> solvers() {
    return Stream.of(Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive());
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void aWokenStackStaysWhereItIs(Solver solver) {
    World world = new World(new Vec2(0f, -10f));
    world.setSolver(solver);
    Make.ground(world);
    Body[] boxes = new Body[6];
    for (int i = 0; i < boxes.length; i++) {
      boxes[i] = Make.box(world, BodyType.DYNAMIC, 0f, 1.01f + 2f * i, 1f, 1f);
    }
    Make.steps(world, 240);
    Body top = boxes[5];
    assertFalse(boxes[0].isAwake());
    assertFalse(top.isAwake());
    float height = top.getPosition().y;
    top.setAwake(true);
    for (int i = 0; i < 20; i++) {
      Make.steps(world, 1);
      assertTrue(boxes[0].isAwake());
      assertEquals(0f, top.getLinearVelocity().length(), 0.01f);
      assertEquals(height, top.getPosition().y, 0.004f);
    }
  }
}
