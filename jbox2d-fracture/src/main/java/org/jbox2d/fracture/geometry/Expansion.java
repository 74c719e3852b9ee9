package org.jbox2d.fracture.geometry;

/**
 * A real number held exactly as a sum of doubles that do not overlap, smallest magnitude first,
 * without zeros.
 *
 * <p>Sums and products of expansions are exact. Source: Shewchuk 1997 (see {@link Predicates}),
 * theorems 10, 13 and 19. An object owns its array; operations write into {@code this} and never
 * allocate, so the caller gives room enough: the number of components of a sum is at most that of
 * both operands together, that of a product twice the product of both.
 */
final class Expansion {
  private final double[] component;
  private int size;

  Expansion(int capacity) {
    component = new double[capacity];
  }

  /** Sets this to high + low, where low is the rounding error of high. */
  Expansion setPair(double low, double high) {
    size = 0;
    append(low);
    append(high);
    return this;
  }

  /** Sets this to e + f; {@code this} is neither of them. */
  Expansion setSum(Expansion e, Expansion f) {
    return setMerged(e, f, 1);
  }

  /** Sets this to e - f; {@code this} is neither of them. */
  Expansion setDifference(Expansion e, Expansion f) {
    return setMerged(e, f, -1);
  }

  /**
   * Sets this to e * f, with two scratch expansions of at least this capacity; all five are
   * distinct but e and f.
   */
  Expansion setProduct(Expansion e, Expansion f, Expansion scaled, Expansion sum) {
    size = 0;
    for (int i = 0; i < f.size; i++) {
      scaled.setScaled(e, f.component[i]);
      sum.setSum(this, scaled);
      set(sum);
    }
    return this;
  }

  int sign() {
    if (size == 0) {
      return 0;
    }
    return component[size - 1] > 0 ? 1 : -1;
  }

  /**
   * Linear-time merge of two expansions (theorem 13), the components of f multiplied by +1 or -1.
   */
  private Expansion setMerged(Expansion e, Expansion f, int factor) {
    size = 0;
    int i = 0;
    int j = 0;
    double carry = 0;
    while (i < e.size || j < f.size) {
      boolean takeE =
          j == f.size || (i < e.size && Math.abs(e.component[i]) < Math.abs(f.component[j]));
      double next = takeE ? e.component[i++] : factor * f.component[j++];
      double total = carry + next;
      append(Predicates.differenceTail(carry, -next, total));
      carry = total;
    }
    append(carry);
    return this;
  }

  /** Sets this to factor * e (theorem 19). */
  private void setScaled(Expansion e, double factor) {
    size = 0;
    double carry = 0;
    for (int i = 0; i < e.size; i++) {
      double product = e.component[i] * factor;
      double tail = Predicates.productTail(e.component[i], factor, product);
      double low = carry + tail;
      append(Predicates.differenceTail(carry, -tail, low));
      double high = product + low;
      append(low - (high - product));
      carry = high;
    }
    append(carry);
  }

  /** Sets this to e. */
  void set(Expansion e) {
    System.arraycopy(e.component, 0, component, 0, e.size);
    size = e.size;
  }

  private void append(double value) {
    if (value != 0) {
      component[size++] = value;
    }
  }
}
