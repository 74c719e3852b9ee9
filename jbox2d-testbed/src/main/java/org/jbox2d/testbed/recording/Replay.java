package org.jbox2d.testbed.recording;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jbox2d.dynamics.Body;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Input;
import org.jbox2d.testbed.simulation.Setup;
import org.jbox2d.testbed.simulation.Simulation;
import org.jbox2d.testbed.simulation.StateHash;

/**
 * Repeats a recording: gives what was done before each step, and compares the state after it. Read
 * line by line, so that a long recording takes no memory.
 */
public final class Replay implements Closeable {
  private final Path file;
  private final BufferedReader in;
  private final Setup setup;
  private int lineNumber;

  /** The line that has been read but not used. */
  private String line;

  /** Hashes of the bodies after the last step, by the recording. */
  private int[] last = new int[0];

  /**
   * Opens a recording.
   *
   * @throws RecordingException if it is none; the message names file and line, and what would be
   *     right
   */
  public Replay(Path file) throws IOException {
    this.file = file;
    in = Files.newBufferedReader(file, StandardCharsets.UTF_8);
    try {
      setup = readSetup();
    } catch (IOException e) {
      in.close();
      throw e;
    }
  }

  // --- How it begins

  private Setup readSetup() throws IOException {
    next();
    if (!RecordingWriter.TITLE.equals(line)) {
      throw wrong("'" + RecordingWriter.TITLE + "'");
    }
    next();
    Scene scene = readScene(after("scene"));
    next();
    Setup read = setupOf(scene, (float) number(after("hz")));
    next();
    read = new Setup(scene, read.hz(), whole(after("seed")), Values.NONE);
    next();
    while (!line.equals("run")) {
      String[] words = after("set").split(" ");
      if (words.length != 2) {
        throw wrong("'set', a parameter and its value");
      }
      read = with(read, words[0], words[1]);
      next();
    }
    next();
    return read;
  }

  private Scene readScene(String name) throws IOException {
    try {
      return Scenes.named(name);
    } catch (IllegalArgumentException e) {
      throw at(e.getMessage());
    }
  }

  private Setup setupOf(Scene scene, float hz) throws IOException {
    try {
      return new Setup(scene, hz, 0, Values.NONE);
    } catch (IllegalArgumentException e) {
      throw at(e.getMessage());
    }
  }

  private Setup with(Setup begun, String name, String value) throws IOException {
    try {
      Parameter parameter = new Simulation(begun).parameter(name);
      return begun.with(name, parameter.parse(value));
    } catch (IllegalArgumentException e) {
      throw at(e.getMessage());
    }
  }

  /** Returns what the run began with. */
  public Setup setup() {
    return setup;
  }

  // --- Step by step

  /**
   * Does to the run what was done before the next step.
   *
   * @return whether there is a next step
   */
  public boolean prepare(Simulation run) throws IOException {
    while (line.startsWith("do ")) {
      try {
        run.apply(Input.parse(after("do")));
      } catch (IllegalArgumentException e) {
        throw at(e.getMessage());
      }
      next();
    }
    if (line.startsWith("end")) {
      return false;
    }
    if (!line.startsWith("after ")) {
      throw wrong("'do', 'after' or 'end'");
    }
    return true;
  }

  /**
   * Compares the state after a step.
   *
   * @return where it differs, or {@code null} if it does not
   */
  public Divergence check(Simulation run) throws IOException {
    String[] words = after("after").split(" ");
    if (words.length < 2 || whole(words[0]) != run.steps()) {
      throw wrong("'after " + run.steps() + "' and a hash");
    }
    int[] recorded = hashes(words);
    last = recorded;
    next();
    if (words[1].equals(Long.toHexString(run.hash()))) {
      return null;
    }
    return compare(run, recorded);
  }

  private int[] hashes(String[] words) throws IOException {
    int[] hashes = new int[words.length - 2];
    for (int i = 0; i < hashes.length; i++) {
      String word = words[i + 2];
      if (word.equals(RecordingWriter.UNCHANGED) && i < last.length) {
        hashes[i] = last[i];
      } else {
        try {
          hashes[i] = Integer.parseUnsignedInt(word, RecordingWriter.RADIX);
        } catch (NumberFormatException e) {
          throw wrong("a hash instead of '" + word + "'");
        }
      }
    }
    return hashes;
  }

  private static Divergence compare(Simulation run, int[] recorded) {
    int[] here = StateHash.ofBodies(run.world());
    int first = 0;
    while (first < here.length && first < recorded.length && here[first] == recorded[first]) {
      first++;
    }
    String counts =
        "there are " + here.length + " bodies here, " + recorded.length + " in the recording";
    if (first == here.length && first == recorded.length) {
      return new Divergence(run.steps(), -1, "all bodies are the same, but contacts are not");
    }
    if (first == here.length) {
      return new Divergence(run.steps(), first, "body " + first + " is missing: " + counts);
    }
    String differs = first == recorded.length ? " is one too many: " : " differs: ";
    String what = "body " + first + differs + describe(run, here.length - 1 - first);
    return new Divergence(
        run.steps(), first, here.length == recorded.length ? what : what + "; " + counts);
  }

  private static String describe(Simulation run, int fromNewest) {
    Body body = run.world().getBodyList();
    for (int i = 0; i < fromNewest; i++) {
      body = body.getNext();
    }
    return "here it is at "
        + body.getPosition()
        + ", angle "
        + body.getAngle()
        + ", velocity "
        + body.getLinearVelocity()
        + ", "
        + body.getAngularVelocity();
  }

  // --- Lines

  private void next() throws IOException {
    line = in.readLine();
    lineNumber++;
    if (line == null) {
      throw at("the recording ends too early; its last line must be 'end' and the steps");
    }
  }

  private String after(String word) throws IOException {
    if (!line.startsWith(word + " ")) {
      throw wrong("'" + word + "'");
    }
    return line.substring(word.length() + 1);
  }

  private double number(String word) throws IOException {
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw wrong("a number instead of '" + word + "'");
    }
  }

  private long whole(String word) throws IOException {
    try {
      return Long.parseLong(word);
    } catch (NumberFormatException e) {
      throw wrong("a whole number instead of '" + word + "'");
    }
  }

  private RecordingException wrong(String expected) {
    String start = line.length() > 40 ? line.substring(0, 40) + "..." : line;
    return at("expected " + expected + ", found '" + start + "'");
  }

  private RecordingException at(String message) {
    return new RecordingException(file + " line " + lineNumber + ": " + message);
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
