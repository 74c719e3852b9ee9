package org.jbox2d.pooling.arrays;

import java.util.HashMap;
import java.util.Map;
import org.jbox2d.common.Vec2;

/**
 * Arrays that are kept by length and handed out again: a call of {@link #get} invalidates the last
 * one of that length.
 */
public class Vec2Array {

  private final Map<Integer, Vec2[]> byLength = new HashMap<>();

  public Vec2Array() {}

  /** An array of {@code argLength} elements, with whatever content it was left with. */
  public Vec2[] get(int argLength) {
    if (argLength < 0) {
      throw new IllegalArgumentException("argLength must not be negative: " + argLength);
    }
    Vec2[] array = byLength.get(argLength);
    if (array == null) {
      array = getInitializedArray(argLength);
      byLength.put(argLength, array);
    }
    return array;
  }

  /** A new array for {@link #get} to keep. */
  protected Vec2[] getInitializedArray(int argLength) {
    Vec2[] array = new Vec2[argLength];
    for (int i = 0; i < argLength; i++) {
      array[i] = new Vec2();
    }
    return array;
  }
}
