package org.jbox2d.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class SuiteTest {
  /** What is above its limit at 60 Hz and 8/3 or 4 substeps; docs/accuracy.md says why. */
  private static final Map<Contender, Set<String>> FAILS =
      Map.of(
          Contender.SEQUENTIAL,
          Set.of(
              "fast_flight",
              "fast_spin",
              "cradle_touching",
              "cradle_hung",
              "billiard_break",
              "rod_fall",
              "chain_load_100",
              "chain_load_1000",
              "wrecking_ball",
              "mass_ratio_1000",
              "heavy_on_tower",
              "column",
              "clump"),
          Contender.SOFT,
          Set.of(),
          Contender.ADAPTIVE,
          Set.of());

  static Stream<Arguments> held() {
    List<Scene> scenes = new ArrayList<>(Suite.common());
    scenes.addAll(Suite.fracture());
    return FAILS.keySet().stream()
        .sorted()
        .flatMap(
            solver ->
                scenes.stream()
                    .filter(scene -> !FAILS.get(solver).contains(scene.name()))
                    .map(scene -> Arguments.of(scene.name(), solver)));
  }

  @ParameterizedTest
  @MethodSource("held")
  void staysWithinTheLimit(String name, Contender solver) {
    Scene scene = Suite.named(name);
    double error = Meter.error(scene, solver, Setting.STANDARD);
    assertTrue(error <= scene.limit(), () -> error + " is above the limit: " + scene.reason());
  }

  @Test
  void scenesAreManyAndHaveNamesAndReasons() {
    List<Scene> scenes = Suite.common();
    scenes.addAll(Suite.fracture());
    Set<String> names = new HashSet<>();
    for (Scene scene : scenes) {
      assertTrue(names.add(scene.name()), scene.name());
      assertTrue(scene.reason().length() > 20, scene.name());
      assertTrue(scene.limit() > Scene.FLOOR && scene.limit() < 1, scene.name());
      // A whole number of steps at each rate.
      assertEquals(scene.seconds() * 30, Math.rint(scene.seconds() * 30), 1e-9, scene.name());
    }
    assertTrue(scenes.size() >= 98);
    assertThrows(IllegalArgumentException.class, () -> Suite.named("no such scene"));
  }

  /** Each adapter's world does what its scene asks for: joints, forces, impulses, sleep. */
  @ParameterizedTest
  @EnumSource(Contender.class)
  void everyEngineRunsWhatAllCanDo(Contender solver) {
    List<String> easy =
        List.of(
            "free_fall",
            "elastic_pair",
            "seams_chain",
            "motor",
            "spring_sag",
            "rail",
            "rope",
            "pulley",
            "seesaw",
            "cantilever",
            "lever_rule",
            "arch_stands",
            "sleep",
            "bowling",
            "support_removed");
    for (String name : easy) {
      Scene scene = Suite.named(name);
      double error = Meter.error(scene, solver, Setting.STANDARD);
      assertTrue(error <= scene.limit(), () -> name + ": " + error);
    }
  }

  @Test
  void sameSceneGivesTheSameErrorTwice() {
    Scene scene = Suite.named("pyramid");
    double first = Meter.error(scene, Contender.SEQUENTIAL, Setting.STANDARD);
    assertEquals(first, Meter.error(scene, Contender.SEQUENTIAL, Setting.STANDARD));
  }
}
