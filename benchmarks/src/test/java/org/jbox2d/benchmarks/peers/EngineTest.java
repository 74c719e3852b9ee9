package org.jbox2d.benchmarks.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.jbox2d.benchmarks.SceneSpec;
import org.jbox2d.benchmarks.SteppedScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class EngineTest {
  @Test
  void originalComesFromItsOwnLoader() throws ReflectiveOperationException {
    OriginalLoader loader = new OriginalLoader(EngineTest.class.getClassLoader());
    Class<?> original = loader.loadClass("org.jbox2d.dynamics.World");
    assertNotSame(org.jbox2d.dynamics.World.class, original);
    // Only the original has this class.
    assertEquals(loader, loader.loadClass("org.jbox2d.dynamics.Island").getClassLoader());
  }

  @ParameterizedTest
  @EnumSource(
      value = SceneSpec.class,
      names = {"DEBRIS", "TUMBLER", "CREATE_DESTROY"})
  void bothEnginesBuildTheSameScene(SceneSpec spec) {
    SteppedScene ours = Engine.OURS.build(spec.label);
    SteppedScene original = Engine.JBOX2D.build(spec.label);
    assertEquals(original.bodyCount(), ours.bodyCount());
    ours.step();
    original.step();
    assertEquals(original.bodyCount(), ours.bodyCount());
    if (spec.bodiesAlone) {
      assertEquals(ours.bodyCount(), Engine.DYN4J.build(spec.label).bodyCount());
    }
  }

  @Test
  void unknownNamesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> SceneSpec.of("no such scene"));
    assertThrows(IllegalArgumentException.class, () -> Engine.of("no such engine"));
    assertThrows(IllegalArgumentException.class, () -> Engine.OURS.build("no such scene"));
  }
}
