package org.jbox2d.fracture.triangulation;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.fracture.geometry.Outline;
import org.poly2tri.Poly2Tri;
import org.poly2tri.geometry.polygon.Polygon;
import org.poly2tri.geometry.polygon.PolygonPoint;
import org.poly2tri.triangulation.TriangulationPoint;
import org.poly2tri.triangulation.delaunay.DelaunayTriangle;
import org.poly2tri.triangulation.delaunay.sweep.PointOnEdgeException;

/**
 * The triangulator of the thesis: the sweep of V. Domiter and B. Žalik, "Sweep-line algorithm for
 * constrained Delaunay triangulation", International Journal of Geographical Information Science 22
 * (2008), as poly2tri implements it.
 *
 * <p>Its predicates are rounded, with absolute tolerances. So the outline is moved to the origin
 * and scaled to a fixed size first. Even so it gives up on some valid outlines, with points in line
 * above all, or leaves out triangles; both count as failure here. Rings that touch are not for it.
 */
public final class Poly2TriTriangulator implements Triangulator {
  /**
   * Extent to which outlines are scaled: poly2tri's tolerance of 1e-12 for areas is then relative
   * to about 1e4.
   */
  private static final double EXTENT = 100;

  /** Relative difference of the total area of the triangles beyond which some are missing. */
  private static final double AREA_TOLERANCE = 1e-9;

  @Override
  public boolean triangulate(Outline outline, TriangleMesh mesh) {
    mesh.clear();
    Map<TriangulationPoint, Integer> index = new IdentityHashMap<>();
    Polygon polygon = convert(outline, index);
    try {
      Poly2Tri.triangulate(polygon);
    } catch (PointOnEdgeException | NullPointerException | StackOverflowError gaveUp) {
      // The three ways in which poly2tri ends on an outline it cannot do.
      return false;
    }
    double[] xy = outline.coordinates();
    double area = 0;
    for (DelaunayTriangle triangle : polygon.getTriangles()) {
      Integer a = index.get(triangle.points[0]);
      Integer b = index.get(triangle.points[1]);
      Integer c = index.get(triangle.points[2]);
      if (a == null || b == null || c == null) {
        return false;
      }
      double twice =
          (xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1])
              - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a]);
      if (twice <= 0) {
        return false;
      }
      area += 0.5 * twice;
      mesh.add(a, b, c);
    }
    double expected = outline.area();
    return Math.abs(area - expected) <= AREA_TOLERANCE * expected
        && mesh.link(outline.vertexCount());
  }

  private static Polygon convert(Outline outline, Map<TriangulationPoint, Integer> index) {
    double ox = outline.x(0);
    double oy = outline.y(0);
    double extent = 0;
    for (int i = 0; i < outline.vertexCount(); i++) {
      extent = Math.max(extent, Math.max(Math.abs(outline.x(i) - ox), Math.abs(outline.y(i) - oy)));
    }
    double scale = EXTENT / extent;
    Polygon polygon = null;
    for (int r = 0; r < outline.ringCount(); r++) {
      List<PolygonPoint> points = new ArrayList<>();
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        PolygonPoint point =
            new PolygonPoint((outline.x(i) - ox) * scale, (outline.y(i) - oy) * scale);
        index.put(point, i);
        points.add(point);
      }
      if (polygon == null) {
        polygon = new Polygon(points);
      } else {
        polygon.addHole(new Polygon(points));
      }
    }
    return polygon;
  }
}
