package org.jbox2d.pooling.normal;

import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.jbox2d.pooling.IOrderedStack;

/** A stack that grows as needed. */
final class OrderedStack<E> implements IOrderedStack<E> {
  private final Supplier<E> maker;
  private final IntFunction<E[]> arrays;
  private E[] objects;
  private int taken;

  OrderedStack(int size, Supplier<E> maker, IntFunction<E[]> arrays) {
    this.maker = maker;
    this.arrays = arrays;
    objects = fill(arrays.apply(Math.max(1, size)), 0);
  }

  private E[] fill(E[] array, int from) {
    for (int i = from; i < array.length; i++) {
      array[i] = maker.get();
    }
    return array;
  }

  @Override
  public E pop() {
    reserve(1);
    return objects[taken++];
  }

  @Override
  public E[] pop(int argNum) {
    reserve(argNum);
    E[] out = arrays.apply(argNum);
    System.arraycopy(objects, taken, out, 0, argNum);
    taken += argNum;
    return out;
  }

  @Override
  public void push(int argNum) {
    if (argNum < 0 || argNum > taken) {
      throw new IllegalArgumentException("pushed " + argNum + " of " + taken + " popped objects");
    }
    taken -= argNum;
  }

  private void reserve(int n) {
    int needed = taken + n;
    if (needed > objects.length) {
      int old = objects.length;
      objects = fill(Arrays.copyOf(objects, Math.max(needed, 2 * old)), old);
    }
  }
}
