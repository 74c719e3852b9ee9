package org.jbox2d.benchmarks.charts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.function.IntSupplier;
import org.jbox2d.fracture.fragmentation.Fragmentation;
import org.jbox2d.fracture.fragmentation.Fragmenter;
import org.jbox2d.fracture.fragmentation.PieceLimits;
import org.jbox2d.fracture.fragmentation.RegionOfEffect;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Polygon;

/**
 * Measures the geometry under a fracture beside JTS, poly2tri and earcut4j, and draws it: {@code
 * java -cp benchmarks/target/benchmarks.jar org.jbox2d.benchmarks.charts.GeometryCharts
 * [directory]}. All sizes are warmed up before the first is measured. Figures and charts go to
 * docs/charts unless told otherwise.
 */
public final class GeometryCharts {
  private static final int STAR_VERTICES = 64;
  private static final String MICROSECONDS = "thread time, microseconds";

  private final Plan plan;
  private final Path directory;

  GeometryCharts(Plan plan, Path directory) {
    this.plan = plan;
    this.directory = directory;
  }

  /** Measures and writes everything. */
  public static void main(String[] args) throws IOException {
    System.setProperty("java.awt.headless", "true");
    new GeometryCharts(Plan.full(), Path.of(args.length > 0 ? args[0] : "docs/charts")).run();
  }

  void run() throws IOException {
    Files.createDirectories(directory);
    voronoi();
    fragmentation();
    new DecompositionChart(plan, directory).run();
  }

  private void voronoi() throws IOException {
    int[] sizes = plan.diagramSites();
    Table table = new Table("sites", "ours_us", "jts_us", "ratio");
    VoronoiDiagram diagram = new VoronoiDiagram();
    Envelope clip = new Envelope(0, 1, 0, 1);
    IntSupplier[] tasks = new IntSupplier[2 * sizes.length];
    for (int k = 0; k < sizes.length; k++) {
      int n = sizes[k];
      double[] sites = Inputs.points(n, n);
      Coordinate[] coordinates = Inputs.coordinates(sites);
      tasks[2 * k] =
          () -> {
            diagram.compute(sites, n, 0, 0, 1, 1);
            return diagram.vertexCount();
          };
      tasks[2 * k + 1] = () -> Peers.voronoi(coordinates, clip).getNumGeometries();
    }
    double[][] times = inPairs(plan.watch().microseconds(tasks));
    double[] ours = times[0];
    double[] jts = times[1];
    for (int k = 0; k < sizes.length; k++) {
      table.add(sizes[k], ours[k], jts[k], jts[k] / ours[k]);
    }
    table.write(directory.resolve("voronoi.csv"));
    Drawing drawing = new Drawing("Voronoi diagram, clipped to a square", "sites", MICROSECONDS);
    drawing.logLog();
    drawing.line("JTS VoronoiDiagramBuilder", asDouble(sizes), jts, Drawing.PEER, true);
    drawing.line("VoronoiDiagram (here)", asDouble(sizes), ours, Drawing.OURS, false);
    drawing.write(directory.resolve("voronoi.svg"));
  }

  private void fragmentation() throws IOException {
    Table table = new Table("sites", "body", "ours_us", "jts_us", "ratio");
    Drawing drawing =
        new Drawing("Fragmentation by Voronoi cells, all pieces", "sites", MICROSECONDS);
    drawing.logLog();
    double[][] box = fragment(Inputs.box(), "box", table);
    double[][] star = fragment(Inputs.star(STAR_VERTICES), "star", table);
    double[] n = asDouble(plan.cutSites());
    drawing.line("JTS, star of 64 vertices", n, star[1], Drawing.PEER, true);
    drawing.line("JTS, box", n, box[1], Drawing.PEER, false);
    drawing.line("Fragmenter (here), star of 64 vertices", n, star[0], Drawing.OURS, true);
    drawing.line("Fragmenter (here), box", n, box[0], Drawing.OURS, false);
    table.write(directory.resolve("fragmentation.csv"));
    drawing.write(directory.resolve("fragmentation.svg"));
  }

  /** Times of ours and of JTS, for each number of sites. */
  private double[][] fragment(Outline body, String name, Table table) {
    int[] sizes = plan.cutSites();
    Fragmenter fragmenter = new Fragmenter();
    Polygon polygon = Inputs.polygon(body);
    IntSupplier[] tasks = new IntSupplier[2 * sizes.length];
    for (int k = 0; k < sizes.length; k++) {
      double[] sites = Inputs.points(sizes[k], sizes[k]);
      Coordinate[] coordinates = Inputs.coordinates(sites);
      tasks[2 * k] = () -> fragments(fragmenter, body, sites).fragments().size();
      tasks[2 * k + 1] = () -> Peers.fragments(polygon, coordinates).size();
    }
    double[][] result = inPairs(plan.watch().microseconds(tasks));
    for (int k = 0; k < sizes.length; k++) {
      table.add(sizes[k], name, result[0][k], result[1][k], result[1][k] / result[0][k]);
    }
    return result;
  }

  /** Takes apart what alternates between ours and the peer's. */
  private static double[][] inPairs(double[] times) {
    double[][] result = new double[2][times.length / 2];
    for (int i = 0; i < times.length; i++) {
      result[i % 2][i / 2] = times[i];
    }
    return result;
  }

  static Fragmentation fragments(Fragmenter fragmenter, Outline body, double[] sites) {
    return fragmenter.fragment(
        body, sites, sites.length / 2, Collections.<RegionOfEffect>emptyList(), PieceLimits.NONE);
  }

  static double[] asDouble(int[] values) {
    double[] result = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      result[i] = values[i];
    }
    return result;
  }
}
