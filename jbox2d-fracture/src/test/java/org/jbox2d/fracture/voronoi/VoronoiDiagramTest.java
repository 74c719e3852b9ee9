package org.jbox2d.fracture.voronoi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class VoronoiDiagramTest {
  /** Cases of each kind in a normal build; -Dgeometry.cases=N for more. */
  private static final int CASES = Integer.getInteger("geometry.cases", 2000);

  /** Seed of the first case, to run others than usual: -Dgeometry.first=N. */
  private static final int FIRST = Integer.getInteger("geometry.first", 0);

  private static void check(
      VoronoiDiagram diagram, double[] sites, int n, double x0, double y0, double x1, double y1) {
    double[] before = sites.clone();
    diagram.compute(sites, n, x0, y0, x1, y1);
    org.junit.jupiter.api.Assertions.assertArrayEquals(before, sites);
    assertNull(diagram.validate());
    Random random = new Random(n);
    for (int k = 0; k < 20 && n > 0; k++) {
      double px = x0 + random.nextDouble() * (x1 - x0);
      double py = y0 + random.nextDouble() * (y1 - y0);
      int nearest = 0;
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < n; i++) {
        double distance = Math.hypot(sites[2 * i] - px, sites[2 * i + 1] - py);
        if (distance < least) {
          least = distance;
          nearest = i;
        }
      }
      double extent = Math.max(x1 - x0, y1 - y0);
      int cell = diagram.representative(nearest);
      assertTrue(insideCell(diagram, cell, px, py, extent), "nearest site's cell holds the point");
    }
  }

  private static boolean insideCell(
      VoronoiDiagram diagram, int cell, double px, double py, double extent) {
    int start = diagram.cellStart(cell);
    int size = diagram.cellEnd(cell) - start;
    for (int k = 0; k < size; k++) {
      int a = diagram.cornerVertex(start + k);
      int b = diagram.cornerVertex(start + (k + 1) % size);
      double ux = diagram.vertexX(b) - diagram.vertexX(a);
      double uy = diagram.vertexY(b) - diagram.vertexY(a);
      double wx = px - diagram.vertexX(a);
      double wy = py - diagram.vertexY(a);
      // An edge between vertices that are one but for their rounding has no direction.
      double rounding = 8 * Math.ulp(Math.abs(px) + Math.abs(py) + extent);
      double length = Math.hypot(ux, uy);
      if (length > rounding && ux * wy - uy * wx < -1e-8 * extent * length) {
        return false;
      }
    }
    return size > 0;
  }

  @ParameterizedTest
  @EnumSource(SiteKind.class)
  void isAPartitionForEveryKindOfSites(SiteKind kind) {
    VoronoiDiagram diagram = new VoronoiDiagram();
    int[] counts = {0, 1, 2, 3, 4, 5, 7, 10, 16, 33, 64, 100, 256, 1000};
    double[] scales = {1e-6, 1e-3, 1, 1e3, 1e6};
    double[] offsets = {0, 0, 1, 1e4, 1e6};
    for (int seed = FIRST; seed < FIRST + CASES; seed++) {
      Random random = new Random(31L * seed + kind.ordinal());
      int n = counts[random.nextInt(seed % 50 > 0 ? counts.length - 2 : counts.length)];
      double scale = scales[random.nextInt(scales.length)];
      double offset = offsets[random.nextInt(offsets.length)] * scale;
      double[] sites = kind.make(random, n);
      for (int i = 0; i < 2 * n; i++) {
        sites[i] = (float) (sites[i] * scale + offset);
      }
      check(diagram, sites, n, offset - scale, offset - scale, offset + scale, offset + scale);
    }
  }

  @Test
  void siteInTheMiddleOfNowhereOwnsTheRectangle() {
    VoronoiDiagram diagram = new VoronoiDiagram();
    check(diagram, new double[] {100, 0, -1000, 0}, 2, 0, 0, 1, 1);
    assertEquals(4, diagram.cellEnd(0) - diagram.cellStart(0));
    assertEquals(diagram.cellEnd(1), diagram.cellStart(1));
  }

  @Test
  void repeatedSiteHasAnEmptyCellAndNamesItsRepresentative() {
    VoronoiDiagram diagram = new VoronoiDiagram();
    check(diagram, new double[] {1, 1, 0, 0, 1, 1, 0, 0, 1, 1}, 5, -3, -3, 3, 3);
    assertEquals(0, diagram.representative(4));
    assertEquals(1, diagram.representative(3));
    assertEquals(diagram.cellStart(3), diagram.cellEnd(3));
    assertEquals(1, diagram.edgeCount());
  }

  @Test
  void squareGridMeetsInOneVertexForFourCells() {
    VoronoiDiagram diagram = new VoronoiDiagram();
    double[] sites = SiteKind.GRID.make(new Random(1), 100);
    check(diagram, sites, 100, -1, -1, 1, 1);
    int inner = 0;
    for (int i = 0; i < 100; i++) {
      inner += diagram.cellEnd(i) - diagram.cellStart(i);
    }
    assertEquals(400, inner);
    assertEquals(121, diagram.vertexCount());
  }

  @Test
  void hundredThousandSites() {
    Random random = new Random(5);
    int n = 100_000;
    double[] sites = new double[2 * n];
    for (int i = 0; i < 2 * n; i++) {
      sites[i] = random.nextFloat();
    }
    VoronoiDiagram diagram = new VoronoiDiagram();
    diagram.compute(sites, n, 0, 0, 1, 1);
    assertNull(diagram.validate());
  }

  @Test
  void badInputIsRefused() {
    VoronoiDiagram diagram = new VoronoiDiagram();
    double[] nan = {0, 0, Double.NaN, 1};
    assertThrows(IllegalArgumentException.class, () -> diagram.compute(nan, 2, 0, 0, 1, 1));
    double[] two = {0, 0, 1, 1};
    assertThrows(IllegalArgumentException.class, () -> diagram.compute(two, 3, 0, 0, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> diagram.compute(two, -1, 0, 0, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> diagram.compute(two, 2, 0, 0, 0, 1));
    assertThrows(
        IllegalArgumentException.class, () -> diagram.compute(two, 2, 0, 0, Double.NaN, 1));
  }
}
