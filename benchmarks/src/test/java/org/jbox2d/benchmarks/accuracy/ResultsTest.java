package org.jbox2d.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResultsTest {
  private static final Scene FALL = Suite.named("free_fall");

  private static Result result(Scene scene, Contender solver, int hz, double error, double cost) {
    return new Result(scene, solver, new Setting(1, hz), error, cost);
  }

  @Test
  void readsWhatItWrote(@TempDir Path directory) throws IOException {
    Results results = new Results();
    results.add(result(FALL, Contender.SEQUENTIAL, 60, 0.125, 0.5));
    results.add(result(Suite.named("fracture_mass"), Contender.SOFT, 240, 0.25, 2));
    Path file = directory.resolve(Results.FILE);
    results.write(file);
    List<Result> read = Results.read(file).rows();
    assertEquals(2, read.size());
    assertEquals(results.rows().get(0).cost(), read.get(0).cost());
    assertEquals(results.rows().get(0).error(), read.get(0).error());
    assertEquals(new Setting(1, 240), read.get(1).setting());
    assertEquals("fracture_mass", read.get(1).scene().name());
    assertTrue(read.get(1).failed());
    Files.writeString(file, "nonsense");
    assertThrows(IOException.class, () -> Results.read(file));
  }

  @Test
  void summaryTakesGeometricMeansAndLeavesFractureOut() {
    Results results = new Results();
    results.add(result(FALL, Contender.SEQUENTIAL, 60, 0.01, 1));
    results.add(result(Suite.named("spin"), Contender.SEQUENTIAL, 60, 0, 4));
    results.add(result(Suite.named("fracture_mass"), Contender.SEQUENTIAL, 60, 1, 100));
    Summary s = results.summaries().get(0);
    assertEquals(2, s.scenes());
    assertEquals(0, s.failed());
    assertEquals(Math.sqrt(0.01 * Scene.FLOOR), s.error(), 1e-12);
    assertEquals(2, s.cost(), 1e-12);
  }

  @Test
  void recommendsTheCheapestOfOursThatMeetsTheError() {
    Results results = new Results();
    results.add(result(FALL, Contender.SEQUENTIAL, 30, 0.02, 1));
    results.add(result(FALL, Contender.SEQUENTIAL, 60, 0.01, 2));
    results.add(result(FALL, Contender.SOFT, 60, 0.001, 3));
    results.add(result(FALL, Contender.GDX, 60, 0.001, 0.1));
    assertEquals(2, RecommendCommand.cheapest(results, FALL, 0.015).orElseThrow().cost());
    assertEquals(
        Contender.SOFT, RecommendCommand.cheapest(results, FALL, 0.001).orElseThrow().solver());
    assertFalse(RecommendCommand.cheapest(results, FALL, 1e-4).isPresent());
  }

  @Test
  void frontHasWhatNothingBeats() {
    Summary cheap = new Summary(Contender.GDX, Setting.STANDARD, 1, 0, 0.1, 1);
    Summary beaten = new Summary(Contender.JBOX2D, Setting.STANDARD, 1, 0, 0.2, 2);
    Summary exact = new Summary(Contender.SOFT, Setting.STANDARD, 1, 0, 0.01, 3);
    assertEquals(List.of(cheap, exact), AccuracyCharts.front(List.of(exact, beaten, cheap)));
  }

  @Test
  void drawsARun(@TempDir Path directory) throws IOException {
    Results results = new Results();
    for (int hz : new int[] {30, 60, 120, 240}) {
      for (String scene : List.of("free_fall", "rod_fall", "double_pendulum", "pendulum_period")) {
        for (Contender solver : Contender.values()) {
          results.add(result(Suite.named(scene), solver, hz, 1.0 / hz, hz * 0.01));
        }
      }
    }
    new AccuracyCharts(results, directory).draw();
    for (String name :
        List.of(
            "error-against-cost", "failures-against-cost", "failures", "convergence-rod_fall")) {
      assertTrue(Files.readString(directory.resolve(name + ".svg")).contains("<svg"), name);
    }
  }
}
