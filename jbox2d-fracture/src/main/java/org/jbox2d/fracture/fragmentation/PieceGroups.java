package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.SortedIndices;

/**
 * Pieces of a {@link PlanarMap} united into groups. A group is named by its least piece. Owns its
 * arrays and reuses them.
 */
final class PieceGroups {
  private static final int NONE = -1;

  private PlanarMap map;
  private int pieceCount;
  private int[] parent = new int[16];
  private int[] nextMember = new int[16];
  private int[] lastMember = new int[16];
  private double[] area = new double[16];
  private double[] perimeter = new double[16];
  private int[] edgeStart = new int[17];
  private int[] edge = new int[64];
  private double[] shared = new double[16];
  private int[] touched = new int[16];
  private int[] order = new int[16];
  private int[] scratch = new int[16];

  /** Makes a group of each piece. */
  void build(PlanarMap planarMap) {
    map = planarMap;
    pieceCount = map.pieceCount();
    ensure();
    Arrays.fill(edgeStart, 0, pieceCount + 1, 0);
    for (int p = 0; p < pieceCount; p++) {
      parent[p] = p;
      nextMember[p] = NONE;
      lastMember[p] = p;
      area[p] = 0;
      perimeter[p] = 0;
      shared[p] = 0;
    }
    for (int h = 0; h < map.halfEdgeCount(); h++) {
      if (map.piece(h) != NONE) {
        edgeStart[map.piece(h)]++;
      }
    }
    for (int p = 0; p < pieceCount; p++) {
      edgeStart[p + 1] += edgeStart[p];
    }
    for (int h = map.halfEdgeCount() - 1; h >= 0; h--) {
      if (map.piece(h) != NONE) {
        edge[--edgeStart[map.piece(h)]] = h;
      }
    }
    for (int p = 0; p < pieceCount; p++) {
      measureArea(p);
    }
    measurePerimeters();
  }

  private void ensure() {
    if (parent.length < pieceCount) {
      int size = 2 * pieceCount;
      parent = new int[size];
      nextMember = new int[size];
      lastMember = new int[size];
      area = new double[size];
      perimeter = new double[size];
      edgeStart = new int[size + 1];
      shared = new double[size];
      touched = new int[size];
      order = new int[size];
      scratch = new int[size];
    }
    if (edge.length < map.halfEdgeCount()) {
      edge = new int[2 * map.halfEdgeCount()];
    }
  }

  private void measureArea(int p) {
    int base = map.origin(edge[edgeStart[p]]);
    double baseX = map.x(base);
    double baseY = map.y(base);
    for (int k = edgeStart[p]; k < edgeStart[p + 1]; k++) {
      int a = map.origin(edge[k]);
      int b = map.destination(edge[k]);
      double ax = map.x(a) - baseX;
      double ay = map.y(a) - baseY;
      double bx = map.x(b) - baseX;
      double by = map.y(b) - baseY;
      area[p] += 0.5 * (ax * by - ay * bx);
    }
  }

  /** Each edge between pieces counts for both. */
  private void measurePerimeters() {
    for (int h = 0; h < map.halfEdgeCount(); h += 2) {
      int p = map.piece(h);
      int q = map.piece(h + 1);
      if (p != q) {
        double length = length(h);
        if (p != NONE) {
          perimeter[p] += length;
        }
        if (q != NONE) {
          perimeter[q] += length;
        }
      }
    }
  }

  int pieceCount() {
    return pieceCount;
  }

  /** Group of a piece. */
  int group(int piece) {
    int r = piece;
    while (parent[r] != r) {
      parent[r] = parent[parent[r]];
      r = parent[r];
    }
    return r;
  }

  /** Area of a group. */
  double area(int group) {
    return area[group];
  }

  /** Piece after this one in the same group, or -1; the first is the group itself. */
  int nextMember(int piece) {
    return nextMember[piece];
  }

  /** Place of the first half-edge of a piece, for {@link #edge}. */
  int edgeStart(int piece) {
    return edgeStart[piece];
  }

  int edgeEnd(int piece) {
    return edgeStart[piece + 1];
  }

  int edge(int k) {
    return edge[k];
  }

  /** Group on the other side of h, or -1 for the outside. */
  int acrossGroup(int h) {
    int p = map.piece(h ^ 1);
    return p == NONE ? NONE : group(p);
  }

  double length(int h) {
    double dx = map.x(map.destination(h)) - map.x(map.origin(h));
    double dy = map.y(map.destination(h)) - map.y(map.origin(h));
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Unites two groups; returns the united one. */
  int unite(int g, int h) {
    int keep = Math.min(g, h);
    int gone = Math.max(g, h);
    if (keep != gone) {
      parent[gone] = keep;
      nextMember[lastMember[keep]] = gone;
      lastMember[keep] = lastMember[gone];
      area[keep] += area[gone];
    }
    return keep;
  }

  /**
   * Merges each group that is too small, the smallest first, into the neighbour with the longest
   * shared edges; one without a neighbour stays.
   */
  void mergeSmall(double leastArea, double leastWidth) {
    boolean merged = true;
    while (merged) {
      merged = false;
      int small = 0;
      for (int p = 0; p < pieceCount; p++) {
        if (parent[p] == p && isSmall(p, leastArea, leastWidth)) {
          order[small++] = p;
        }
      }
      SortedIndices.sort(order, small, area, area, scratch);
      for (int k = 0; k < small; k++) {
        int g = group(order[k]);
        if (isSmall(g, leastArea, leastWidth)) {
          merged |= mergeIntoNeighbour(g);
        }
      }
    }
  }

  private boolean isSmall(int g, double leastArea, double leastWidth) {
    return area[g] < leastArea || 2 * area[g] < leastWidth * perimeter[g];
  }

  private boolean mergeIntoNeighbour(int g) {
    int touchedCount = 0;
    for (int p = g; p != NONE; p = nextMember[p]) {
      for (int k = edgeStart[p]; k < edgeStart[p + 1]; k++) {
        int other = acrossGroup(edge[k]);
        if (other != NONE && other != g) {
          if (shared[other] == 0) {
            touched[touchedCount++] = other;
          }
          shared[other] += length(edge[k]);
        }
      }
    }
    int best = NONE;
    for (int k = 0; k < touchedCount; k++) {
      int t = touched[k];
      if (best == NONE || shared[t] > shared[best] || (shared[t] == shared[best] && t < best)) {
        best = t;
      }
    }
    if (best != NONE) {
      double united = perimeter[g] + perimeter[best] - 2 * shared[best];
      perimeter[unite(g, best)] = united;
    }
    for (int k = 0; k < touchedCount; k++) {
      shared[touched[k]] = 0;
    }
    return best != NONE;
  }
}
