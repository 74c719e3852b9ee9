package org.jbox2d.benchmarks.charts;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.locationtech.jts.triangulate.VoronoiDiagramBuilder;

/** The same work done with JTS, as its documentation would have it. */
final class Peers {
  private Peers() {}

  /** Voronoi cells of sites, clipped to a rectangle. */
  static Geometry voronoi(Coordinate[] sites, Envelope clip) {
    VoronoiDiagramBuilder builder = new VoronoiDiagramBuilder();
    builder.setSites(Arrays.asList(sites));
    builder.setClipEnvelope(clip);
    return builder.getDiagram(Inputs.JTS);
  }

  /**
   * Pieces of a polygon in the Voronoi cells of sites. Cells inside are taken whole and cells
   * outside left out, by the prepared polygon, so that the overlay is for the rest alone.
   */
  static List<Geometry> fragments(Polygon polygon, Coordinate[] sites) {
    Envelope clip = polygon.getEnvelopeInternal().copy();
    clip.expandBy(clip.getWidth() / 8, clip.getHeight() / 8);
    Geometry cells = voronoi(sites, clip);
    PreparedGeometry body = PreparedGeometryFactory.prepare(polygon);
    List<Geometry> pieces = new ArrayList<>();
    for (int i = 0; i < cells.getNumGeometries(); i++) {
      Geometry cell = cells.getGeometryN(i);
      if (body.containsProperly(cell)) {
        pieces.add(cell);
      } else if (body.intersects(cell)) {
        pieces.add(OverlayNGRobust.overlay(polygon, cell, OverlayNG.INTERSECTION));
      }
    }
    return pieces;
  }
}
