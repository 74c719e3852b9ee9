package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;

/**
 * Follows the boundaries of classes of pieces and makes outlines of them.
 *
 * <p>A half-edge bounds its class if the class on its other side is another. At its end the
 * boundary goes on with the first half-edge counter-clockwise from its twin that has the class on
 * its left. That turns through what is not of the class, so a class that touches itself in a node
 * gets an outer ring and a hole that meet there, never a ring that visits the node twice:
 *
 * <pre>
 *    class \  other / class
 *           \      /
 *         h  \    /  next
 *             v  /
 *              o
 * </pre>
 *
 * <p>Nodes that were put on an edge of the outline, but where no boundary branches off, are left
 * out again.
 */
final class RingTracer {
  private static final int NONE = -1;

  private PlanarMap map;

  /** For each half-edge the class on its left, {@link #NONE} outside and for unused ones. */
  private int[] classLeft = new int[64];

  private boolean[] visited = new boolean[64];
  private int nodeEnd;
  private int[] node = new int[64];
  private int ringCount;
  private int[] ringStart = new int[17];
  private double[] ringArea = new double[16];
  private int[] firstRing = new int[16];
  private int[] nextRing = new int[16];

  /**
   * Traces all boundaries.
   *
   * @param classes class of each piece, 0 to classCount - 1, or -1 for pieces that do not matter
   * @param keptNodes nodes below this are never left out
   */
  void trace(PlanarMap planarMap, int[] classes, int classCount, int keptNodes) {
    map = planarMap;
    ensure(classCount);
    for (int h = 0; h < map.halfEdgeCount(); h++) {
      int piece = map.piece(h);
      classLeft[h] = piece == NONE ? NONE : classes[piece];
    }
    Arrays.fill(visited, 0, map.halfEdgeCount(), false);
    Arrays.fill(firstRing, 0, classCount, NONE);
    ringCount = 0;
    nodeEnd = 0;
    ringStart[0] = 0;
    for (int h = 0; h < map.halfEdgeCount(); h++) {
      if (!visited[h] && isBoundary(h) && classLeft[h] != NONE) {
        traceRing(h, keptNodes);
      }
    }
  }

  private void ensure(int classCount) {
    if (visited.length < map.halfEdgeCount()) {
      visited = new boolean[2 * map.halfEdgeCount()];
      classLeft = new int[2 * map.halfEdgeCount()];
      node = new int[2 * map.halfEdgeCount()];
    }
    if (firstRing.length < classCount) {
      firstRing = new int[2 * classCount];
    }
  }

  /** An unused half-edge has no class on either side. */
  private boolean isBoundary(int h) {
    return classLeft[h] != classLeft[h ^ 1];
  }

  private void traceRing(int first, int keptNodes) {
    int ringsClass = classLeft[first];
    int start = nodeEnd;
    int h = first;
    do {
      visited[h] = true;
      int n = map.origin(h);
      if (n < keptNodes || isCorner(h)) {
        node[nodeEnd++] = n;
      }
      int e = map.ccw(h ^ 1);
      while (classLeft[e] != ringsClass || !isBoundary(e)) {
        e = map.ccw(e);
      }
      h = e;
    } while (h != first);
    addRing(ringsClass, start);
  }

  /** Whether the boundary branches or leaves the edge of the outline at the origin of h. */
  private boolean isCorner(int h) {
    int edge = map.outlineEdge(h);
    if (edge == NONE) {
      return true;
    }
    for (int e = map.ccw(h); e != h; e = map.ccw(e)) {
      if (isBoundary(e) && map.outlineEdge(e) != edge) {
        return true;
      }
    }
    return false;
  }

  private void addRing(int ringsClass, int start) {
    if (ringCount == ringArea.length) {
      int size = 2 * ringCount;
      ringStart = Arrays.copyOf(ringStart, size + 1);
      ringArea = Arrays.copyOf(ringArea, size);
      nextRing = Arrays.copyOf(nextRing, size);
    }
    ringArea[ringCount] = signedArea(start, nodeEnd);
    int head = firstRing[ringsClass];
    if (head == NONE || ringArea[ringCount] > 0) {
      // The outer ring goes first.
      nextRing[ringCount] = head;
      firstRing[ringsClass] = ringCount;
    } else {
      nextRing[ringCount] = nextRing[head];
      nextRing[head] = ringCount;
    }
    ringCount++;
    ringStart[ringCount] = nodeEnd;
  }

  private double signedArea(int start, int end) {
    double twice = 0;
    for (int i = start + 1; i + 1 < end; i++) {
      double ox = map.x(node[start]);
      double oy = map.y(node[start]);
      double px = map.x(node[i]) - ox;
      double py = map.y(node[i]) - oy;
      twice += px * (map.y(node[i + 1]) - oy) - py * (map.x(node[i + 1]) - ox);
    }
    return 0.5 * twice;
  }

  /** Whether a class has exactly one outer ring, and no ring of fewer than three nodes. */
  boolean isSound(int traced) {
    int outer = 0;
    for (int r = firstRing[traced]; r != NONE; r = nextRing[r]) {
      if (ringStart[r + 1] - ringStart[r] < 3) {
        return false;
      }
      outer += ringArea[r] > 0 ? 1 : 0;
    }
    return outer == 1;
  }

  /** The outline of a class; {@code coordinates} are those of the nodes in the result. */
  Outline outline(int traced, double[] coordinates) {
    int rings = 0;
    int nodes = 0;
    for (int r = firstRing[traced]; r != NONE; r = nextRing[r]) {
      rings++;
      nodes += ringStart[r + 1] - ringStart[r];
    }
    double[] xy = new double[2 * nodes];
    int[] starts = new int[rings + 1];
    int k = 0;
    int count = 0;
    for (int r = firstRing[traced]; r != NONE; r = nextRing[r]) {
      for (int i = ringStart[r]; i < ringStart[r + 1]; i++) {
        xy[2 * k] = coordinates[2 * node[i]];
        xy[2 * k + 1] = coordinates[2 * node[i] + 1];
        k++;
      }
      starts[++count] = k;
    }
    return new Outline(xy, starts);
  }
}
