package org.jbox2d.testbed.recording;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.StateHash;
import org.jbox2d.testbed.simulation.TimedInput;

/**
 * Writes a run as lines of text:
 *
 * <pre>
 * jbox2d-testbed recording 1
 * scene main
 * hz 50.0
 * seed 1
 * set rigidity 20.0            what differs from the defaults, in any number of lines
 * run
 * do throw 3.0 4.0             what was done before the next step
 * after 1 9f3c... 1k2j . x8a   hash of the world; of each body, the oldest first
 * end 1
 * </pre>
 *
 * A dot stands for the hash that the same place had after the step before: bodies asleep take two
 * characters. Only how a run begins and what is done to it is needed to repeat it; the hashes are
 * there to find out where a repetition goes another way.
 */
public final class RecordingWriter implements Closeable {
  static final String TITLE = "jbox2d-testbed recording 1";
  static final String UNCHANGED = ".";
  static final int RADIX = 36;

  private final BufferedWriter out;
  private int inputsWritten;
  private int steps;
  private int[] last = new int[0];

  /** Opens a file for a run that has just been built. */
  public RecordingWriter(Path file, Simulation run) throws IOException {
    out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    Setup setup = run.setup();
    line(TITLE);
    line("scene " + setup.scene().name());
    line("hz " + setup.hz());
    line("seed " + setup.seed());
    for (Map.Entry<String, Double> entry : setup.values().set().entrySet()) {
      Parameter parameter = run.parameter(entry.getKey());
      line("set " + parameter.name() + " " + parameter.format(entry.getValue()));
    }
    line("run");
  }

  /**
   * Writes a run that has been done already, by doing it again.
   *
   * @param inputs what was done to it
   * @param steps how many steps it had
   */
  public static void write(Path file, Setup setup, List<TimedInput> inputs, int steps)
      throws IOException {
    Simulation run = new Simulation(setup);
    try (RecordingWriter writer = new RecordingWriter(file, run)) {
      int next = 0;
      while (run.steps() < steps) {
        while (next < inputs.size() && inputs.get(next).step() == run.steps()) {
          run.apply(inputs.get(next++).input());
        }
        run.step();
        writer.step(run);
      }
    }
  }

  private void line(String line) throws IOException {
    out.write(line);
    out.write('\n');
  }

  /** Writes a step, and what was done before it. */
  public void step(Simulation run) throws IOException {
    inputs(run);
    int[] hashes = StateHash.ofBodies(run.world());
    StringBuilder line = new StringBuilder(16 + 8 * hashes.length);
    line.append("after ").append(run.steps());
    line.append(' ').append(Long.toHexString(run.hash()));
    for (int i = 0; i < hashes.length; i++) {
      boolean same = i < last.length && last[i] == hashes[i];
      line.append(' ').append(same ? UNCHANGED : Integer.toUnsignedString(hashes[i], RADIX));
    }
    line(line.toString());
    last = hashes;
    steps = run.steps();
  }

  private void inputs(Simulation run) throws IOException {
    List<TimedInput> inputs = run.inputs();
    while (inputsWritten < inputs.size()) {
      line("do " + inputs.get(inputsWritten++).input());
    }
  }

  @Override
  public void close() throws IOException {
    line("end " + steps);
    out.close();
  }
}
