package org.jbox2d.testbed.parameters;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** Values of parameters, by name, in the order in which they were set. Immutable. */
public final class Values {
  /** Nothing set: every parameter has its default. */
  public static final Values NONE = new Values(new LinkedHashMap<>());

  private final Map<String, Double> values;

  private Values(Map<String, Double> values) {
    this.values = values;
  }

  /** Returns these values with one set or replaced. */
  public Values with(String name, double value) {
    Map<String, Double> copy = new LinkedHashMap<>(values);
    copy.put(name, value);
    return new Values(copy);
  }

  /** Returns these values without one. */
  public Values without(String name) {
    Map<String, Double> copy = new LinkedHashMap<>(values);
    copy.remove(name);
    return new Values(copy);
  }

  /** Returns the value of a parameter: what was set, or its default. */
  public double get(Parameter parameter) {
    return values.getOrDefault(parameter.name(), parameter.initial());
  }

  /** Returns the value of a parameter as a float. */
  public float real(Parameter parameter) {
    return (float) get(parameter);
  }

  /** Returns the value of a parameter as a whole number. */
  public int whole(Parameter parameter) {
    return (int) get(parameter);
  }

  /** Returns whether a switch is on. */
  public boolean isOn(Parameter parameter) {
    return get(parameter) != 0;
  }

  /** Returns what has been set, in order. */
  public Map<String, Double> set() {
    return Collections.unmodifiableMap(values);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Values && ((Values) other).values.equals(values);
  }

  @Override
  public int hashCode() {
    return values.hashCode();
  }

  @Override
  public String toString() {
    return values.toString();
  }
}
