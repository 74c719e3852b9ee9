package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Predicates;

/**
 * The faces of noded segments that lie inside the outline: its <em>pieces</em>.
 *
 * <p>Each segment is a pair of half-edges, h and {@code h ^ 1}. The edges out of a node are sorted
 * counter-clockwise by exact predicates; along a face, on the left, the edge after h is the
 * clockwise neighbour of its twin:
 *
 * <pre>
 *              o
 *             /
 *    left    / after h
 *           /
 *   o------o            ccw(h ^ 1) is the first edge reached
 *      h    \           turning counter-clockwise from h ^ 1
 * </pre>
 *
 * <p>Closed walks along faces are <em>cycles</em>; those that run counter-clockwise bound a face
 * from outside, the others are holes of the face around them. Cycles with an edge of the outline
 * know whether they are inside; others learn it from their neighbours.
 */
final class PlanarMap {
  private static final int NONE = -1;
  private static final byte UNKNOWN = 0;
  private static final byte INSIDE = 1;
  private static final byte OUTSIDE = 2;

  private Noder nodes;
  private double[] xy;
  private int halfEdgeCount;
  private int[] origin = new int[64];
  private int[] label = new int[64];
  private int[] outlineEdge = new int[64];
  private boolean[] interiorLeft = new boolean[64];
  private int[] ccw = new int[64];
  private int[] after = new int[64];
  private int[] cycle = new int[64];
  private int[] piece = new int[64];
  private int[] queue = new int[64];

  private int[] nodeStart = new int[1];
  private int[] fan = new int[64];

  private int cycleCount;
  private int[] cycleEdge = new int[64];
  private double[] cycleArea = new double[64];
  private byte[] state = new byte[64];
  private int[] pieceOfCycle = new int[64];
  private int pieceCount;

  /**
   * Builds the map of all segments of a noder; false if inside and outside cannot be told apart.
   */
  boolean build(Noder noder) {
    nodes = noder;
    xy = noder.coordinates();
    ensure(2 * noder.segmentCount(), noder.nodeCount());
    makeHalfEdges();
    sortFans();
    traceCycles();
    return spreadInside() && placeHoles() && numberPieces();
  }

  // ---- results ----

  int pieceCount() {
    return pieceCount;
  }

  int halfEdgeCount() {
    return halfEdgeCount;
  }

  int origin(int h) {
    return origin[h];
  }

  int destination(int h) {
    return origin[h ^ 1];
  }

  /** Next half-edge, counter-clockwise, out of the same node. */
  int ccw(int h) {
    return ccw[h];
  }

  /** Piece left of h, or -1 if that is outside or h is unused. */
  int piece(int h) {
    return piece[h];
  }

  /** Label of what is left of a half-edge that is not of the outline. */
  int label(int h) {
    return label[h];
  }

  /** Edge of the outline that h is part of, or -1 if it is a cut. */
  int outlineEdge(int h) {
    return outlineEdge[h];
  }

  double x(int node) {
    return xy[2 * node];
  }

  double y(int node) {
    return xy[2 * node + 1];
  }

  // ---- half-edges ----

  private void ensure(int edges, int nodeCount) {
    if (origin.length < edges) {
      int size = edges + edges / 2;
      origin = new int[size];
      label = new int[size];
      outlineEdge = new int[size];
      interiorLeft = new boolean[size];
      ccw = new int[size];
      after = new int[size];
      cycle = new int[size];
      piece = new int[size];
      queue = new int[size];
      fan = new int[size];
      cycleEdge = new int[size];
      cycleArea = new double[size];
      state = new byte[size];
      pieceOfCycle = new int[size];
    }
    if (nodeStart.length < nodeCount + 1) {
      nodeStart = new int[nodeCount + nodeCount / 2 + 1];
    }
  }

  private void makeHalfEdges() {
    int count = nodes.segmentCount();
    halfEdgeCount = 2 * count;
    Arrays.fill(nodeStart, 0, nodes.nodeCount() + 1, 0);
    for (int s = 0; s < count; s++) {
      int h = 2 * s;
      origin[h] = nodes.from(s);
      origin[h + 1] = nodes.to(s);
      label[h] = nodes.left(s);
      label[h + 1] = nodes.right(s);
      int edge = nodes.isOutline(s) ? nodes.left(s) : NONE;
      outlineEdge[h] = edge;
      outlineEdge[h + 1] = edge;
      interiorLeft[h] = true;
      interiorLeft[h + 1] = false;
      cycle[h] = NONE;
      cycle[h + 1] = NONE;
      nodeStart[origin[h]]++;
      nodeStart[origin[h + 1]]++;
    }
    for (int n = 0; n < nodes.nodeCount(); n++) {
      nodeStart[n + 1] += nodeStart[n];
    }
    for (int h = halfEdgeCount - 1; h >= 0; h--) {
      fan[--nodeStart[origin[h]]] = h;
    }
  }

