package org.jbox2d.internal;

/**
 * What a receiver of pairs may be beside: one that can tell beforehand which pairs it does not
 * want. Those are most that a broad phase finds, and for them nothing else is read.
 */
public interface PairSelection {
  /**
   * Returns whether a pair need not be reported, as the receiver has it already.
   *
   * @param low lower of the two proxy ids
   * @param high the other
   */
  boolean knows(int low, int high);

  /** Returns whether pairs are of no use whose categories do not collide. */
  boolean goesByCategories();
}
