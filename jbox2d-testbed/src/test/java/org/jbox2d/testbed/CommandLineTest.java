package org.jbox2d.testbed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

class CommandLineTest {
  @TempDir Path directory;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    CommandLine line = TestbedCommand.commandLine();
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(args);
  }

  @Test
  void listNamesEachSceneAndWhatItShows() {
    assertEquals(0, run("--list"));
    List<String> lines = out.toString().lines().toList();
    assertEquals(Scenes.all().size(), lines.size());
    for (int i = 0; i < lines.size(); i++) {
      Scene scene = Scenes.all().get(i);
      assertTrue(lines.get(i).startsWith(scene.name() + " "), lines.get(i));
      assertTrue(lines.get(i).endsWith(scene.shows()), lines.get(i));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--headless --scene nowhere | unknown scene 'nowhere'",
        "--headless --steps -1 | --steps must be 0 to 100000000, is -1",
        "--headless --steps many | 'many' is not an int",
        "--headless --hz 0 | --hz must be a positive number such as 60, is 0",
        "--headless --hz NaN | --hz must be a positive number such as 60, is NaN",
        "--headless --png no-such-directory/a.png | --png must be in a directory that exists",
        "--headless --fast | Unknown option: '--fast'",
        "--headless --set rigidity | --set must be NAME=VALUE such as rigidity=20, is rigidity",
        "--headless --set hardness=1 | unknown parameter 'hardness'; main has: speed, density,",
        "--headless --set rigidity=-1 | rigidity must be 0 to 500 N s, is -1",
        "--headless --set rigidity=NaN | rigidity must be 0 to 500 N s, is NaN",
        "--headless --set rigidity=soft | rigidity must be 0 to 500 N s, is 'soft'",
        "--headless --set body-limit=2.5 | body-limit must be a whole number from 0 to 20000",
        "--headless --set sleeping=no | sleeping must be one of off, on, is 'no'",
        "--headless --solver best | solver must be one of sequential-impulses, soft-step, adaptive, is",
        "--replay nowhere.rec | --replay must be a file that --record has written",
        "--replay nowhere.rec --scene main | leave --scene, --hz, --seed, --solver and --steps out",
        "--replay nowhere.rec --set rigidity=1 | leave --set out",
      })
  void mistakesGiveOneLineAndCode2(String args, String message) {
    assertEquals(2, run(args.split(" ")));
    assertEquals("", out.toString());
    List<String> lines = err.toString().lines().toList();
    assertEquals(1, lines.size(), err.toString());
    assertTrue(lines.get(0).contains(message), lines.get(0));
  }

  @Test
  void csvHasALineForEachStep() throws Exception {
    Path csv = directory.resolve("out.csv");
    assertEquals(
        0, run("--scene", "dominoes", "--steps", "20", "--hz", "50", "--csv", csv.toString()));
    List<String> lines = Files.readAllLines(csv);
    assertEquals(21, lines.size());
    assertEquals(
        "step,time,bodies,fixtures,contacts,fractures,mass,momentumX,momentumY,angularMomentum,"
            + "kineticEnergy,potentialEnergy,stepMillis",
        lines.get(0));
    String[] last = lines.get(20).split(",");
    assertEquals(13, last.length);
    assertEquals(20, Integer.parseInt(last[0]));
    assertEquals(0.4, Double.parseDouble(last[1]), 1e-9);
    for (String value : last) {
      assertTrue(Double.isFinite(Double.parseDouble(value)), value);
    }
  }

  @Test
  void pictureShowsTheScene() throws Exception {
    Path png = directory.resolve("out.png");
    assertEquals(0, run("--scene", "pyramid", "--steps", "5", "--png", png.toString()));
    assertTrue(out.toString().contains("picture written to " + png), out.toString());
    BufferedImage image = ImageIO.read(png.toFile());
    assertEquals(1280, image.getWidth());
    Set<Integer> colours = new HashSet<>();
    for (int x = 0; x < image.getWidth(); x++) {
      colours.add(image.getRGB(x, image.getHeight() / 2));
    }
    assertTrue(colours.size() > 10, "colours in the middle row: " + colours.size());
  }

  @Test
  void animationHasFramesAt25PerSecond() throws Exception {
    Path gif = directory.resolve("out.gif");
    Files.write(gif, new byte[100_000]);
    assertEquals(
        0, run("--scene", "dominoes", "--steps", "10", "--hz", "50", "--gif", gif.toString()));
    try (ImageInputStream in = ImageIO.createImageInputStream(gif.toFile())) {
      ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
      reader.setInput(in);
      assertEquals(5, reader.getNumImages(true));
      assertEquals(640, reader.read(0).getWidth());
      assertNotNull(reader.getImageMetadata(4));
      reader.dispose();
    }
  }

  @Test
  void hashIsTheSameEachTimeAndDependsOnTheScene() {
    assertEquals(0, run("--scene", "dominoes", "--steps", "30", "--hash"));
    String first = out.toString();
    assertTrue(first.matches("[0-9a-f]{16}\\R"), first);
    out.getBuffer().setLength(0);
    assertEquals(0, run("--scene", "dominoes", "--steps", "30", "--hash"));
    assertEquals(first, out.toString());
    out.getBuffer().setLength(0);
    assertEquals(0, run("--scene", "dominoes", "--steps", "31", "--hash"));
    assertFalse(first.equals(out.toString()));
  }

  @Test
  void summaryTellsBodiesMassAndHash() {
    assertEquals(0, run("--headless", "--scene", "main", "--steps", "1", "--profile"));
    String summary = out.toString();
    assertTrue(summary.startsWith("main: 1 steps at 50.0 Hz, seed 1: 5 bodies"), summary);
    assertTrue(summary.contains("breakable mass 100.000 kg -> 100.000 kg"), summary);
    assertTrue(summary.contains("solveVelocity"), summary);
  }

  private String hashOf(String... args) {
    out.getBuffer().setLength(0);
    assertEquals(0, run(args));
    return out.toString();
  }

  @Test
  void parametersChangeTheRun() {
    String plain = hashOf("--steps", "60", "--hash");
    assertEquals(plain, hashOf("--steps", "60", "--hash", "--set", "rigidity=40"));
    for (String setting :
        List.of(
            "rigidity=20",
            "material=glass",
            "solver=soft-step",
            "velocity-iterations=3",
            "gravity-y=-5")) {
      assertNotEquals(plain, hashOf("--steps", "60", "--hash", "--set", setting), setting);
    }
  }

  @Test
  void parametersAreListedWithRangeAndUnit() {
    assertEquals(0, run("--scene", "main", "--parameters", "--set", "rigidity=20"));
    String row = out.toString().lines().filter(l -> l.contains("rigidity=")).findFirst().get();
    assertTrue(row.contains("rigidity=20.0 "), row);
    assertTrue(row.contains(" 0 to 500 N s "), row);
  }

  @Test
  void recordedRunIsRepeated() throws Exception {
    Path file = directory.resolve("run.rec");
    String path = file.toString();
    assertEquals(0, run("--steps", "40", "--seed", "7", "--set", "rigidity=20", "--record", path));
    assertTrue(out.toString().contains("recording written to " + path), out.toString());
    out.getBuffer().setLength(0);
    assertEquals(0, run("--replay", path));
    assertTrue(out.toString().startsWith("main: 40 steps at 50.0 Hz, seed 7"), out.toString());
    assertTrue(out.toString().contains("every step is as in the recording"), out.toString());
    assertEquals("", err.toString());
  }

  @Test
  void replayThatDivergesNamesStepAndBodyAndGivesCode3() throws Exception {
    Path file = directory.resolve("run.rec");
    assertEquals(0, run("--steps", "40", "--record", file.toString()));
    String other = Files.readString(file).replace("\nrun\n", "\nset rigidity 20.0\nrun\n");
    Files.writeString(file, other);
    assertEquals(3, run("--replay", file.toString()));
    List<String> lines = err.toString().lines().toList();
    assertEquals(1, lines.size(), err.toString());
    assertTrue(
        lines.get(0).matches(".*run.rec: diverges after step \\d+: body 3 differs: .*"),
        lines.get(0));
  }

  @Test
  void brokenRecordingGivesOneLineAndCode1() throws Exception {
    Path file = directory.resolve("run.rec");
    Files.writeString(file, "jbox2d-testbed recording 1\nscene nowhere\n");
    assertEquals(1, run("--replay", file.toString()));
    List<String> lines = err.toString().lines().toList();
    assertEquals(1, lines.size(), err.toString());
    assertTrue(lines.get(0).contains("line 2: unknown scene 'nowhere'"), lines.get(0));
  }
}