  /**
   * Sorts the edges out of each node; of edges that coincide one is left, none if they are two of
   * the outline.
   */
  private void sortFans() {
    boolean coincident = false;
    for (int n = 0; n < nodes.nodeCount(); n++) {
      int start = nodeStart[n];
      int end = nodeStart[n + 1];
      if (end - start != 3 || !sortThree(start)) {
        sortFan(start, end);
      }
      for (int i = start + 1; i < end; i++) {
        coincident |= origin[fan[i] ^ 1] == origin[fan[i - 1] ^ 1];
      }
    }
    if (coincident) {
      dropCoincident();
    }
    for (int n = 0; n < nodes.nodeCount(); n++) {
      linkFan(nodeStart[n], nodeStart[n + 1]);
    }
  }

  /**
   * Sorts three edges up to the first one, which does not matter: in one of the two orders most
   * turns are counter-clockwise. False if that does not decide.
   */
  private boolean sortThree(int start) {
    int base = 2 * origin[fan[start]];
    int p = 2 * origin[fan[start] ^ 1];
    int q = 2 * origin[fan[start + 1] ^ 1];
    int r = 2 * origin[fan[start + 2] ^ 1];
    int turns = turn(base, p, q) + turn(base, q, r) + turn(base, r, p);
    if (turns < 0) {
      int swap = fan[start + 1];
      fan[start + 1] = fan[start + 2];
      fan[start + 2] = swap;
    }
    return turns != 0;
  }

  private int turn(int o, int p, int q) {
    return Predicates.orientation(xy[o], xy[o + 1], xy[p], xy[p + 1], xy[q], xy[q + 1]);
  }

  private void sortFan(int start, int end) {
    for (int i = start + 1; i < end; i++) {
      int h = fan[i];
      int j = i;
      while (j > start && comesBefore(h, fan[j - 1])) {
        fan[j] = fan[j - 1];
        j--;
      }
      fan[j] = h;
    }
  }

  private boolean comesBefore(int h, int k) {
    int d = origin[h ^ 1];
    int e = origin[k ^ 1];
    if (d == e) {
      // Coincident edges: the outline's first, so that dropCoincident keeps it.
      return outlineEdge[h] != NONE && outlineEdge[k] == NONE;
    }
    int halfH = lowerHalf(h);
    int halfK = lowerHalf(k);
    if (halfH != halfK) {
      return halfH < halfK;
    }
    return Predicates.orientation(xy, origin[h], d, e) > 0;
  }

  private int lowerHalf(int h) {
    double dy = y(origin[h ^ 1]) - y(origin[h]);
    double dx = x(origin[h ^ 1]) - x(origin[h]);
    return dy > 0 || (dy == 0 && dx > 0) ? 0 : 1;
  }

  private void dropCoincident() {
    for (int n = 0; n < nodes.nodeCount(); n++) {
      for (int i = nodeStart[n]; i + 1 < nodeStart[n + 1]; i++) {
        int h = fan[i];
        int k = fan[i + 1];
        if (origin[h ^ 1] == origin[k ^ 1] && origin[h] < origin[h ^ 1]) {
          boolean bothOutline = outlineEdge[h] != NONE && outlineEdge[k] != NONE;
          if (bothOutline) {
            drop(h);
            drop(k);
            i++;
          } else {
            drop(k);
            fan[i + 1] = h;
            fan[i] = k;
          }
        }
      }
    }
  }

  /** Marks a pair as dropped. */
  private void drop(int h) {
    cycle[h] = Integer.MIN_VALUE;
    cycle[h ^ 1] = Integer.MIN_VALUE;
  }

  private boolean isDropped(int h) {
    return cycle[h] == Integer.MIN_VALUE;
  }

  /** Makes the edges out of a node neighbours, and those that end there go on along faces. */
  private void linkFan(int start, int end) {
    int first = NONE;
    int last = NONE;
    for (int i = start; i < end; i++) {
      int h = fan[i];
      if (isDropped(h)) {
        continue;
      }
      if (first == NONE) {
        first = h;
      } else {
        link(last, h);
      }
      last = h;
    }
    if (first != NONE) {
      link(last, first);
    }
  }

