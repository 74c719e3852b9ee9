package org.jbox2d.internal;

/**
 * What a receiver of pairs may be beside: one that can tell by the ids alone which pairs it has
 * already. Most pairs that a broad phase finds are such, and for those nothing else is read.
 */
public interface KnownPairs {
  /**
   * Returns whether a pair need not be reported.
   *
   * @param low lower of the two proxy ids
   * @param high the other
   */
  boolean knows(int low, int high);
}
