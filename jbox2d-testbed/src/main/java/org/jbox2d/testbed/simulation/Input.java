package org.jbox2d.testbed.simulation;

import java.util.Arrays;
import java.util.StringJoiner;

/**
 * Something the user does to a run between two steps. Immutable, and a line of text, so that runs
 * can be recorded and repeated to the bit.
 */
public final class Input {
  /** What can be done. */
  public enum Action {
    /** Takes hold of the dynamic body at a world point. */
    GRAB("grab", 2),
    /** Pulls what is held towards a world point. */
    DRAG("drag", 2),
    /** Lets go. */
    RELEASE("release", 0),
    /** Throws a disc at a world point. */
    THROW("throw", 2),
    /** Strikes what is at a world point, twice as hard as it bears. */
    BREAK("break", 2),
    /** Cuts along the segment between two world points. */
    CUT("cut", 4),
    /** Sets off an explosion at a world point. */
    EXPLODE("explode", 2),
    /** Changes a parameter. */
    SET("set", 1);

    private final String word;
    private final int numbers;

    Action(String word, int numbers) {
      this.word = word;
      this.numbers = numbers;
    }
  }

  private final Action action;
  private final String parameter;
  private final double[] numbers;

  private Input(Action action, String parameter, double... numbers) {
    this.action = action;
    this.parameter = parameter;
    this.numbers = numbers;
  }

  /** An action at a world point, m. */
  public static Input at(Action action, double x, double y) {
    if (action.numbers != 2) {
      throw new IllegalArgumentException(action + " is not done at a point");
    }
    return new Input(action, "", x, y);
  }

  /** Lets go of what is held. */
  public static Input release() {
    return new Input(Action.RELEASE, "");
  }

  /** A cut between two world points, m. */
  public static Input cut(double x1, double y1, double x2, double y2) {
    return new Input(Action.CUT, "", x1, y1, x2, y2);
  }

  /** A parameter's new value. */
  public static Input set(String parameter, double value) {
    return new Input(Action.SET, parameter, value);
  }

  /**
   * Returns the input of a line.
   *
   * @throws IllegalArgumentException if the line is not what {@link #toString} gives; the message
   *     says what would be right
   */
  public static Input parse(String line) {
    String[] words = line.split(" ");
    for (Action action : Action.values()) {
      if (action.word.equals(words[0])) {
        return parse(action, words);
      }
    }
    StringJoiner known = new StringJoiner(", ");
    for (Action action : Action.values()) {
      known.add(action.word);
    }
    throw new IllegalArgumentException("unknown input '" + words[0] + "'; there are: " + known);
  }

  private static Input parse(Action action, String[] words) {
    int first = action == Action.SET ? 2 : 1;
    if (words.length != first + action.numbers) {
      throw new IllegalArgumentException(
          "'" + action.word + "' takes " + (first - 1 + action.numbers) + " words after it");
    }
    double[] numbers = new double[action.numbers];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = finite(words[first + i]);
    }
    return new Input(action, action == Action.SET ? words[1] : "", numbers);
  }

  private static double finite(String word) {
    double number;
    try {
      number = Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("'" + word + "' is not a number", e);
    }
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException("'" + word + "' is not a finite number");
    }
    return number;
  }

  /** Returns what is done. */
  public Action action() {
    return action;
  }

  /** Returns the name of the parameter that is set; empty for all but {@link Action#SET}. */
  public String parameter() {
    return parameter;
  }

  /** Returns a coordinate, m, or the value of a parameter. */
  public double number(int i) {
    return numbers[i];
  }

  float real(int i) {
    return (float) numbers[i];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Input && other.toString().equals(toString());
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }

  @Override
  public String toString() {
    StringJoiner line = new StringJoiner(" ");
    line.add(action.word);
    if (action == Action.SET) {
      line.add(parameter);
    }
    for (double number : numbers) {
      line.add(Double.toString(number));
    }
    return line.toString();
  }
}
