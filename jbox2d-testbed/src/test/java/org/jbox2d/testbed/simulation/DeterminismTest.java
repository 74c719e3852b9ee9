package org.jbox2d.testbed.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Same scene, same seed: same bits. */
class DeterminismTest {
  private static final float HZ = 60f;
  private static final int STEPS = 150;

  /** A fresh virtual machine that only interprets is some thirty times slower. */
  private static final int STEPS_INTERPRETED = 60;

  private static final long LIMIT_SECONDS = 240;

  static Stream<Scene> scenes() {
    return Scenes.all().stream();
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void isNotChangedByAnotherWorldBesideIt(Scene scene) {
    Simulation alone = new Simulation(scene, HZ, 7);
    for (int i = 0; i < STEPS; i++) {
      alone.step();
    }
    Simulation again = new Simulation(scene, HZ, 7);
    Simulation beside = new Simulation(Scenes.named("main"), HZ, 8);
    for (int i = 0; i < STEPS; i++) {
      beside.step();
      again.step();
    }
    assertEquals(alone.hash(), again.hash());
  }

  @Test
  void seedSteersTheFractures() {
    long first = hashAfter("main", STEPS_INTERPRETED, 1);
    assertNotEquals(first, hashAfter("main", STEPS_INTERPRETED, 2));
  }

  /** In one child, for the price of one start. */
  @Test
  void interpreterGivesTheSameBitsAsTheCompiler() throws Exception {
    List<String> names = List.of("main", "static-body", "material-glass", "debris-pile");
    StringBuilder expected = new StringBuilder();
    for (String name : names) {
      expected.append(hashAfter(name, STEPS_INTERPRETED, 1)).append('\n');
    }
    assertEquals(expected.toString(), runInterpreted(names));
  }

  private static long hashAfter(String scene, int steps, long seed) {
    Simulation run = new Simulation(Scenes.named(scene), HZ, seed);
    for (int i = 0; i < steps; i++) {
      run.step();
    }
    return run.hash();
  }

  private static String runInterpreted(List<String> names)
      throws IOException, InterruptedException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Process process =
        new ProcessBuilder(
                java,
                "-Xint",
                "-cp",
                System.getProperty("java.class.path"),
                DeterminismTest.class.getName(),
                String.join(",", names))
            .redirectErrorStream(true)
            .start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS), "the child does not end");
    return output.replace("\r\n", "\n");
  }

  /** Entry of the child: prints the hash of each scene named in the only argument. */
  public static void main(String[] args) {
    for (String name : args[0].split(",")) {
      System.out.println(hashAfter(name, STEPS_INTERPRETED, 1));
    }
  }
}
