package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import java.util.List;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;

/**
 * Tells the cells of a diagram that may have something in common with a region of effect from those
 * that cannot break away whatever they are cut to. Without regions all cells matter.
 */
final class MatteringCells {
  private List<? extends RegionOfEffect> regions;
  private LocalFrame frame;

  private boolean[] matters = new boolean[0];

  /** For each vertex of the diagram the sides of a region that it is beyond. */
  private int[] beyond = new int[0];

  /** Takes up the regions for the diagrams to come. */
  void setRegions(List<? extends RegionOfEffect> ofEffect, LocalFrame localFrame) {
    regions = ofEffect;
    frame = localFrame;
  }

  /** Finds the cells of a diagram that matter. */
  void find(VoronoiDiagram diagram) {
    int sites = diagram.siteCount();
    if (matters.length < sites) {
      matters = new boolean[2 * sites];
    }
    if (regions.isEmpty()) {
      Arrays.fill(matters, 0, sites, true);
      return;
    }
    Arrays.fill(matters, 0, sites, false);
    if (beyond.length < diagram.vertexCount()) {
      beyond = new int[2 * diagram.vertexCount()];
    }
    for (int k = 0; k < regions.size(); k++) {
      find(diagram, regions.get(k));
    }
  }

  private void find(VoronoiDiagram diagram, RegionOfEffect region) {
    for (int v = 0; v < diagram.vertexCount(); v++) {
      double x = frame.toInputX(diagram.vertexX(v));
      double y = frame.toInputY(diagram.vertexY(v));
      beyond[v] = region.sidesBeyond(x, y);
    }
    for (int i = 0; i < diagram.siteCount(); i++) {
      // A cell without corners has all sides in common.
      int common = -1;
      for (int k = diagram.cellStart(i); k < diagram.cellEnd(i); k++) {
        common &= beyond[diagram.cornerVertex(k)];
      }
      matters[i] |= common == 0;
    }
  }

  /** Whether the cell of a site, in the last diagram, matters. */
  boolean matters(int site) {
    return matters[site];
  }
}
