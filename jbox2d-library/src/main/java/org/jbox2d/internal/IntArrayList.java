package org.jbox2d.internal;

import java.util.Arrays;

/**
 * A growable list of ints, also usable as a stack. Its storage only ever grows, so that a list that
 * is cleared and filled again each step allocates nothing once it is warm.
 */
public final class IntArrayList {
  private int[] elements;
  private int size;

  /** An empty list that holds 16 elements before it first grows. */
  public IntArrayList() {
    this(16);
  }

  /**
   * An empty list.
   *
   * @param capacity number of elements it holds before it first grows, 0 or more
   */
  public IntArrayList(int capacity) {
    if (capacity < 0) {
      throw new IllegalArgumentException("capacity must not be negative: " + capacity);
    }
    elements = new int[capacity];
  }

  public int size() {
    return size;
  }

  public boolean isEmpty() {
    return size == 0;
  }

  public void add(int value) {
    if (size == elements.length) {
      elements = Arrays.copyOf(elements, Math.max(16, 2 * size));
    }
    elements[size++] = value;
  }

  /**
   * The element at an index. Only the storage bounds the index: reading between {@link #size()} and
   * the capacity is a defect of the caller that goes unnoticed.
   */
  public int get(int index) {
    return elements[index];
  }

  public void set(int index, int value) {
    elements[index] = value;
  }

  /** Removes and returns the last element. */
  public int pop() {
    return elements[--size];
  }

  /** Removes an element by moving the last one into its place: the order is not kept. */
  public void removeSwap(int index) {
    elements[index] = elements[--size];
  }

  public void clear() {
    size = 0;
  }

  /**
   * The storage, of which the first {@link #size()} elements count; valid until the next {@link
   * #add}.
   */
  public int[] raw() {
    return elements;
  }
}
