package org.jbox2d.fracture.fragmentation;

import java.util.List;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;

/**
 * Computes the cells that may overlap the regions of effect, from the sites near these.
 *
 * <p>With many sites only those in a rectangle around the regions are taken. A cell of the diagram
 * of these is the cell of the diagram of all sites if no other site is nearer to one of its
 * vertices than its own: that holds if the circle around each vertex through its site is inside the
 * rectangle. If it does not hold for a cell that may overlap a region, the rectangle grows. So the
 * cost follows the regions, and the result does not depend on the shortcut.
 */
final class CellSelection {
  /** Up to this number of sites the diagram of all is as cheap as a selection. */
  private static final int SELECT_ABOVE = 160;

  /** First margin of the rectangle, in units of the mean distance of neighbouring sites. */
  private static final double FIRST_MARGIN = 3;

  /** Growth of the margin. */
  private static final double GROWTH = 4;

  /**
   * Margin of the diagram's rectangle around the outline, in the local unit: its border never
   * touches the outline.
   */
  private static final double MARGIN = 0x1p-10;

  private LocalFrame frame;
  private double[] sites;
  private int siteCount;
  private double[] local = new double[0];
  private int[] selected = new int[0];
  private int selectedCount;
  private double minX;
  private double minY;
  private double maxX;
  private double maxY;

  /** Computes into {@code voronoi} the diagram, in local coordinates, of the sites that matter. */
  void compute(
      double[] allSites,
      int count,
      List<? extends RegionOfEffect> regions,
      LocalFrame localFrame,
      VoronoiDiagram voronoi) {
    frame = localFrame;
    sites = allSites;
    siteCount = count;
    if (local.length < 2 * count) {
      local = new double[3 * count];
      selected = new int[3 * count / 2 + 1];
    }
    double margin = Double.POSITIVE_INFINITY;
    if (!regions.isEmpty() && count > SELECT_ABOVE) {
      frameRegions(regions);
      margin = FIRST_MARGIN * meanDistance();
    }
    while (true) {
      select(margin);
      voronoi.compute(
          local,
          selectedCount,
          frame.minX() - MARGIN,
          frame.minY() - MARGIN,
          frame.maxX() + MARGIN,
          frame.maxY() + MARGIN);
      if (selectedCount == siteCount || isCertain(voronoi, margin)) {
        return;
      }
      margin *= GROWTH;
    }
  }

  /** Index, as given, of a site of the diagram. */
  int site(int ofDiagram) {
    return selected[ofDiagram];
  }

  /** Bounding box of all regions, in local coordinates. */
  private void frameRegions(List<? extends RegionOfEffect> regions) {
    minX = Double.POSITIVE_INFINITY;
    minY = Double.POSITIVE_INFINITY;
    maxX = Double.NEGATIVE_INFINITY;
    maxY = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < regions.size(); k++) {
      RegionOfEffect region = regions.get(k);
      minX = Math.min(minX, frame.toLocalX(region.minX()));
      maxX = Math.max(maxX, frame.toLocalX(region.maxX()));
      minY = Math.min(minY, frame.toLocalY(region.minY()));
      maxY = Math.max(maxY, frame.toLocalY(region.maxY()));
    }
  }

  /** Side of the square that each site would have for itself in the bounding box of all sites. */
  private double meanDistance() {
    double left = Double.POSITIVE_INFINITY;
    double low = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < siteCount; i++) {
      left = Math.min(left, sites[2 * i]);
      right = Math.max(right, sites[2 * i]);
      low = Math.min(low, sites[2 * i + 1]);
      high = Math.max(high, sites[2 * i + 1]);
    }
    double width = (right - left) * frame.scale();
    double height = (high - low) * frame.scale();
    double longer = Math.max(width, height);
    return Math.max(Math.sqrt(width * height / siteCount), longer / siteCount) + frame.snap();
  }

  private void select(double margin) {
    selectedCount = 0;
    for (int i = 0; i < siteCount; i++) {
      double x = frame.toLocalX(sites[2 * i]);
      double y = frame.toLocalY(sites[2 * i + 1]);
      if (margin == Double.POSITIVE_INFINITY
          || (x >= minX - margin
              && x <= maxX + margin
              && y >= minY - margin
              && y <= maxY + margin)) {
        local[2 * selectedCount] = x;
        local[2 * selectedCount + 1] = y;
        selected[selectedCount++] = i;
      }
    }
  }

  /** Whether every cell that may overlap a region is known to be a cell of all sites. */
  private boolean isCertain(VoronoiDiagram voronoi, double margin) {
    if (selectedCount == 0) {
      return false;
    }
    for (int i = 0; i < selectedCount; i++) {
      if (mayOverlap(voronoi, i) && !isCertain(voronoi, i, margin)) {
        return false;
      }
    }
    return true;
  }

  private boolean mayOverlap(VoronoiDiagram voronoi, int cell) {
    double left = Double.POSITIVE_INFINITY;
    double low = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int k = voronoi.cellStart(cell); k < voronoi.cellEnd(cell); k++) {
      int v = voronoi.cornerVertex(k);
      left = Math.min(left, voronoi.vertexX(v));
      right = Math.max(right, voronoi.vertexX(v));
      low = Math.min(low, voronoi.vertexY(v));
      high = Math.max(high, voronoi.vertexY(v));
    }
    return left <= maxX && right >= minX && low <= maxY && high >= minY;
  }

  private boolean isCertain(VoronoiDiagram voronoi, int cell, double margin) {
    double sx = local[2 * cell];
    double sy = local[2 * cell + 1];
    for (int k = voronoi.cellStart(cell); k < voronoi.cellEnd(cell); k++) {
      double x = voronoi.vertexX(voronoi.cornerVertex(k));
      double y = voronoi.vertexY(voronoi.cornerVertex(k));
      double radius = Math.sqrt((x - sx) * (x - sx) + (y - sy) * (y - sy));
      if (x - radius < minX - margin
          || x + radius > maxX + margin
          || y - radius < minY - margin
          || y + radius > maxY + margin) {
        return false;
      }
    }
    return true;
  }
}
