package org.jbox2d.pooling;

/** A supply of objects of one type, given back in the reverse order of taking. */
public interface IOrderedStack<E> {
  /** Takes an object; its state is whatever it was when given back. */
  E pop();

  /** Takes {@code argNum} objects; the array holds them at least until the next call. */
  E[] pop(int argNum);

  /** Gives the last {@code argNum} objects back. */
  void push(int argNum);
}
