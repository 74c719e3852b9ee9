package org.jbox2d.benchmarks.engines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.jbox2d.dynamics.Solver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ContenderTest {
  @Test
  void originalComesFromItsOwnLoader() throws ReflectiveOperationException {
    OriginalLoader loader = new OriginalLoader(ContenderTest.class.getClassLoader());
    Class<?> original = loader.loadClass("org.jbox2d.dynamics.World");
    assertNotSame(org.jbox2d.dynamics.World.class, original);
    // Only the original has this class.
    assertEquals(loader, loader.loadClass("org.jbox2d.dynamics.Island").getClassLoader());
  }

  @Test
  void theAdapterOfTheOriginalIsNotOurs() {
    try (Sim ours = Contender.SEQUENTIAL.open(Setting.STANDARD);
        Sim original = Contender.JBOX2D.open(Setting.STANDARD)) {
      assertNotSame(ours.getClass().getSuperclass(), original.getClass());
    }
  }

  @Test
  void unknownNamesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> Contender.of("no such engine"));
  }

  @ParameterizedTest
  @EnumSource(Contender.class)
  void aRayIsStoppedByTheNearestShape(Contender solver) {
    try (Sim sim = solver.open(Setting.STANDARD)) {
      sim.body(Kind.STATIC, 6, 0, 0).box(1, 1, Matter.smooth(1));
      sim.body(Kind.STATIC, 3, 0, 0).disc(1, Matter.smooth(1));
      sim.step(1.0 / 60);
      assertEquals(0.2, sim.ray(0, 0, 10, 0), 1e-6);
      assertEquals(1, sim.ray(0, 5, 10, 5));
      assertEquals(2, sim.bodies());
    }
  }

  @ParameterizedTest
  @EnumSource(Contender.class)
  void placeMoveAndRemove(Contender solver) {
    try (Sim sim = solver.open(Setting.STANDARD)) {
      SimBody ball = sim.body(Kind.DYNAMIC, 1, 2, 0.5).disc(1, Matter.smooth(1));
      assertEquals(0.5, ball.angle(), 1e-6);
      ball.place(3, 4).move(6, 0, 0);
      assertEquals(0, ball.angle(), 1e-6);
      sim.gravity(0, 0);
      sim.step(0.5);
      // Engines may cap the speed at 2 m a step, but not below.
      assertEquals(5, ball.x(), 1);
      assertEquals(4, ball.y(), 1e-6);
      sim.remove(ball);
      assertEquals(0, sim.bodies());
    }
  }

  @Test
  void eachLevelDoublesTheWork() {
    assertEquals(16, Setting.all().size());
    assertEquals(8, Setting.STANDARD.velocityIterations());
    assertEquals(3, Setting.STANDARD.positionIterations());
    assertEquals(4, Setting.STANDARD.substeps());
    assertEquals(32, new Setting(3, 60).velocityIterations());
    assertEquals(Solver.adaptive().getLeastSubsteps(), Setting.STANDARD.leastSubsteps());
    assertEquals(Solver.adaptive().getMostSubsteps(), Setting.STANDARD.mostSubsteps());
    assertEquals(Solver.softStep().getLeastSubsteps(), Setting.STANDARD.substeps());
  }
}
