package org.jbox2d.fracture.fragmentation;

import java.util.Arrays;
import java.util.List;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;

/**
 * Computes the cells that may overlap the regions of effect, from the sites near these.
 *
 * <p>Only sites in a rectangle around the part of the regions inside the outline are taken. A cell
 * of the diagram of these is the cell of the diagram of all sites if no other site is nearer to one
 * of its vertices than its own: if there is none in the circle around each vertex through its site.
 * Sites in such circles of cells that may overlap a region are taken as well, and the diagram is
 * computed anew, until there are none. So the cost follows the regions, and the cells do not depend
 * on the shortcut.
 */
final class CellSelection {
  /** Up to this number of sites the diagram of all is as cheap as a selection. */
  private static final int SELECT_ABOVE = 24;

  /** If more than this share of the sites is selected, all are. */
  private static final double MOST_SELECTED = 0.8;

  /** Diagrams of selected sites before that of all: each costs more than the one before. */
  private static final int MOST_ATTEMPTS = 3;

  /** Margin of the first rectangle, in units of the mean distance of neighbouring sites in it. */
  private static final double MARGIN_IN_DISTANCES = 2;

  /**
   * Circles are taken so much larger than they are, relative to the radius and to the extent of the
   * outline: far above rounding.
   */
  private static final double CIRCLE_MARGIN = 1e-9;

  /**
   * Margin of the diagram's rectangle around the outline, in the local unit: its border never
   * touches the outline.
   */
  private static final double MARGIN = 0x1p-10;

  private final MatteringCells cells;
  private LocalFrame frame;
  private double[] sites;
  private int siteCount;
  private double[] local = new double[0];
  private int[] selected = new int[0];
  private int selectedCount;
  private double[] rest = new double[0];
  private int[] restSite = new int[0];
  private int restCount;

  /** Vertices whose circles have been looked at. */
  private boolean[] seen = new boolean[0];

  /** What the regions and the rectangle of the diagram have in common. */
  private double minX;

  private double minY;
  private double maxX;
  private double maxY;

  /** The rectangle of the selected sites. */
  private double left;

  private double low;
  private double right;
  private double high;

  /**
   * A selection.
   *
   * @param cells will know, after each {@link #compute}, which cells matter
   */
  CellSelection(MatteringCells cells) {
    this.cells = cells;
  }

