package org.jbox2d.benchmarks.charts;

import earcut4j.Earcut;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.IntSupplier;
import java.util.function.ToIntFunction;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.hertelmehlhorn.ConvexDecomposition;
import org.jbox2d.fracture.hertelmehlhorn.DiagonalOrder;
import org.jbox2d.fracture.hertelmehlhorn.MinimumDecomposition;
import org.jbox2d.fracture.triangulation.DelaunayTriangulator;
import org.jbox2d.fracture.triangulation.Poly2TriTriangulator;
import org.jbox2d.fracture.triangulation.TriangleMesh;
import org.jbox2d.fracture.triangulation.Triangulator;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.triangulate.polygon.PolygonTriangulator;

/**
 * Parts over the minimum against time for ways to decompose random simple polygons, and times of
 * triangulators.
 */
final class DecompositionChart {
  /** Size of the polygons of the table of triangulators. */
  private static final int TRIANGULATED_VERTICES = 32;

  /** Place of earcut4j in that table. */
  private static final int EARCUT = 3;

  /** The engine's own limit for a part. */
  private static final int MOST_VERTICES = 8;

  /** Length of the horizontal axis over the longest time. */
  private static final double AXIS_MARGIN = 1.2;

  private static final int UNLIMITED = Integer.MAX_VALUE;

  private final Plan plan;
  private final Path directory;

  DecompositionChart(Plan plan, Path directory) {
    this.plan = plan;
    this.directory = directory;
  }

  void run() throws IOException {
    decomposition();
    triangulation();
  }

  /** A way to decompose; a result is a number of parts. */
  private enum Way {
    TRIANGLES("triangles alone", Drawing.PEER, false),
    AS_FOUND("Hertel-Mehlhorn, diagonals as they come", Drawing.FOURTH, true),
    LONGEST("Hertel-Mehlhorn, longest diagonal first", Drawing.FOURTH, false),
    LIMITED("Hertel-Mehlhorn, best of three orders, 8 vertices at most", Drawing.OURS, true),
    FREE("Hertel-Mehlhorn, best of three orders", Drawing.OURS, false),
    MINIMUM("minimum", Drawing.THIRD, false);

    final String label;
    final Color colour;
    final boolean dashed;

    Way(String label, Color colour, boolean dashed) {
      this.label = label;
      this.colour = colour;
      this.dashed = dashed;
    }

    ToIntFunction<Outline> task() {
      return switch (this) {
        case TRIANGLES -> triangles(new DelaunayTriangulator());
        case AS_FOUND -> merged(UNLIMITED, DiagonalOrder.AS_FOUND);
        case LONGEST -> merged(UNLIMITED, DiagonalOrder.LONGEST_FIRST);
        case LIMITED -> merged(MOST_VERTICES, DiagonalOrder.values());
        case FREE -> merged(UNLIMITED, DiagonalOrder.values());
        case MINIMUM -> MinimumDecomposition::parts;
      };
    }
  }

  private static ToIntFunction<Outline> merged(int mostVertices, DiagonalOrder... orders) {
    ConvexDecomposition decomposition =
        new ConvexDecomposition(new DelaunayTriangulator(), null, orders);
    return o -> decomposition.decompose(o, mostVertices, 0).parts().count();
  }

  private static ToIntFunction<Outline> triangles(Triangulator triangulator) {
    TriangleMesh mesh = new TriangleMesh();
    return o -> triangulator.triangulate(o, mesh) ? mesh.triangleCount() : 0;
  }

  private void decomposition() throws IOException {
    Table table =
        new Table("vertices", "way", "us", "parts_over_minimum_mean", "parts_over_minimum_most");
    Way[] ways = Way.values();
    int[] sizes = plan.polygonVertices();
    double[][] times = new double[ways.length][sizes.length];
    double[][] means = new double[ways.length][sizes.length];
    for (int k = 0; k < sizes.length; k++) {
      Outline[] polygons = polygons(sizes[k]);
      IntSupplier[] tasks = new IntSupplier[ways.length];
      for (Way way : ways) {
        tasks[way.ordinal()] = overAll(polygons, way.task());
      }
      double[] all = plan.watch().microseconds(tasks);
      for (Way way : ways) {
        int w = way.ordinal();
        times[w][k] = all[w] / polygons.length;
        double[] ratio = overMinimum(polygons, way.task());
        means[w][k] = ratio[0];
        table.add(sizes[k], way.label.replace(",", ""), times[w][k], ratio[0], ratio[1]);
      }
    }
    table.write(directory.resolve("decomposition.csv"));
    Drawing drawing =
        new Drawing(
            "Convex decomposition of random polygons of "
                + sizes[0]
                + " to "
                + sizes[sizes.length - 1]
                + " vertices",
            "thread time, microseconds (a marker for each size, smallest first)",
            "parts over the minimum, mean");
    drawing.legend(LegendPosition.InsideNE);
    drawing.between(1, AXIS_MARGIN * greatest(times));
    for (Way way : ways) {
      int w = way.ordinal();
      drawing.line(way.label, times[w], means[w], way.colour, way.dashed);
    }
    drawing.write(directory.resolve("decomposition.svg"));
  }

  private static double greatest(double[][] table) {
    return Arrays.stream(table).flatMapToDouble(Arrays::stream).max().orElseThrow();
  }

  private Outline[] polygons(int vertices) {
    Outline[] polygons = new Outline[plan.polygons()];
    for (int i = 0; i < polygons.length; i++) {
      polygons[i] = Inputs.polygon(vertices, 1000L * vertices + i);
    }
    return polygons;
  }

  private static <T> IntSupplier overAll(T[] inputs, ToIntFunction<T> task) {
    return () -> {
      int sum = 0;
      for (T input : inputs) {
        sum += task.applyAsInt(input);
      }
      return sum;
    };
  }

  /** Mean and greatest number of parts over the minimum. */
  private static double[] overMinimum(Outline[] polygons, ToIntFunction<Outline> task) {
    double sum = 0;
    double most = 0;
    for (Outline polygon : polygons) {
      double ratio = (double) task.applyAsInt(polygon) / MinimumDecomposition.parts(polygon);
      sum += ratio;
      most = Math.max(most, ratio);
    }
    return new double[] {sum / polygons.length, most};
  }

  private void triangulation() throws IOException {
    Outline[] outlines = polygons(TRIANGULATED_VERTICES);
    Polygon[] jts = new Polygon[outlines.length];
    double[][] flat = new double[outlines.length][];
    for (int i = 0; i < outlines.length; i++) {
      jts[i] = Inputs.polygon(outlines[i]);
      flat[i] = outlines[i].coordinates();
    }
    String[] names = {
      "DelaunayTriangulator (here)",
      "poly2tri",
      "JTS PolygonTriangulator",
      "earcut4j",
      "decomposition by ConvexDecomposition (here)"
    };
    double[] times =
        plan.watch()
            .microseconds(
                overAll(outlines, triangles(new DelaunayTriangulator())),
                overAll(outlines, triangles(new Poly2TriTriangulator())),
                overAll(jts, p -> PolygonTriangulator.triangulate(p).getNumGeometries()),
                overAll(flat, xy -> Earcut.earcut(xy).size()),
                overAll(outlines, Way.LIMITED.task()));
    Table table = new Table("vertices", "what", "us", "over_earcut4j");
    for (int i = 0; i < names.length; i++) {
      table.add(
          TRIANGULATED_VERTICES, names[i], times[i] / outlines.length, times[i] / times[EARCUT]);
    }
    table.write(directory.resolve("triangulation.csv"));
  }
}
