package org.jbox2d.testbed.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Input.Action;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordingTest {
  private static final Setup SETUP = Setup.of(Scenes.named("main"), 3).with("rigidity", 30);
  private static final int STEPS = 50;

  /** Every kind of input, and the step before which it is done. */
  private static final Object[][] INPUTS = {
    {0, Input.at(Action.GRAB, -30, 5.3)},
    {2, Input.at(Action.DRAG, -20.25, 6.1)},
    {4, Input.release()},
    {6, Input.set("gravity-y", -3.5)},
    {6, Input.at(Action.THROW, 1, 7)},
    {20, Input.at(Action.BREAK, 1.7, 8.2)},
    {22, Input.cut(-9, 3, 9, 4)},
    {30, Input.at(Action.EXPLODE, 0.3, 0.4)},
    {35, Input.set("hz", 120)}
  };

  @TempDir Path directory;

  private Path record() throws IOException {
    Path file = directory.resolve("run.rec");
    Simulation run = new Simulation(SETUP);
    try (RecordingWriter writer = new RecordingWriter(file, run)) {
      for (int i = 0; i < STEPS; i++) {
        for (Object[] timed : INPUTS) {
          if ((int) timed[0] == i) {
            run.apply((Input) timed[1]);
          }
        }
        run.step();
        writer.step(run);
      }
    }
    return file;
  }

  @Test
  void everyKindOfInputIsRepeatedToTheBit() throws IOException {
    try (Replay replay = new Replay(record())) {
      assertEquals(SETUP, replay.setup());
      Simulation run = new Simulation(replay.setup());
      int steps = 0;
      while (replay.prepare(run)) {
        run.step();
        steps++;
        assertNull(replay.check(run), "step " + steps);
      }
      assertEquals(STEPS, steps);
      assertEquals(INPUTS.length, run.inputs().size());
      for (int i = 0; i < INPUTS.length; i++) {
        assertEquals(INPUTS[i][0], run.inputs().get(i).step());
        assertEquals(INPUTS[i][1], run.inputs().get(i).input());
      }
      assertTrue(run.fractureCount() > 0);
    }
  }

  @Test
  void firstStepAndBodyThatDifferAreNamed() throws IOException {
    try (Replay replay = new Replay(record())) {
      Simulation run = new Simulation(replay.setup());
      for (int i = 0; i < 10; i++) {
        assertTrue(replay.prepare(run));
        run.step();
        assertNull(replay.check(run));
      }
      assertTrue(replay.prepare(run));
      // By the order of creation: three bodies of the stage, the box, the disc.
      Body box = run.world().getBodyList();
      while (run.world().getBodyCount() > 0
          && box.getNext().getNext().getNext().getNext() != null) {
        box = box.getNext();
      }
      box.m_linearVelocity.x = Math.nextUp(box.m_linearVelocity.x + 1e-3f);
      run.step();
      Divergence divergence = replay.check(run);
      assertNotNull(divergence);
      assertEquals(11, divergence.step());
      assertEquals(3, divergence.body());
    }
  }

  @Test
  void otherNumberOfBodiesIsTold() throws IOException {
    try (Replay replay = new Replay(record())) {
      Simulation run = new Simulation(replay.setup());
      assertTrue(replay.prepare(run));
      run.apply(Input.at(Action.THROW, 0, 30));
      run.step();
      Divergence divergence = replay.check(run);
      assertEquals(5, divergence.body());
      assertTrue(divergence.toString().contains("6 bodies here, 5 in the recording"));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 | jbox2d-testbed recording 2 | expected 'jbox2d-testbed recording 1', found",
        "2 | scene nowhere | unknown scene 'nowhere'",
        "2 | szene main | expected 'scene', found 'szene main'",
        "3 | hz fast | expected a number instead of 'fast'",
        "3 | hz -1 | hz must be positive and finite, is -1",
        "4 | seed 1.5 | expected a whole number instead of '1.5'",
        "5 | set rigidity | expected 'set', a parameter and its value",
        "5 | set rigidity -4 | rigidity must be 0 to 500 N s, is -4",
        "5 | set rigour 4 | unknown parameter 'rigour'",
        "7 | undo | expected 'do', 'after' or 'end', found 'undo'",
        "7 | do dance | unknown input 'dance'; there are: grab, drag",
        "7 | do grab 1 | 'grab' takes 2 words after it",
        "7 | do grab 1 up | 'up' is not a number",
        "7 | do grab 1 Infinity | 'Infinity' is not a finite number",
        "7 | do set rigidity 1000 | rigidity must be 0 to 500 N s, is 1000",
        "7 | after 5 abc | expected 'after 1' and a hash",
        "7 | after 1 abc ? | expected a hash instead of '?'",
      })
  void mistakesNameLineAndWhatWouldBeRight(int line, String text, String message)
      throws IOException {
    Path file = record();
    List<String> lines = Files.readAllLines(file);
    lines.set(line - 1, text);
    Files.write(file, lines);
    RecordingException e = assertThrows(RecordingException.class, () -> playAll(file));
    assertTrue(e.getMessage().startsWith(file + " line " + line + ": " + message), e.getMessage());
  }

  @Test
  void recordingWithoutItsEndIsToldFromOneThatEnds() throws IOException {
    Path file = record();
    List<String> lines = Files.readAllLines(file);
    assertEquals("end " + STEPS, lines.get(lines.size() - 1));
    Files.write(file, lines.subList(0, 20));
    RecordingException e = assertThrows(RecordingException.class, () -> playAll(file));
    assertTrue(e.getMessage().contains("line 21: the recording ends too early"), e.getMessage());
    assertFalse(e.getMessage().contains("\n"));
  }

  private static void playAll(Path file) throws IOException {
    try (Replay replay = new Replay(file)) {
      Simulation run = new Simulation(replay.setup());
      while (replay.prepare(run)) {
        run.step();
        replay.check(run);
      }
    }
  }
}