  /**
   * Computes into {@code voronoi} the diagram, in local coordinates, of the sites that matter.
   *
   * @param mayLeaveOut false if all sites matter
   */
  void compute(
      double[] allSites,
      int count,
      List<? extends RegionOfEffect> regions,
      boolean mayLeaveOut,
      LocalFrame localFrame,
      VoronoiDiagram voronoi) {
    frame = localFrame;
    sites = allSites;
    siteCount = count;
    if (local.length < 2 * count) {
      local = new double[3 * count];
      selected = new int[3 * count / 2 + 1];
      rest = new double[3 * count];
      restSite = new int[3 * count / 2 + 1];
    }
    cells.setRegions(regions, frame);
    if (mayLeaveOut && !regions.isEmpty() && count > SELECT_ABOVE && frameRegions(regions)) {
      frameSites();
      select();
      for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
        if (selectedCount > MOST_SELECTED * siteCount) {
          break;
        }
        compute(voronoi);
        if (selectedCount > 0 && !selectMore(voronoi)) {
          return;
        }
      }
    }
    selectAll();
    compute(voronoi);
  }

  private void compute(VoronoiDiagram voronoi) {
    voronoi.compute(
        local,
        selectedCount,
        frame.minX() - MARGIN,
        frame.minY() - MARGIN,
        frame.maxX() + MARGIN,
        frame.maxY() + MARGIN);
    cells.find(voronoi);
  }

  /** Index, as given, of a site of the diagram. */
  int site(int ofDiagram) {
    return selected[ofDiagram];
  }

  /**
   * Bounding box of all regions, in local coordinates, cut to the rectangle of the diagram; false
   * if that leaves nothing.
   */
  private boolean frameRegions(List<? extends RegionOfEffect> regions) {
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
    minX = Math.max(minX, frame.minX() - MARGIN);
    maxX = Math.min(maxX, frame.maxX() + MARGIN);
    minY = Math.max(minY, frame.minY() - MARGIN);
    maxY = Math.min(maxY, frame.maxY() + MARGIN);
    return minX < maxX && minY < maxY;
  }

  /** Chooses the first rectangle: that of the regions with a margin. */
  private void frameSites() {
    left = minX;
    low = minY;
    right = maxX;
    high = maxY;
    // Half of the square that each site in the rectangle would have for itself.
    double spacing = Math.sqrt((right - left) * (high - low) / (countSelected() + 1));
    double margin = MARGIN_IN_DISTANCES * spacing;
    left -= margin;
    low -= margin;
    right += margin;
    high += margin;
  }

  private int countSelected() {
    int count = 0;
    for (int i = 0; i < siteCount; i++) {
      double x = frame.toLocalX(sites[2 * i]);
      double y = frame.toLocalY(sites[2 * i + 1]);
      count += x >= left & x <= right & y >= low & y <= high ? 1 : 0;
    }
    return count;
  }

  private void select() {
    selectedCount = 0;
    restCount = 0;
    for (int i = 0; i < siteCount; i++) {
      double x = frame.toLocalX(sites[2 * i]);
      double y = frame.toLocalY(sites[2 * i + 1]);
      int inside = x >= left & x <= right & y >= low & y <= high ? 1 : 0;
      local[2 * selectedCount] = x;
      local[2 * selectedCount + 1] = y;
      selected[selectedCount] = i;
      selectedCount += inside;
      rest[2 * restCount] = x;
      rest[2 * restCount + 1] = y;
      restSite[restCount] = i;
      restCount += 1 - inside;
    }
  }

  private void selectAll() {
    selectedCount = siteCount;
    for (int i = 0; i < siteCount; i++) {
      local[2 * i] = frame.toLocalX(sites[2 * i]);
      local[2 * i + 1] = frame.toLocalY(sites[2 * i + 1]);
      selected[i] = i;
    }
  }

  /** Selects the sites in circles of cells that may overlap a region; whether there were any. */
  private boolean selectMore(VoronoiDiagram voronoi) {
    int before = selectedCount;
    if (seen.length < voronoi.vertexCount()) {
      seen = new boolean[2 * voronoi.vertexCount()];
    }
    Arrays.fill(seen, 0, voronoi.vertexCount(), false);
    for (int i = 0; i < before; i++) {
      if (cells.matters(i)) {
        selectMore(voronoi, i);
      }
    }
    return selectedCount > before;
  }

  /** The circle around a vertex goes through the sites of all cells that meet there. */
  private void selectMore(VoronoiDiagram voronoi, int cell) {
    double sx = local[2 * cell];
    double sy = local[2 * cell + 1];
    for (int k = voronoi.cellStart(cell); k < voronoi.cellEnd(cell); k++) {
      int v = voronoi.cornerVertex(k);
      if (seen[v]) {
        continue;
      }
      seen[v] = true;
      double x = voronoi.vertexX(v);
      double y = voronoi.vertexY(v);
      double squared = (x - sx) * (x - sx) + (y - sy) * (y - sy);
      double radius = Math.sqrt(squared);
      if (x - radius < left | x + radius > right | y - radius < low | y + radius > high) {
        selectInCircle(x, y, squared * (1 + CIRCLE_MARGIN));
      }
    }
  }

  private void selectInCircle(double x, double y, double squaredRadius) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < restCount; i++) {
      double dx = rest[2 * i] - x;
      double dy = rest[2 * i + 1] - y;
      double squared = dx * dx + dy * dy;
      nearest = squared < nearest ? squared : nearest;
    }
    if (nearest > squaredRadius) {
      return;
    }
    int kept = 0;
    for (int i = 0; i < restCount; i++) {
      double px = rest[2 * i];
      double py = rest[2 * i + 1];
      if ((px - x) * (px - x) + (py - y) * (py - y) <= squaredRadius) {
        local[2 * selectedCount] = px;
        local[2 * selectedCount + 1] = py;
        selected[selectedCount++] = restSite[i];
      } else {
        rest[2 * kept] = px;
        rest[2 * kept + 1] = py;
        restSite[kept++] = restSite[i];
      }
    }
    restCount = kept;
  }
}
