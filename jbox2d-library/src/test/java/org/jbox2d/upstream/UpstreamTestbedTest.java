package org.jbox2d.upstream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.jbox2d.testbed.framework.TestbedTest;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The test programs of JBox2D 2.2.1.1, as compiled for it, run on our classes: without an
 * exception, without NaN, and with the original's bodies, joints and fixtures.
 */
class UpstreamTestbedTest {
  private static final int STEPS = 600;
  private static final String PACKAGE = "org.jbox2d.testbed.tests.";

  /** Tests of hundreds of bodies, for which the original takes seconds: it runs but a few steps. */
  private static final Set<String> SLOW =
      Set.of(
          PACKAGE + "CircleStress",
          PACKAGE + "DominoTower",
          PACKAGE + "LiquidTest",
          PACKAGE + "PistonTest",
          PACKAGE + "Tumbler");

  private static final int STEPS_WHEN_SLOW = 30;

  /** The draw of Math.random in it decides which bodies meet, and the smaller one is destroyed. */
  private static final String RANDOM = PACKAGE + "CollisionProcessing";

  /**
   * It draws eight points with Math.random in each step, and clips them to a square: once in some
   * hundreds of runs all lie on one side. Of those the original makes a box, and we refuse them.
   */
  private static final String HULL = PACKAGE + "ConvexHull";

  @BeforeAll
  static void noDisplay() {
    System.setProperty("java.awt.headless", "true");
  }

  static List<String> tests() throws IOException, URISyntaxException {
    Path jar =
        Path.of(TestbedTest.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      return zip.stream()
          .map(ZipEntry::getName)
          .filter(name -> name.matches("org/jbox2d/testbed/tests/[^$]*\\.class"))
          .map(name -> name.substring(0, name.length() - ".class".length()).replace('/', '.'))
          .filter(UpstreamTestbedTest::isTest)
          .sorted()
          .collect(Collectors.toList());
    }
  }

  private static boolean isTest(String name) {
    try {
      Class<?> type = Class.forName(name, false, UpstreamTestbedTest.class.getClassLoader());
      return TestbedTest.class.isAssignableFrom(type) && !Modifier.isAbstract(type.getModifiers());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void allTestsAreFound() throws IOException, URISyntaxException {
    assertEquals(44, tests().size());
  }

  @ParameterizedTest
  @MethodSource("tests")
  void runsAndIsSavedAndLoaded(String name) {
    Map<String, Double> ours = run(Engine.OURS, name, STEPS, false);
    for (String what : List.of("bodies", "joints", "fixtures")) {
      // The serializer has no rope joints: it leaves them out, of the original's worlds as well.
      double left = name.equals(PACKAGE + "RopeTest") && what.equals("joints") ? 1 : 0;
      assertEquals(ours.get(what) - left, ours.get("loaded " + what), what + " after loading");
    }
    if (!name.equals(RANDOM)) {
      boolean slow = SLOW.contains(name);
      int steps = slow ? STEPS_WHEN_SLOW : STEPS;
      Map<String, Double> original = run(Engine.ORIGINAL, name, steps, false);
      assertSameCounts(original, slow ? run(Engine.OURS, name, steps, false) : ours);
    }
  }

  @ParameterizedTest
  @MethodSource("tests")
  void runsWithMouseKeysAndEverythingDrawn(String name) {
    Map<String, Double> ours = run(Engine.OURS, name, STEPS, true);
    assertTrue(ours.get("drawn") > 0);
    if (!name.equals(RANDOM)) {
      boolean slow = SLOW.contains(name);
      int steps = slow ? STEPS_WHEN_SLOW : STEPS;
      Map<String, Double> original = run(Engine.ORIGINAL, name, steps, true);
      assertSameCounts(original, slow ? run(Engine.OURS, name, steps, true) : ours);
    }
  }

  /** Scenes that come to rest do so at the same place, and sleep. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "ConfinedTest",
        "ConveyorBelt",
        "OneSidedTest",
        "PyramidTest",
        "ShapeEditing",
        "SphereStack",
        "VerticalStack"
      })
  void settlesWhereTheOriginalDoes(String name) {
    Map<String, Double> ours = run(Engine.OURS, PACKAGE + name, STEPS, false);
    Map<String, Double> original = run(Engine.ORIGINAL, PACKAGE + name, STEPS, false);
    assertEquals(0, ours.get("awake"), "awake");
    assertEquals(original.get("awake"), ours.get("awake"), "awake");
    // The belt's friction is solved in another order, and what it throws off lands 1 % further.
    double tolerance = name.equals("ConveyorBelt") ? 0.1 : 0.01;
    assertEquals(original.get("x"), ours.get("x"), tolerance);
    assertEquals(original.get("y"), ours.get("y"), tolerance);
  }

  private static void assertSameCounts(Map<String, Double> expected, Map<String, Double> actual) {
    for (String what : List.of("bodies", "joints", "fixtures")) {
      assertEquals(expected.get(what), actual.get(what), what);
    }
  }

  private static Map<String, Double> run(Engine engine, String name, int steps, boolean input) {
    try {
      return runOnce(engine, name, steps, input);
    } catch (AssertionError e) {
      if (name.equals(HULL) && isOnALine(e.getCause())) {
        return runOnce(engine, name, steps, input);
      }
      throw e;
    }
  }

  private static boolean isOnALine(Throwable cause) {
    return cause instanceof IllegalArgumentException && cause.getMessage().contains("collinear");
  }

  @SuppressWarnings("unchecked")
  private static Map<String, Double> runOnce(Engine engine, String name, int steps, boolean input) {
    return (Map<String, Double>) engine.call(TestbedRun.class, "run", name, steps, input);
  }
}
