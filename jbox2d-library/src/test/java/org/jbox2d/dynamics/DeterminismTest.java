package org.jbox2d.dynamics;

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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Same build of the world, same calls, same bits: whatever else runs, in each JIT mode. */
class DeterminismTest {
  private static final int STEPS = 300;

  /** Few enough for the interpreter. */
  private static final int STEPS_INTERPRETED = 90;

  /**
   * The hashes of the scenes after {@link #STEPS_INTERPRETED} steps, on every machine. A change of
   * the engine that is meant to change them puts the new ones here and says why in CHANGELOG.md.
   */
  private static final long[] GOLDEN = {
    -2361422685989648118L, 1541369431208819054L, 3380111521622444704L, 5534556158638598677L
  };

  @Test
  void goldenHashes() {
    assertArrayEquals(GOLDEN, DeterminismScenes.hashes(STEPS_INTERPRETED, null));
  }

  @Test
  void againWithAnotherWorldBetween() {
    long[] first = DeterminismScenes.hashes(STEPS, null);
    long[] second = DeterminismScenes.hashes(STEPS, Make.debris(30, 1));
    assertArrayEquals(first, second);
    assertEquals(first.length, Arrays.stream(first).distinct().count());
    assertNotEquals(
        StateHash.of(Make.debris(20, 1)), StateHash.of(Make.debris(20, 2)), "the hash sees bits");
  }

  @Test
  void onTwoThreadsAtOnce() throws InterruptedException, ExecutionException {
    ExecutorService threads = Executors.newFixedThreadPool(2);
    Future<long[]> first = threads.submit(() -> DeterminismScenes.hashes(STEPS, null));
    Future<long[]> second = threads.submit(() -> DeterminismScenes.hashes(STEPS, null));
    threads.shutdown();
    assertArrayEquals(first.get(), second.get());
    assertArrayEquals(DeterminismScenes.hashes(STEPS, null), first.get());
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
                DeterminismScenes.class.getName(),
                String.valueOf(STEPS_INTERPRETED))
            .redirectErrorStream(true)
            .start();
    String printed =
        new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
    assertTrue(child.waitFor(60, TimeUnit.SECONDS));
    String here =
        Arrays.stream(DeterminismScenes.hashes(STEPS_INTERPRETED, null))
            .mapToObj(String::valueOf)
            .collect(Collectors.joining(" "));
    assertEquals(here, printed);
  }
}
