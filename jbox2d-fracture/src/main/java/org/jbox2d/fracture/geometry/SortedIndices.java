package org.jbox2d.fracture.geometry;

/**
 * Sorting of indices by keys of doubles, without boxing. Total and deterministic: equal keys keep
 * the order of their indices.
 */
public final class SortedIndices {
  /** Runs of this length are sorted by insertion before they are merged. */
  private static final int RUN = 8;

  private SortedIndices() {}

  /** The indices 0 to n-1 in ascending order of key. */
  public static int[] by(double[] key, int n) {
    int[] order = new int[n];
    for (int i = 0; i < n; i++) {
      order[i] = i;
    }
    sort(order, n, key, key, new int[n]);
    return order;
  }

  /**
   * Sorts the first n elements of {@code order} by first key, then second key; equal ones keep
   * their order.
   *
   * @param scratch room for n elements
   */
  public static void sort(int[] order, int n, double[] first, double[] second, int[] scratch) {
    sort(order, 0, n, first, second, scratch);
  }

  /**
   * The same for the elements {@code start} (inclusive) to {@code end} (exclusive); scratch has
   * room up to there.
   */
  public static void sort(
      int[] order, int start, int end, double[] first, double[] second, int[] scratch) {
    for (int run = start; run < end; run += RUN) {
      insertionSort(order, run, Math.min(run + RUN, end), first, second);
    }
    int[] from = order;
    int[] to = scratch;
    for (int width = RUN; width < end - start; width *= 2) {
      for (int low = start; low < end; low += 2 * width) {
        int middle = Math.min(low + width, end);
        merge(from, to, low, middle, Math.min(middle + width, end), first, second);
      }
      int[] swap = from;
      from = to;
      to = swap;
    }
    if (from != order) {
      System.arraycopy(from, start, order, start, end - start);
    }
  }

  /**
   * The same for elements that are in order but for some near to their place: linear time for each
   * place that one is away.
   */
  public static void sortNearlySorted(
      int[] order, int start, int end, double[] first, double[] second) {
    insertionSort(order, start, end, first, second);
  }

  private static void insertionSort(
      int[] order, int start, int end, double[] first, double[] second) {
    for (int i = start + 1; i < end; i++) {
      int moved = order[i];
      int j = i;
      while (j > start && less(moved, order[j - 1], first, second)) {
        order[j] = order[j - 1];
        j--;
      }
      order[j] = moved;
    }
  }

  private static void merge(
      int[] from, int[] to, int start, int middle, int end, double[] first, double[] second) {
    int i = start;
    int j = middle;
    for (int k = start; k < end; k++) {
      if (i < middle && (j >= end || !less(from[j], from[i], first, second))) {
        to[k] = from[i++];
      } else {
        to[k] = from[j++];
      }
    }
  }

  private static boolean less(int i, int j, double[] first, double[] second) {
    if (first[i] != first[j]) {
      return first[i] < first[j];
    }
    return second[i] < second[j];
  }
}
