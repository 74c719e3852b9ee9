package org.jbox2d.fracture.voronoi;

/** Checks a Voronoi diagram against what defines it. */
final class VoronoiCheck {
  /** Relative error of the sum of all cell areas beyond which the diagram is not a partition. */
  private static final double AREA_TOLERANCE = 1e-9;

  /**
   * A corner of a cell may turn clockwise by no more than this, in units of the rectangle's extent.
   */
  private static final double CONVEXITY_TOLERANCE = 1e-11;

  private final VoronoiDiagram diagram;
  private final double minX;
  private final double minY;
  private final double maxX;
  private final double maxY;

  VoronoiCheck(VoronoiDiagram diagram, double minX, double minY, double maxX, double maxY) {
    this.diagram = diagram;
    this.minX = minX;
    this.minY = minY;
    this.maxX = maxX;
    this.maxY = maxY;
  }

  /** Returns null if all is well, else what is wrong. */
  String validate() {
    Delaunay delaunay = diagram.delaunay();
    for (int e = 0; e < delaunay.edgeEnd(); e += 2) {
      if (delaunay.isEdge(e) && diagram.isInner(e) && delaunay.inCircleSign(e) > 0) {
        return "edge " + e + " is not Delaunay";
      }
    }
    double total = 0;
    for (int i = 0; i < diagram.siteCount(); i++) {
      String fault = validateCell(i);
      if (fault != null) {
        return fault;
      }
      total += diagram.cellArea(i);
    }
    double whole = (maxX - minX) * (maxY - minY);
    if (diagram.siteCount() > 0 && Math.abs(total - whole) > AREA_TOLERANCE * whole) {
      return "cells have area " + total + " in a rectangle of " + whole;
    }
    return null;
  }

  private String validateCell(int i) {
    int start = diagram.cellStart(i);
    int size = diagram.cellEnd(i) - start;
    double far =
        Math.max(
            Math.max(Math.abs(minX), Math.abs(maxX)), Math.max(Math.abs(minY), Math.abs(maxY)));
    double tolerance =
        CONVEXITY_TOLERANCE * Math.max(maxX - minX, maxY - minY) + 16 * Math.ulp(far);
    for (int k = 0; k < size; k++) {
      int a = diagram.cornerVertex(start + k);
      int b = diagram.cornerVertex(start + (k + 1) % size);
      int c = diagram.cornerVertex(start + (k + 2) % size);
      double ux = diagram.vertexX(b) - diagram.vertexX(a);
      double uy = diagram.vertexY(b) - diagram.vertexY(a);
      double wx = diagram.vertexX(c) - diagram.vertexX(a);
      double wy = diagram.vertexY(c) - diagram.vertexY(a);
      double width = Math.sqrt(wx * wx + wy * wy);
      if (ux * wy - uy * wx < -tolerance * width) {
        return "cell " + i + " is not convex at its corner " + (k + 1) % size;
      }
      int neighbour = diagram.cornerNeighbour(start + k);
      if (neighbour != VoronoiDiagram.BORDER && !hasEdge(neighbour, b, a, i)) {
        return "cells " + i + " and " + neighbour + " do not share an edge";
      }
    }
    return null;
  }

  private boolean hasEdge(int cell, int from, int to, int neighbour) {
    int start = diagram.cellStart(cell);
    int size = diagram.cellEnd(cell) - start;
    for (int k = 0; k < size; k++) {
      if (diagram.cornerVertex(start + k) == from
          && diagram.cornerVertex(start + (k + 1) % size) == to) {
        return diagram.cornerNeighbour(start + k) == neighbour;
      }
    }
    return false;
  }
}