  private void link(int h, int following) {
    ccw[h] = following;
    after[following ^ 1] = h;
  }

  // ---- cycles ----

  private void traceCycles() {
    cycleCount = 0;
    for (int h = 0; h < halfEdgeCount; h++) {
      if (cycle[h] != NONE) {
        continue;
      }
      double ox = x(origin[h]);
      double oy = y(origin[h]);
      double twiceArea = 0;
      int e = h;
      do {
        cycle[e] = cycleCount;
        int p = origin[e];
        int q = origin[e ^ 1];
        twiceArea += (x(p) - ox) * (y(q) - oy) - (y(p) - oy) * (x(q) - ox);
        e = after[e];
      } while (e != h);
      cycleEdge[cycleCount] = h;
      cycleArea[cycleCount] = 0.5 * twiceArea;
      state[cycleCount] = UNKNOWN;
      pieceOfCycle[cycleCount] = NONE;
      cycleCount++;
    }
  }

  /** From the outline's edges inwards and outwards across cuts; false on a contradiction. */
  private boolean spreadInside() {
    int end = 0;
    for (int h = 0; h < halfEdgeCount; h++) {
      if (isDropped(h) || outlineEdge[h] == NONE) {
        continue;
      }
      byte wanted = interiorLeft[h] ? INSIDE : OUTSIDE;
      if (state[cycle[h]] == UNKNOWN) {
        state[cycle[h]] = wanted;
        queue[end++] = cycle[h];
      } else if (state[cycle[h]] != wanted) {
        return false;
      }
    }
    spread(end);
    return true;
  }

  private void spread(int queued) {
    int end = queued;
    for (int k = 0; k < end; k++) {
      int first = cycleEdge[queue[k]];
      int e = first;
      do {
        int across = cycle[e ^ 1];
        if (outlineEdge[e] == NONE && state[across] == UNKNOWN) {
          state[across] = state[queue[k]];
          queue[end++] = across;
        }
        e = after[e];
      } while (e != first);
    }
  }

  /** Gives each hole cycle the piece around it, and cycles apart from the outline their state. */
  private boolean placeHoles() {
    for (int c = 0; c < cycleCount; c++) {
      if (cycleArea[c] <= 0 && state[c] == UNKNOWN) {
        int around = cycleAround(c);
        state[c] = around == NONE ? OUTSIDE : INSIDE;
        queue[0] = c;
        spread(1);
      }
    }
    return true;
  }

  private boolean numberPieces() {
    pieceCount = 0;
    for (int c = 0; c < cycleCount; c++) {
      if (state[c] == INSIDE && cycleArea[c] > 0) {
        pieceOfCycle[c] = pieceCount++;
      }
    }
    for (int c = 0; c < cycleCount; c++) {
      if (state[c] == INSIDE && cycleArea[c] <= 0) {
        int around = cycleAround(c);
        if (around == NONE) {
          return false;
        }
        pieceOfCycle[c] = pieceOfCycle[around];
      }
    }
    for (int h = 0; h < halfEdgeCount; h++) {
      piece[h] = isDropped(h) ? NONE : pieceOfCycle[cycle[h]];
    }
    return pieceCount > 0;
  }

  /** The smallest counter-clockwise cycle inside the outline around a cycle, or -1. */
  private int cycleAround(int c) {
    int node = origin[cycleEdge[c]];
    int best = NONE;
    for (int d = 0; d < cycleCount; d++) {
      if (d != c
          && state[d] == INSIDE
          && cycleArea[d] > 0
          && (best == NONE || cycleArea[d] < cycleArea[best])
          && surrounds(d, node)) {
        best = d;
      }
    }
    return best;
  }

  /**
   * Whether a node is strictly inside a cycle: edges that a ray to the right crosses, each owning
   * its lower end.
   */
  private boolean surrounds(int d, int node) {
    double px = x(node);
    double py = y(node);
    boolean inside = false;
    int first = cycleEdge[d];
    int e = first;
    do {
      int a = origin[e];
      int b = origin[e ^ 1];
      if (a == node) {
        return false;
      }
      if ((y(a) > py) != (y(b) > py)) {
        int side = Predicates.orientation(x(a), y(a), x(b), y(b), px, py);
        if ((side > 0) == (y(b) > y(a))) {
          inside = !inside;
        }
      }
      e = after[e];
    } while (e != first);
    return inside;
  }

  /** Next half-edge along the cycle of h. */
  int after(int h) {
    return after[h];
  }
}
