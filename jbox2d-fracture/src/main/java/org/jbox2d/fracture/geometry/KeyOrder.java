package org.jbox2d.fracture.geometry;

import java.util.Arrays;

/**
 * Sorts indices by one key of doubles. Total and deterministic: equal keys keep the order of their
 * indices.
 *
 * <p>Many keys are distributed to as many buckets first, by their bits, which grow with the number
 * and about as its logarithm; buckets of more than one are sorted by {@link SortedIndices}. That is
 * linear time unless most keys are nearly the same, and then O(n log n). An instance owns its
 * arrays and reuses them.
 */
public final class KeyOrder {
  /** Up to this number of keys it is fastest to count for each the keys before it. */
  private static final int FEW = 40;

  private int[] order = new int[64];
  private int[] scratch = new int[64];
  private int[] bucketOf = new int[64];
  private int[] bucketStart = new int[65];
  private final double[] few = new double[FEW];

  /**
   * The indices 0 to n-1 in ascending order of key, in an array that is used again by the next call
   * and may have more than n elements.
   *
   * @param key at least n finite numbers
   */
  public int[] ascending(double[] key, int n) {
    if (order.length < n) {
      int size = n + n / 2;
      order = new int[size];
      scratch = new int[size];
      bucketOf = new int[size];
      bucketStart = new int[size + 1];
    }
    if (n > FEW) {
      distribute(key, n);
    } else {
      countBelow(key, n);
    }
    return order;
  }

  /**
   * Compares all pairs: the place of a key is the number of those below it, and of equal ones
   * before it. Which of two is below is as good as random, so the sign bits of differences are
   * added up. Adding zero turns -0 into 0: then the difference of equal keys has no sign.
   */
  private void countBelow(double[] key, int n) {
    int[] place = bucketOf;
    for (int i = 0; i < n; i++) {
      double own = key[i] + 0.0;
      few[i] = own;
      int above = 0;
      for (int j = 0; j < i; j++) {
        int isAbove = (int) (Double.doubleToRawLongBits(own - few[j]) >>> 63);
        place[j] += isAbove;
        above += isAbove;
      }
      place[i] = i - above;
    }
    for (int i = 0; i < n; i++) {
      order[place[i]] = i;
    }
  }

  private void distribute(double[] key, int n) {
    long least = Long.MAX_VALUE;
    long most = Long.MIN_VALUE;
    for (int i = 0; i < n; i++) {
      long b = halfOfBits(key[i]);
      least = Math.min(least, b);
      most = Math.max(most, b);
    }
    double scale = (n - 1) / Math.max(1.0, (double) (most - least));
    Arrays.fill(bucketStart, 0, n + 1, 0);
    for (int i = 0; i < n; i++) {
      int b = Math.min(n - 1, (int) ((halfOfBits(key[i]) - least) * scale));
      bucketOf[i] = b;
      bucketStart[b]++;
    }
    for (int b = 0; b < n; b++) {
      bucketStart[b + 1] += bucketStart[b];
    }
    for (int i = n - 1; i >= 0; i--) {
      order[--bucketStart[bucketOf[i]]] = i;
    }
    for (int b = 0; b < n; b++) {
      if (bucketStart[b + 1] - bucketStart[b] > 1) {
        SortedIndices.sort(order, bucketStart[b], bucketStart[b + 1], key, key, scratch);
      }
    }
  }

  /**
   * The bits of a number as an integer that grows with it, halved so that differences do not
   * overflow. Adding zero turns -0 into 0, which is equal to it.
   */
  private static long halfOfBits(double value) {
    long bits = Double.doubleToRawLongBits(value + 0.0);
    return (bits ^ ((bits >> 63) & Long.MAX_VALUE)) >> 1;
  }
}
