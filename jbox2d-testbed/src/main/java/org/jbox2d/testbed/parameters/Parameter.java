package org.jbox2d.testbed.parameters;

import java.math.BigDecimal;
import java.util.List;

/**
 * A value that a user may change: a number with a range and a unit, a switch, or a choice. Values
 * are doubles throughout; a switch is 0 or 1, a choice is the index of what is chosen.
 */
public final class Parameter {
  /** Whether a parameter is a number, and of what kind. */
  public enum Kind {
    /** Any number of the range. */
    REAL,
    /** Whole numbers of the range. */
    WHOLE,
    /** One of a few words, among them "off" and "on". */
    CHOICE
  }

  /** What a parameter is a property of; the order is that of lists. */
  public enum Group {
    /** How a scene is built; a change builds it anew. */
    SCENE("Scene"),
    /** What breaks, and how. */
    MATERIAL("Material"),
    /** How the world is solved. */
    SOLVER("Solver"),
    /** What the user's hand does. */
    TOOLS("Tools");

    private final String title;

    Group(String title) {
      this.title = title;
    }

    /** Returns a word for a heading. */
    public String title() {
      return title;
    }
  }

  private static final List<String> SWITCH = List.of("off", "on");

  private final Group group;
  private final Kind kind;
  private final String name;
  private final String unit;
  private final double least;
  private final double most;
  private final double initial;
  private final List<String> choices;
  private final String doc;

  private Parameter(
      Group group,
      Kind kind,
      String name,
      String unit,
      double least,
      double most,
      double initial,
      List<String> choices,
      String doc) {
    this.group = group;
    this.kind = kind;
    this.name = name;
    this.unit = unit;
    this.least = least;
    this.most = most;
    this.initial = initial;
    this.choices = choices;
    this.doc = doc;
    if (!isAllowed(initial)) {
      throw new IllegalArgumentException("default of " + name + ": " + complaint("" + initial));
    }
  }

  /**
   * A number.
   *
   * @param name lower case, words joined by a hyphen
   * @param unit such as "m/s"; empty for none
   * @param doc one sentence
   */
  public static Parameter real(
      Group group,
      String name,
      String unit,
      double least,
      double most,
      double initial,
      String doc) {
    return new Parameter(group, Kind.REAL, name, unit, least, most, initial, List.of(), doc);
  }

  /** A whole number; see {@link #real}. */
  public static Parameter whole(
      Group group, String name, int least, int most, int initial, String doc) {
    return new Parameter(group, Kind.WHOLE, name, "", least, most, initial, List.of(), doc);
  }

  /** A switch; see {@link #real}. */
  public static Parameter toggle(Group group, String name, boolean initial, String doc) {
    return choice(group, name, SWITCH, initial ? 1 : 0, doc);
  }

  /** A choice among words; see {@link #real}. */
  public static Parameter choice(
      Group group, String name, List<String> choices, int initial, String doc) {
    return new Parameter(
        group, Kind.CHOICE, name, "", 0, choices.size() - 1, initial, List.copyOf(choices), doc);
  }

  /**
   * Returns this parameter with another default, for what only a built world can tell; a range that
   * it is not in is widened.
   */
  public Parameter startingAt(float from) {
    // The shortest decimal that is this float, rather than the float's own long tail.
    double value = Double.parseDouble(Float.toString(from));
    return new Parameter(
        group,
        kind,
        name,
        unit,
        Math.min(least, value),
        Math.max(most, value),
        value,
        choices,
        doc);
  }

  /** Returns what it is a property of. */
  public Group group() {
    return group;
  }

  /** Returns its kind. */
  public Kind kind() {
    return kind;
  }

  /** Returns its name, as on the command line. */
  public String name() {
    return name;
  }

  /** Returns its unit; empty for none. */
  public String unit() {
    return unit;
  }

  /** Returns the least value. */
  public double least() {
    return least;
  }

  /** Returns the greatest value. */
  public double most() {
    return most;
  }

  /** Returns the default. */
  public double initial() {
    return initial;
  }

  /** Returns the words of a choice; empty for numbers. */
  public List<String> choices() {
    return choices;
  }

  /** Returns a sentence on what it does. */
  public String doc() {
    return doc;
  }

  /** Returns whether it is a choice between "off" and "on". */
  public boolean isSwitch() {
    return choices.equals(SWITCH);
  }

  /** Returns whether a value is in the range, and whole where it must be. */
  public boolean isAllowed(double value) {
    return value >= least && value <= most && (kind == Kind.REAL || value == Math.rint(value));
  }

  /**
   * Returns the value.
   *
   * @throws IllegalArgumentException if it is not allowed; the message says what would be
   */
  public double checked(double value) {
    if (!isAllowed(value)) {
      throw new IllegalArgumentException(complaint(Double.toString(value)));
    }
    return value;
  }

  /**
   * Returns the value that a text stands for: a number, or a word of a choice.
   *
   * @throws IllegalArgumentException if there is none; the message says what would be right
   */
  public double parse(String text) {
    if (kind == Kind.CHOICE) {
      int index = choices.indexOf(text);
      if (index < 0) {
        throw new IllegalArgumentException(complaint("'" + text + "'"));
      }
      return index;
    }
    double value;
    try {
      value = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(complaint("'" + text + "'"), e);
    }
    if (!isAllowed(value)) {
      throw new IllegalArgumentException(complaint(text));
    }
    return value;
  }

  /** Returns the text of a value, which {@link #parse} takes. */
  public String format(double value) {
    switch (kind) {
      case CHOICE:
        return choices.get((int) value);
      case WHOLE:
        return Long.toString((long) value);
      default:
        return Double.toString(value);
    }
  }

  /** Returns the allowed values, in words. */
  public String range() {
    if (kind == Kind.CHOICE) {
      return String.join(", ", choices);
    }
    return number(least) + " to " + number(most) + (unit.isEmpty() ? "" : " " + unit);
  }

  private String complaint(String value) {
    String what =
        switch (kind) {
          case REAL -> "";
          case WHOLE -> "a whole number from ";
          case CHOICE -> "one of ";
        };
    return name + " must be " + what + range() + ", is " + value;
  }

  private static String number(double value) {
    return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }

  @Override
  public String toString() {
    return name;
  }
}
