package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;

/**
 * Uniform grid of buckets that finds the segments whose bounding boxes, enlarged by a margin,
 * overlap that of a given one. Owns its arrays and reuses them.
 */
final class SegmentGrid {
  /** Side of the grid never exceeds this: a quarter million buckets. */
  private static final int MAXIMUM_SIDE = 512;

  private double[] xy;
  private int[] from;
  private int[] to;
  private double margin;
  private int side;
  private double originX;
  private double originY;
  private double scaleX;
  private double scaleY;
  private int[] start = new int[2];
  private int[] item = new int[64];

  /** First and last column and row of each segment, in this order. */
  private int[] range = new int[256];

  /** Boxes of the segments, enlarged by the margin: left, lower, right, upper end. */
  private double[] box = new double[256];

  private int[] stamp = new int[64];
  private int mark;
  private int[] found = new int[64];

  /** Takes up segments; the arrays are kept until the next call. */
  void build(double[] coordinates, int[] origins, int[] ends, int count, double by) {
    xy = coordinates;
    from = origins;
    to = ends;
    margin = by;
    if (stamp.length < count) {
      stamp = new int[2 * count];
      found = new int[2 * count];
      range = new int[8 * count];
      box = new double[8 * count];
    }
    Arrays.fill(stamp, 0, count, 0);
    mark = 0;
    frame(count);
    int cells = side * side;
    if (start.length < cells + 1) {
      start = new int[cells + 1];
    }
    Arrays.fill(start, 0, cells + 1, 0);
    countSegments(count);
    for (int c = 0; c < cells; c++) {
      start[c + 1] += start[c];
    }
    if (item.length < start[cells]) {
      item = new int[start[cells] + start[cells] / 2];
    }
    for (int s = count - 1; s >= 0; s--) {
      for (int r = range[4 * s + 2]; r <= range[4 * s + 3]; r++) {
        for (int c = range[4 * s]; c <= range[4 * s + 1]; c++) {
          item[--start[r * side + c]] = s;
        }
      }
    }
  }

