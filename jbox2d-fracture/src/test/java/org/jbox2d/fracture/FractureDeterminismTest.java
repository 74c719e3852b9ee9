package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Same world, same seed, same calls: the same pieces to the last bit, in each JIT mode. */
class FractureDeterminismTest {
  private static final int STEPS = 600;

  /** Few enough for the interpreter, and past the first fractures. */
  private static final int STEPS_INTERPRETED = 100;

  private static final int REPETITIONS = 100;
  private static final int STEPS_REPEATED = 20;

  /**
   * The hashes of the scenes after {@link #STEPS_INTERPRETED} steps, on every machine. A change of
   * the engine or of the geometry that is meant to change them puts the new ones here and says why
   * in CHANGELOG.md.
   */
  private static final long[] GOLDEN = {
    -1515804191137015499L, -4480715703711174286L, 275631487745057535L
  };

  @Test
  void goldenHashes() {
    assertArrayEquals(GOLDEN, all(STEPS_INTERPRETED));
  }

  private static long[] all(int steps) {
    long[] hashes = new long[FractureScenes.COUNT];
    for (int i = 0; i < hashes.length; i++) {
      hashes[i] = FractureScenes.run(i, steps);
    }
    return hashes;
  }

  @Test
  void scenesBreak() {
    for (int i = 0; i < FractureScenes.COUNT; i++) {
      World world = FractureScenes.make(i);
      Range.step(world, 60f, 2f);
      assertTrue(FractureSystem.of(world).getFractureCount() > 0, "scene " + i);
      assertEquals(0, FractureSystem.of(world).getFailureCount(), "scene " + i);
    }
  }

  @Test
  void onTwoThreadsAtOnce() throws InterruptedException, ExecutionException {
    ExecutorService threads = Executors.newFixedThreadPool(2);
    Future<long[]> first = threads.submit(() -> all(STEPS));
    Future<long[]> second = threads.submit(() -> all(STEPS));
    threads.shutdown();
    assertArrayEquals(first.get(), second.get());
  }

  /** While the JIT compiles ever more of it. */
  @Test
  void againAndAgain() {
    long hash = FractureScenes.run(1, STEPS_REPEATED);
    for (int i = 1; i < REPETITIONS; i++) {
      assertEquals(hash, FractureScenes.run(1, STEPS_REPEATED), "repetition " + i);
    }
  }

  @Test
  void anotherSeedGivesOtherPieces() {
    World world = FractureScenes.make(1);
    World other = FractureScenes.make(1);
    FractureSystem.of(other).setSeed(7);
    Range.step(world, 60f, 1f);
    Range.step(other, 60f, 1f);
    assertNotEquals(FractureScenes.hash(world), FractureScenes.hash(other));
  }

  @ParameterizedTest
  @ValueSource(strings = {"-Xint", "-XX:TieredStopAtLevel=1"})
  void inEachJitMode(String mode) throws IOException, InterruptedException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Process child =
        new ProcessBuilder(
                java,
                mode,
                "-cp",
                System.getProperty("java.class.path"),
                FractureScenes.class.getName(),
                String.valueOf(STEPS_INTERPRETED))
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    String printed =
        new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
    assertTrue(child.waitFor(60, TimeUnit.SECONDS));
    String here =
        Arrays.stream(all(STEPS_INTERPRETED))
            .mapToObj(String::valueOf)
            .collect(Collectors.joining(" "));
    assertEquals(here, printed);
  }

  private static World tumbling(Material material) {
    World world = new World(new Vec2(0f, -9.81f));
    Body floor = Range.body(world, BodyType.STATIC, 0f, -11f);
    Range.fixture(floor, Range.box(60f, 1f), 0f, null);
    for (int i = 0; i < 30; i++) {
      Body box = Range.body(world, BodyType.DYNAMIC, 1.3f * (i % 6), 1.4f * (i / 6));
      Range.fixture(box, Range.box(0.5f, 0.4f), 1f, material);
      box.setAngularVelocity(i % 5 - 2f);
    }
    Range.disc(world, -12f, 1.3f, 1f, 5f, 60f, 3f);
    return world;
  }

  /** What does not break moves as if there were no fracture, to the last bit. */
  @Test
  void worldWithoutFracturesIsUntouched() {
    World plain = tumbling(null);
    World watched = tumbling(null);
    FractureSystem.of(watched).setSeed(3);
    FractureSystem.of(watched).setListener((material, intensity, pieces) -> {});
    World hard = tumbling(Range.uniform(Float.POSITIVE_INFINITY, 1f));
    for (int i = 0; i < 300; i++) {
      Range.step(plain, 60f, 1f / 60f);
      Range.step(watched, 60f, 1f / 60f);
      Range.step(hard, 60f, 1f / 60f);
      assertEquals(FractureScenes.hash(plain), FractureScenes.hash(watched), "step " + i);
      assertEquals(FractureScenes.hash(plain), FractureScenes.hash(hard), "step " + i);
    }
    assertEquals(0, FractureSystem.of(hard).getFractureCount());
  }
}
