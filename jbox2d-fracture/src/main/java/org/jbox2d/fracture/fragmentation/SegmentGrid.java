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
  private int[] stamp = new int[64];
  private int mark;
  private int[] found = new int[64];

  /** Takes up segments; the arrays are kept until the next call. */
  void build(double[] coordinates, int[] segmentFrom, int[] segmentTo, int count, double by) {
    xy = coordinates;
    from = segmentFrom;
    to = segmentTo;
    margin = by;
    if (stamp.length < count) {
      stamp = new int[2 * count];
      found = new int[2 * count];
    }
    Arrays.fill(stamp, 0, count, 0);
    mark = 0;
    frame(count);
    int cells = side * side;
    if (start.length < cells + 1) {
      start = new int[cells + 1];
    }
    Arrays.fill(start, 0, cells + 1, 0);
    countOrFill(count, false);
    for (int c = 0; c < cells; c++) {
      start[c + 1] += start[c];
    }
    if (item.length < start[cells]) {
      item = new int[start[cells] + start[cells] / 2];
    }
    countOrFill(count, true);
  }

  private void frame(int count) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int s = 0; s < count; s++) {
      minX = Math.min(minX, minX(s));
      maxX = Math.max(maxX, maxX(s));
      minY = Math.min(minY, minY(s));
      maxY = Math.max(maxY, maxY(s));
    }
    side = Math.max(1, Math.min(MAXIMUM_SIDE, (int) Math.sqrt(count)));
    originX = minX;
    originY = minY;
    scaleX = side / (maxX - minX);
    scaleY = side / (maxY - minY);
  }

  private double minX(int s) {
    return Math.min(xy[2 * from[s]], xy[2 * to[s]]) - margin;
  }

  private double maxX(int s) {
    return Math.max(xy[2 * from[s]], xy[2 * to[s]]) + margin;
  }

  private double minY(int s) {
    return Math.min(xy[2 * from[s] + 1], xy[2 * to[s] + 1]) - margin;
  }

  private double maxY(int s) {
    return Math.max(xy[2 * from[s] + 1], xy[2 * to[s] + 1]) + margin;
  }

  /**
   * First pass: counts the items of each bucket at its own index; the sums are then the ends of the
   * buckets. Second pass: fills each from its end, which turns the ends into starts.
   */
  private void countOrFill(int count, boolean fill) {
    for (int s = count - 1; s >= 0; s--) {
      int x0 = column(minX(s));
      int x1 = column(maxX(s));
      int y0 = row(minY(s));
      int y1 = row(maxY(s));
      for (int r = y0; r <= y1; r++) {
        for (int c = x0; c <= x1; c++) {
          if (fill) {
            item[--start[r * side + c]] = s;
          } else {
            start[r * side + c]++;
          }
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

  /** Finds the segments near s, s not among them; returns their number. */
  int query(int s) {
    stamp[s] = ++mark;
    return query(minX(s), maxX(s), minY(s), maxY(s));
  }

  /** Finds the segments near a point; returns their number. */
  int query(double x, double y) {
    mark++;
    return query(x - margin, x + margin, y - margin, y + margin);
  }

  private int query(double minX, double maxX, double minY, double maxY) {
    int count = 0;
    int c1 = column(maxX);
    int r1 = row(maxY);
    for (int r = row(minY); r <= r1; r++) {
      for (int c = column(minX); c <= c1; c++) {
        int cell = r * side + c;
        for (int k = start[cell]; k < start[cell + 1]; k++) {
          int t = item[k];
          if (stamp[t] != mark) {
            stamp[t] = mark;
            if (maxX(t) >= minX && minX(t) <= maxX && maxY(t) >= minY && minY(t) <= maxY) {
              found[count++] = t;
            }
          }
        }
      }
    }
    return count;
  }

  /** Segment k of those the last query found. */
  int found(int k) {
    return found[k];
  }
}
