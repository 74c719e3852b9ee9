package org.jbox2d.pooling;

/** A supply of objects of one type, taken and given back one by one in any order. */
public interface IDynamicStack<E> {
  /** Takes an object; its state is whatever it was when given back. */
  E pop();

  /** Gives an object back. */
  void push(E argObject);
}
