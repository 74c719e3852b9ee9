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
   * Sorts the first n elements of {@code order}, which hold ascending indices, by first key, then
   * second key, then index.
   *
   * @param scratch room for n elements
   */
  public static void sort(int[] order, int n, double[] first, double[] second, int[] scratch) {
    for (int start = 0; start < n; start += RUN) {
      insertionSort(order, start, Math.min(start + RUN, n), first, second);
    }
    int[] from = order;
    int[] to = scratch;
    for (int width = RUN; width < n; width *= 2) {
      for (int start = 0; start < n; start += 2 * width) {
        int middle = Math.min(start + width, n);
        merge(from, to, start, middle, Math.min(middle + width, n), first, second);
      }
      int[] swap = from;
      from = to;
      to = swap;
    }
    if (from != order) {
      System.arraycopy(from, 0, order, 0, n);
    }
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
