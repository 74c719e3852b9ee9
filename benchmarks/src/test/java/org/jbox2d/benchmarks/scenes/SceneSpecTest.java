package org.jbox2d.benchmarks.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.benchmarks.engines.Contender;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SceneSpecTest {
  @ParameterizedTest
  @EnumSource(
      value = SceneSpec.class,
      names = {"DEBRIS", "TUMBLER", "CREATE_DESTROY", "BULLET_HAIL", "RAIN"})
  void everyEngineBuildsTheSameScene(SceneSpec spec) {
    try (SteppedScene original = spec.build(Contender.JBOX2D)) {
      int built = original.bodyCount();
      original.step();
      for (Contender solver : Contender.values()) {
        try (SteppedScene scene = spec.build(solver)) {
          assertEquals(built, scene.bodyCount(), solver.label);
          scene.step();
          assertEquals(original.bodyCount(), scene.bodyCount(), solver.label);
        }
      }
    }
  }

  @Test
  void raysMeetTheSamePile() {
    try (Rays rays = (Rays) SceneSpec.RAYCAST.build(Contender.SEQUENTIAL)) {
      rays.step();
      // Most of the rays end in the pile, none at its very start.
      assertTrue(rays.free() > 0.01 && rays.free() < 0.9, () -> "" + rays.free());
    }
  }

  @Test
  void unknownNamesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> SceneSpec.of("no such scene"));
  }
}
