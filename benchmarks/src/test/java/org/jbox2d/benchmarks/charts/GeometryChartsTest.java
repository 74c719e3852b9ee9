package org.jbox2d.benchmarks.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jbox2d.fracture.fragmentation.Fragment;
import org.jbox2d.fracture.fragmentation.Fragmenter;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.OutlineDefect;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.locationtech.jts.geom.Geometry;

class GeometryChartsTest {
  /** Relative: areas are sums of a few hundred rounded terms. */
  private static final double AREA_TOLERANCE = 1e-9;

  private static final String OUR_COLOUR = "rgb(31,95,168)";

  @Test
  void writesEveryChartAndItsFigures(@TempDir Path directory) throws IOException {
    Plan tiny =
        new Plan(
            new Stopwatch(0, 1, 1), new int[] {10, 20}, new int[] {10, 20}, new int[] {8, 12}, 3);
    new GeometryCharts(tiny, directory).run();
    for (String name : List.of("voronoi", "fragmentation", "decomposition")) {
      String svg = Files.readString(directory.resolve(name + ".svg"));
      assertTrue(svg.trim().endsWith("</svg>"), name);
      assertTrue(svg.contains(OUR_COLOUR), name);
    }
    assertEquals(3, Files.readAllLines(directory.resolve("voronoi.csv")).size());
    assertEquals(5, Files.readAllLines(directory.resolve("fragmentation.csv")).size());
    assertEquals(6, Files.readAllLines(directory.resolve("triangulation.csv")).size());
    List<String> rows = Files.readAllLines(directory.resolve("decomposition.csv"));
    assertEquals(13, rows.size());
    for (String row : rows.subList(1, rows.size())) {
      String[] cells = row.split(",");
      double mean = Double.parseDouble(cells[3]);
      assertTrue(mean >= 1 && Double.parseDouble(cells[4]) >= mean, row);
      assertTrue(!cells[1].equals("minimum") || mean == 1, row);
    }
  }

  @Test
  void bothCutTheWholeBody() {
    for (Outline body : List.of(Inputs.box(), Inputs.star(64))) {
      double[] sites = Inputs.points(50, 1);
      double ours = 0;
      for (Fragment f : GeometryCharts.fragments(new Fragmenter(), body, sites).fragments()) {
        ours += f.outline().area();
      }
      double jts = 0;
      for (Geometry piece : Peers.fragments(Inputs.polygon(body), Inputs.coordinates(sites))) {
        jts += piece.getArea();
      }
      assertEquals(body.area(), ours, AREA_TOLERANCE * body.area());
      assertEquals(body.area(), jts, AREA_TOLERANCE * body.area());
    }
  }

  @Test
  void randomPolygonsAreSimple() {
    for (int seed = 0; seed < 100; seed++) {
      Outline outline = Inputs.polygon(24, seed);
      assertEquals(24, outline.vertexCount());
      assertEquals(OutlineDefect.NONE, OutlineCheck.of(outline).defect(), "seed " + seed);
    }
  }
}
