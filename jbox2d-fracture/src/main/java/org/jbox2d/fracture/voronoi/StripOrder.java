package org.jbox2d.fracture.voronoi;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.SortedIndices;

/**
 * Numbers distinct points by <em>rank</em>: their place in the order of vertical strips, within a
 * strip by y, then descending x, then index. Of repeated points only the one with the lowest index
 * has a rank of its own.
 *
 * <p>Sorted by distribution: the points go to a grid of about as many cells as there are points,
 * column by column; a column is then in order but for points of the same cell. Cells of many points
 * are sorted by merging, so clusters cost O(n log n).
 *
 * <p>An instance owns its arrays and reuses them.
 */
final class StripOrder {
  private static final int NONE = -1;

  /** From this number of points on there are several strips. */
  private static final int SMALLEST_IN_STRIPS = 16;

  /** Least number of distinct points in a strip; two would do. */
  private static final int SMALLEST_STRIP = 4;

  /** Cells of more points are sorted by merging before their column is sorted by insertion. */
  private static final int LARGE_CELL = 8;

  private int siteCount;
  private int count;
  private int stripCount;
  private int[] stripStart = new int[2];
  private int[] rankOfSite = new int[0];
  private int[] siteOfRank = new int[0];
  private double[] xy = new double[0];

  private double minX;
  private double maxX;
  private double minY;
  private double maxY;
  private int columns;
  private int rows;
  private int[] cellStart = new int[0];
  private int[] cellOf = new int[0];
  private int[] byCell = new int[0];
  private int[] scratch = new int[0];
  private double[] keyX = new double[0];
  private double[] keyY = new double[0];

  private int repeatedCount;
  private int[] repeated = new int[0];
  private int[] repeats = new int[0];

  /**
   * Numbers n points.
   *
   * @param points interleaved coordinates, at least 2 n; not changed
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  void number(double[] points, int n) {
    ensure(n);
    siteCount = n;
    findBounds(points, n);
    distribute(points, n);
    makeStrips();
    for (int rank = 0; rank < count; rank++) {
      int i = siteOfRank[rank];
      rankOfSite[i] = rank;
      xy[2 * rank] = points[2 * i];
      xy[2 * rank + 1] = points[2 * i + 1];
    }
    for (int k = 0; k < repeatedCount; k++) {
      rankOfSite[repeated[k]] = rankOfSite[repeats[k]];
    }
  }

  int siteCount() {
    return siteCount;
  }

  int count() {
    return count;
  }

  int rankOfSite(int i) {
    return rankOfSite[i];
  }

  int siteOfRank(int rank) {
    return siteOfRank[rank];
  }

  /** Interleaved coordinates in the order of ranks; not a copy. */
  double[] coordinates() {
    return xy;
  }

  int stripCount() {
    return stripCount;
  }

  /** First rank of a strip; of the strip after the last one, the number of ranks. */
  int stripStart(int strip) {
    return stripStart[strip];
  }

  private void ensure(int n) {
    if (rankOfSite.length >= n) {
      return;
    }
    int size = Math.max(n, rankOfSite.length + rankOfSite.length / 2);
    rankOfSite = new int[size];
    siteOfRank = new int[size];
    xy = new double[2 * size];
    cellOf = new int[size];
    byCell = new int[size];
    scratch = new int[size];
    keyX = new double[size];
    keyY = new double[size];
    repeated = new int[size];
    repeats = new int[size];
  }

  private void findBounds(double[] points, int n) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      double px = points[2 * i];
      double py = points[2 * i + 1];
      if (px * 0 + py * 0 != 0) {
        throw new IllegalArgumentException(
            "site " + i + " is not finite: (" + px + ", " + py + ")");
      }
      keyX[i] = -px;
      keyY[i] = py;
      left = px < left ? px : left;
      right = px > right ? px : right;
      low = py < low ? py : low;
      high = py > high ? py : high;
    }
    minX = left;
    maxX = right;
    minY = low;
    maxY = high;
  }

  /**
   * Sorts the points by their cell, and by index within it, into {@link #byCell}. There are about
   * the square root of n / log n columns.
   */
  private void distribute(double[] points, int n) {
    columns = 1;
    while (n >= SMALLEST_IN_STRIPS && columns * columns * Math.getExponent((float) n) < n) {
      columns++;
    }
    rows = n / columns + 1;
    int cells = columns * rows;
    if (cellStart.length < cells + 1) {
      cellStart = new int[cells + cells / 2 + 1];
    }
    if (stripStart.length < columns + 1) {
      stripStart = new int[2 * columns + 1];
    }
    Arrays.fill(cellStart, 0, cells + 1, 0);
    double scaleX = maxX > minX ? columns / (maxX - minX) : 0;
    double scaleY = maxY > minY ? rows / (maxY - minY) : 0;
    for (int i = 0; i < n; i++) {
      int column = Math.min(columns - 1, (int) ((points[2 * i] - minX) * scaleX));
      int row = Math.min(rows - 1, (int) ((points[2 * i + 1] - minY) * scaleY));
      int cell = column * rows + row;
      cellOf[i] = cell;
      cellStart[cell]++;
    }
    for (int c = 0; c < cells; c++) {
      cellStart[c + 1] += cellStart[c];
    }
    for (int i = n - 1; i >= 0; i--) {
      byCell[--cellStart[cellOf[i]]] = i;
    }
  }

  /** Makes strips of one column or, if that has too few distinct points, several. */
  private void makeStrips() {
    count = 0;
    stripCount = 0;
    repeatedCount = 0;
    int open = 0;
    stripStart[0] = 0;
    for (int column = 0; column < columns; column++) {
      int start = count;
      takeColumn(column);
      if (start > open) {
        SortedIndices.sort(siteOfRank, open, count, keyY, keyX, scratch);
      }
      if (count - open >= SMALLEST_STRIP) {
        stripStart[++stripCount] = count;
        open = count;
      }
    }
    if (stripCount == 0) {
      stripCount = 1;
    } else if (count > open) {
      SortedIndices.sort(siteOfRank, stripStart[stripCount - 1], count, keyY, keyX, scratch);
    }
    stripStart[stripCount] = count;
  }

  /** Appends the distinct points of a column in their order. */
  private void takeColumn(int column) {
    int first = column * rows;
    int start = cellStart[first];
    int end = cellStart[first + rows];
    for (int c = first; c < first + rows; c++) {
      if (cellStart[c + 1] - cellStart[c] > LARGE_CELL) {
        SortedIndices.sort(byCell, cellStart[c], cellStart[c + 1], keyY, keyX, scratch);
      }
    }
    SortedIndices.sortNearlySorted(byCell, start, end, keyY, keyX);
    int last = NONE;
    for (int k = start; k < end; k++) {
      int i = byCell[k];
      if (last != NONE && keyX[i] == keyX[last] && keyY[i] == keyY[last]) {
        repeated[repeatedCount] = i;
        repeats[repeatedCount++] = last;
      } else {
        siteOfRank[count++] = i;
        last = i;
      }
    }
  }
}
