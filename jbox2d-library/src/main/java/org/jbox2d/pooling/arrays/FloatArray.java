package org.jbox2d.pooling.arrays;

import java.util.HashMap;
import java.util.Map;

/**
 * Arrays that are kept by length and handed out again: a call of {@link #get} invalidates the last
 * one of that length.
 */
public class FloatArray {

  private final Map<Integer, float[]> byLength = new HashMap<>();

  public FloatArray() {}

  /** An array of {@code argLength} elements, with whatever content it was left with. */
  public float[] get(int argLength) {
    if (argLength < 0) {
      throw new IllegalArgumentException("argLength must not be negative: " + argLength);
    }
    float[] array = byLength.get(argLength);
    if (array == null) {
      array = getInitializedArray(argLength);
      byLength.put(argLength, array);
    }
    return array;
  }

  /** A new array for {@link #get} to keep. */
  protected float[] getInitializedArray(int argLength) {
    return new float[argLength];
  }
}
