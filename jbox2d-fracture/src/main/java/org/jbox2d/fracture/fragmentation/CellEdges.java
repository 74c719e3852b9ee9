package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;

/**
 * Gives the edges of a Voronoi diagram to the {@link Noder}, as far as they can matter: an edge
 * counts only if the cell on one of its sides may overlap a region of effect. Cells may be united
 * to pieces: then edges between two cells of a piece do not count, and the others do if any cell of
 * the piece may overlap a region. The cells of a diagram do not meet each other but along edges, so
 * edges are added clean, unless rounding may have spoiled that: where edges of a cell come nearer
 * to each other than the noder tells apart, they are dirty.
 */
final class CellEdges {
  private VoronoiDiagram diagram;
  private double snap;
  private boolean[] matters = new boolean[0];
  private boolean[] doubtful = new boolean[0];
  private int[] node = new int[0];

  /** For each site the first one of its piece, which stands for it; itself if it is alone. */
  private int[] leader = new int[0];

  /**
   * Adds what matters.
   *
   * @param selection knows which sites the diagram has
   * @param cells know which cells may overlap a region
   * @param pieceOfSite for each site the number of its piece, negative for none; or null
   */
  void add(
      VoronoiDiagram voronoi,
      CellSelection selection,
      MatteringCells cells,
      int[] pieceOfSite,
      Noder noder,
      LocalFrame frame) {
    diagram = voronoi;
    snap = frame.snap();
    ensure();
    findLeaders(selection, pieceOfSite);
    for (int i = 0; i < diagram.siteCount(); i++) {
      matters[i] = cells.matters(i);
    }
    if (pieceOfSite != null) {
      spreadOverPieces();
    }
    Arrays.fill(doubtful, 0, diagram.vertexCount(), false);
    for (int i = 0; i < diagram.siteCount(); i++) {
      if (matters[i]) {
        doubt(i);
      }
    }
    Arrays.fill(node, 0, diagram.vertexCount(), -1);
    for (int e = 0; e < diagram.edgeCount(); e++) {
      int left = diagram.edgeLeft(e);
      int right = diagram.edgeRight(e);
      if ((matters[left] || matters[right]) && leader[left] != leader[right]) {
        addEdge(e, noder);
      }
    }
  }

  private void ensure() {
    if (matters.length < diagram.siteCount()) {
      matters = new boolean[2 * diagram.siteCount()];
      leader = new int[2 * diagram.siteCount()];
    }
    if (doubtful.length < diagram.vertexCount()) {
      doubtful = new boolean[2 * diagram.vertexCount()];
      node = new int[2 * diagram.vertexCount()];
    }
  }

  private void findLeaders(CellSelection selection, int[] pieceOfSite) {
    for (int i = 0; i < diagram.siteCount(); i++) {
      leader[i] = i;
    }
    if (pieceOfSite == null) {
      return;
    }
    Map<Integer, Integer> first = new HashMap<>();
    for (int i = 0; i < diagram.siteCount(); i++) {
      int piece = pieceOfSite[selection.site(i)];
      if (piece >= 0) {
        Integer earlier = first.putIfAbsent(piece, i);
        leader[i] = earlier == null ? i : earlier;
      }
    }
  }

  /** A cell matters if any of its piece does: the border of a piece must be whole. */
  private void spreadOverPieces() {
    for (int i = 0; i < diagram.siteCount(); i++) {
      matters[leader[i]] |= matters[i];
    }
    for (int i = 0; i < diagram.siteCount(); i++) {
      matters[i] = matters[leader[i]];
    }
  }

  /**
   * Marks corners of a cell that lie nearer than two snapping distances to the line of an edge next
   * to them.
   */
  private void doubt(int cell) {
    int start = diagram.cellStart(cell);
    int end = diagram.cellEnd(cell);
    if (end - start < 2) {
      return;
    }
    int a = diagram.cornerVertex(end - 2);
    int b = diagram.cornerVertex(end - 1);
    double ux = diagram.vertexX(b) - diagram.vertexX(a);
    double uy = diagram.vertexY(b) - diagram.vertexY(a);
    double uu = ux * ux + uy * uy;
    for (int k = start; k < end; k++) {
      int c = diagram.cornerVertex(k);
      double vx = diagram.vertexX(c) - diagram.vertexX(b);
      double vy = diagram.vertexY(c) - diagram.vertexY(b);
      double vv = vx * vx + vy * vy;
      double cross = ux * vy - uy * vx;
      if (cross <= 0 || cross * cross <= 4 * snap * snap * Math.max(uu, vv)) {
        doubtful[a] = true;
        doubtful[b] = true;
        doubtful[c] = true;
      }
      a = b;
      b = c;
      ux = vx;
      uy = vy;
      uu = vv;
    }
  }

  private void addEdge(int e, Noder noder) {
    int from = diagram.edgeFrom(e);
    int to = diagram.edgeTo(e);
    boolean dirty = doubtful[from] || doubtful[to];
    noder.addSegment(
        nodeOf(from, noder),
        nodeOf(to, noder),
        leader[diagram.edgeLeft(e)],
        leader[diagram.edgeRight(e)],
        false,
        dirty);
  }

  private int nodeOf(int vertex, Noder noder) {
    if (node[vertex] < 0) {
      node[vertex] = noder.addNode(diagram.vertexX(vertex), diagram.vertexY(vertex));
    }
    return node[vertex];
  }
}