  private void frame(int count) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int s = 0; s < count; s++) {
      double ax = xy[2 * from[s]];
      double ay = xy[2 * from[s] + 1];
      double bx = xy[2 * to[s]];
      double by = xy[2 * to[s] + 1];
      box[4 * s] = Math.min(ax, bx) - margin;
      box[4 * s + 1] = Math.min(ay, by) - margin;
      box[4 * s + 2] = Math.max(ax, bx) + margin;
      box[4 * s + 3] = Math.max(ay, by) + margin;
      minX = Math.min(minX, box[4 * s]);
      minY = Math.min(minY, box[4 * s + 1]);
      maxX = Math.max(maxX, box[4 * s + 2]);
      maxY = Math.max(maxY, box[4 * s + 3]);
    }
    side = Math.max(1, Math.min(MAXIMUM_SIDE, (int) Math.sqrt(count)));
    originX = minX;
    originY = minY;
    scaleX = side / (maxX - minX);
    scaleY = side / (maxY - minY);
  }

  /**
   * Counts the items of each bucket at its own index; the sums are then the ends of the buckets,
   * and filling each from its end turns the ends into starts.
   */
  private void countSegments(int count) {
    for (int s = 0; s < count; s++) {
      int x0 = column(box[4 * s]);
      int x1 = column(box[4 * s + 2]);
      int y0 = row(box[4 * s + 1]);
      int y1 = row(box[4 * s + 3]);
      range[4 * s] = x0;
      range[4 * s + 1] = x1;
      range[4 * s + 2] = y0;
      range[4 * s + 3] = y1;
      for (int r = y0; r <= y1; r++) {
        for (int c = x0; c <= x1; c++) {
          start[r * side + c]++;
        }
      }
    }
  }

  private int column(double x) {
    return Math.max(0, Math.min(side - 1, (int) ((x - originX) * scaleX)));
  }

  private int row(double y) {
    return Math.max(0, Math.min(side - 1, (int) ((y - originY) * scaleY)));
  }

  /**
   * Finds the segments near s, s not among them; returns their number. Their order is that of the
   * first bucket that both are in, row by row, then of their numbers.
   */
  int query(int s) {
    stamp[s] = ++mark;
    int c0 = range[4 * s];
    int c1 = range[4 * s + 1];
    int r0 = range[4 * s + 2];
    int r1 = range[4 * s + 3];
    if (c1 - c0 < 2 || r1 - r0 < 2) {
      return query(box[4 * s], box[4 * s + 2], box[4 * s + 1], box[4 * s + 3]);
    }
    int count = queryAlong(s);
    sortFound(s, count);
    return count;
  }

  /**
   * Looks only into the buckets that a long segment passes: row by row, from where it comes into
   * the row to where it leaves it. What is not there may overlap the box of s, but is farther from
   * s than the margin.
   */
  private int queryAlong(int s) {
    double ax = xy[2 * from[s]];
    double ay = xy[2 * from[s] + 1];
    double bx = xy[2 * to[s]];
    double by = xy[2 * to[s] + 1];
    double low = Math.min(ay, by);
    double high = Math.max(ay, by);
    double slope = (bx - ax) / (by - ay);
    double height = 1 / scaleY;
    double minX = box[4 * s];
    double minY = box[4 * s + 1];
    double maxX = box[4 * s + 2];
    double maxY = box[4 * s + 3];
    int count = 0;
    for (int r = range[4 * s + 2]; r <= range[4 * s + 3]; r++) {
      double floor = originY + r * height;
      double xLow = ax + slope * (Math.max(low, floor - 2 * margin) - ay);
      double xHigh = ax + slope * (Math.min(high, floor + height + 2 * margin) - ay);
      int c0 = column(Math.min(xLow, xHigh) - 2 * margin);
      int c1 = column(Math.max(xLow, xHigh) + 2 * margin);
      count = queryRow(r, c0, c1, minX, maxX, minY, maxY, count);
    }
    return count;
  }

  /**
   * Adds to the first {@code before} found those segments of the buckets c0 to c1 of a row, which
   * lie one after the other, whose boxes meet a box; returns how many are found then.
   */
  private int queryRow(
      int r, int c0, int c1, double minX, double maxX, double minY, double maxY, int before) {
    int count = before;
    int end = start[r * side + c1 + 1];
    for (int k = start[r * side + c0]; k < end; k++) {
      int t = item[k];
      if (stamp[t] != mark) {
        stamp[t] = mark;
        if (box[4 * t + 2] >= minX
            & box[4 * t] <= maxX
            & box[4 * t + 3] >= minY
            & box[4 * t + 1] <= maxY) {
          found[count++] = t;
        }
      }
    }
    return count;
  }

  private void sortFound(int s, int count) {
    for (int i = 1; i < count; i++) {
      int t = found[i];
      int bucket = firstCommon(s, t);
      int j = i;
      while (j > 0 && isLater(found[j - 1], s, bucket, t)) {
        found[j] = found[j - 1];
        j--;
      }
      found[j] = t;
    }
  }

  private boolean isLater(int other, int s, int bucket, int t) {
    int others = firstCommon(s, other);
    return others > bucket || (others == bucket && other > t);
  }

  /** The first bucket that the boxes of two segments have in common. */
  private int firstCommon(int s, int t) {
    return Math.max(range[4 * s + 2], range[4 * t + 2]) * side
        + Math.max(range[4 * s], range[4 * t]);
  }

  /** Finds the segments near a point; returns their number. */
  int query(double x, double y) {
    mark++;
    return query(x - margin, x + margin, y - margin, y + margin);
  }

  private int query(double minX, double maxX, double minY, double maxY) {
    int count = 0;
    int c0 = column(minX);
    int c1 = column(maxX);
    int r1 = row(maxY);
    for (int r = row(minY); r <= r1; r++) {
      count = queryRow(r, c0, c1, minX, maxX, minY, maxY, count);
    }
    return count;
  }

  /** Segment k of those the last query found. */
  int found(int k) {
    return found[k];
  }
}
