package org.jbox2d.fracture.fragmentation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.fracture.geometry.Outline;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.util.AffineTransformation;
import org.locationtech.jts.operation.valid.IsValidOp;

/** Judges a fragmentation by means of JTS. */
final class FragmentationOracle {
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private FragmentationOracle() {}

  static Polygon toJts(Outline outline) {
    LinearRing[] holes = new LinearRing[outline.ringCount() - 1];
    LinearRing shell = null;
    for (int r = 0; r < outline.ringCount(); r++) {
      int size = outline.ringEnd(r) - outline.ringStart(r);
      Coordinate[] ring = new Coordinate[size + 1];
      for (int i = 0; i < size; i++) {
        int v = outline.ringStart(r) + i;
        ring[i] = new Coordinate(outline.x(v), outline.y(v));
      }
      ring[size] = ring[0].copy();
      if (r == 0) {
        shell = FACTORY.createLinearRing(ring);
      } else {
        holes[r - 1] = FACTORY.createLinearRing(ring);
      }
    }
    return FACTORY.createPolygon(shell, holes);
  }

  /** What is wrong with a result, or null. */
  static String fault(Outline body, Fragmentation result, double areaTolerance, boolean overlaps) {
    if (result.status().isFailure()) {
      return result.status() + ": " + result.reason();
    }
    List<Outline> all = new ArrayList<>(result.remainders());
    for (Fragment fragment : result.fragments()) {
      all.add(fragment.outline());
    }
    double total = 0;
    List<Polygon> polygons = new ArrayList<>();
    for (Outline outline : all) {
      if (result.status() == FragmentationStatus.BROKEN && !outline.isNormal()) {
        return "not normal: " + toJts(outline);
      }
      Polygon polygon = toJts(outline);
      IsValidOp valid = new IsValidOp(polygon);
      if (!valid.isValid()) {
        return valid.getValidationError() + " in " + polygon;
      }
      total += outline.area();
      polygons.add(polygon);
    }
    double expected = body.area();
    if (!(Math.abs(total - expected) <= areaTolerance * expected)) {
      return "area " + total + " of " + expected;
    }
    String gap = edgesShared(body, all);
    if (gap != null) {
      return gap;
    }
    return overlaps ? overlap(body, polygons, areaTolerance * expected) : null;
  }

  /** Every edge of a piece is an edge of one other, reversed, or lies on the outline. */
  private static String edgesShared(Outline body, List<Outline> all) {
    Map<List<Double>, Integer> edges = new HashMap<>();
    for (Outline outline : all) {
      forEachEdge(
          outline, (ax, ay, bx, by) -> edges.merge(List.of(ax, ay, bx, by), 1, Integer::sum));
    }
    String[] fault = new String[1];
    Geometry boundary = toJts(body).getBoundary();
    double extent = toJts(body).getEnvelopeInternal().getDiameter();
    for (Outline outline : all) {
      forEachEdge(
          outline,
          (ax, ay, bx, by) -> {
            if (edges.get(List.of(ax, ay, bx, by)) != 1) {
              fault[0] = "edge of two pieces in the same direction";
            }
            if (!edges.containsKey(List.of(bx, by, ax, ay))) {
              Geometry middle =
                  FACTORY.createPoint(new Coordinate(0.5 * (ax + bx), 0.5 * (ay + by)));
              double distance = boundary.distance(middle);
              double ulp = Math.ulp(Math.max(Math.abs(ax), Math.abs(ay)));
              if (distance > 1e-10 * extent + 20 * ulp) {
                fault[0] = "edge that is not shared, " + distance + " from the outline";
              }
            }
          });
    }
    return fault[0];
  }

  private interface EdgeVisitor {
    void visit(double ax, double ay, double bx, double by);
  }

  private static void forEachEdge(Outline outline, EdgeVisitor visitor) {
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = outline.ringEnd(r) - 1;
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        visitor.visit(outline.x(last), outline.y(last), outline.x(i), outline.y(i));
        last = i;
      }
    }
  }

  /** Areas add up, so pieces that lie in the outline and do not overlap tile it. */
  private static String overlap(Outline body, List<Polygon> polygons, double tolerance) {
    Polygon whole = toJts(body);
    Coordinate first = whole.getCoordinate();
    AffineTransformation home = AffineTransformation.translationInstance(-first.x, -first.y);
    List<Geometry> moved = new ArrayList<>();
    for (Polygon polygon : polygons) {
      moved.add(home.transform(polygon));
    }
    for (int i = 0; i < moved.size(); i++) {
      for (int j = i + 1; j < moved.size(); j++) {
        if (moved.get(i).getEnvelopeInternal().intersects(moved.get(j).getEnvelopeInternal())) {
          double common = moved.get(i).intersection(moved.get(j)).getArea();
          if (common > tolerance) {
            return "overlap of " + common;
          }
        }
      }
    }
    return null;
  }
}
