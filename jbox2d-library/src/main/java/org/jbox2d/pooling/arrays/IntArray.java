package org.jbox2d.pooling.arrays;

import java.util.HashMap;
import java.util.Map;

/**
 * Arrays that are kept by length and handed out again: a call of {@link #get} invalidates the last
 * one of that length.
 */
public class IntArray {

  private final Map<Integer, int[]> byLength = new HashMap<>();

  public IntArray() {}

  /** An array of {@code argLength} elements, with whatever content it was left with. */
  public int[] get(int argLength) {
    if (argLength < 0) {
      throw new IllegalArgumentException("argLength must not be negative: " + argLength);
    }
    int[] array = byLength.get(argLength);
    if (array == null) {
      array = getInitializedArray(argLength);
      byLength.put(argLength, array);
    }
    return array;
  }

  /** A new array for {@link #get} to keep. */
  protected int[] getInitializedArray(int argLength) {
    return new int[argLength];
  }
}
