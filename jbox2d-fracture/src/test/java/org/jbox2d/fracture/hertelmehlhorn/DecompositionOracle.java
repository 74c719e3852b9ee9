package org.jbox2d.fracture.hertelmehlhorn;

import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.valid.IsValidOp;

/** Judges a decomposition. */
final class DecompositionOracle {
  private static final GeometryFactory FACTORY = new GeometryFactory();

  private DecompositionOracle() {}

  /** What is wrong, or null. */
  static String fault(
      Outline outline,
      ConvexDecomposition.Result result,
      int mostVertices,
      double areaTolerance,
      boolean overlaps) {
    if (result.status() != ConvexDecomposition.Status.DECOMPOSED) {
      return result.status() + " " + result.reason();
    }
    ConvexParts parts = result.parts();
    double total = 0;
    Geometry[] polygons = new Geometry[parts.count()];
    for (int p = 0; p < parts.count(); p++) {
      double[] xy = parts.coordinates(p);
      int n = parts.size(p);
      if (n < 3 || n > mostVertices) {
        return "part of " + n + " vertices";
      }
      Coordinate[] ring = new Coordinate[n + 1];
      for (int i = 0; i < n; i++) {
        if (Predicates.orientation(xy, i, (i + 1) % n, (i + 2) % n) <= 0) {
          return "part " + p + " is not strictly convex at " + (i + 1) % n;
        }
        ring[i] = new Coordinate(xy[2 * i] - outline.x(0), xy[2 * i + 1] - outline.y(0));
      }
      ring[n] = ring[0].copy();
      polygons[p] = FACTORY.createPolygon(ring);
      IsValidOp valid = new IsValidOp(polygons[p]);
      if (!valid.isValid()) {
        return valid.getValidationError() + " in " + polygons[p];
      }
      total += parts.area(p);
    }
    double expected = outline.area();
    if (!(Math.abs(total - expected) <= areaTolerance * expected)) {
      return "area " + total + " of " + expected;
    }
    if (overlaps) {
      for (int p = 0; p < polygons.length; p++) {
        for (int q = p + 1; q < polygons.length; q++) {
          if (polygons[p].getEnvelopeInternal().intersects(polygons[q].getEnvelopeInternal())
              && polygons[p].intersection(polygons[q]).getArea() > areaTolerance * expected) {
            return "parts overlap";
          }
        }
      }
    }
    return null;
  }
}
