package org.jbox2d.fracture.fragmentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/** The overlap of a region and a ring, against the intersection with a polygon of many vertices. */
class ImpactRegionTest {
  private static final GeometryFactory FACTORY = new GeometryFactory();
  private static final int BOUNDARY_POINTS = 2000;

  private static Polygon polygon(double[] xy) {
    Coordinate[] ring = new Coordinate[xy.length / 2 + 1];
    for (int i = 0; i < ring.length; i++) {
      int k = i % (xy.length / 2);
      ring[i] = new Coordinate(xy[2 * k], xy[2 * k + 1]);
    }
    return FACTORY.createPolygon(ring);
  }

  private static double overlap(RegionOfEffect region, double[] ring) {
    double sum = 0;
    int n = ring.length / 2;
    for (int i = 0; i < n; i++) {
      int j = (i + 1) % n;
      sum += region.overlap(ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]);
    }
    return sum;
  }

  /** Star-shaped around a point that is as likely inside the region as outside. */
  private static double[] ring(Random random) {
    int n = 3 + random.nextInt(10);
    double x = 3 * (random.nextDouble() - 0.5);
    double y = 3 * (random.nextDouble() - 0.5);
    double size = 0.05 + 2 * random.nextDouble();
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / n;
      double radius = size * (0.3 + 0.7 * random.nextDouble());
      xy[2 * i] = x + radius * Math.cos(angle);
      xy[2 * i + 1] = y + radius * Math.sin(angle);
    }
    return xy;
  }

  @Test
  void overlapIsThatOfRegionAndRing() {
    Random random = new Random(4);
    for (int c = 0; c < 400; c++) {
      double radius = 0.3 + random.nextDouble();
      double depth = 0.3 + 2 * random.nextDouble();
      boolean still = c % 5 == 0;
      ImpactRegion region =
          new ImpactRegion(
              random.nextDouble() - 0.5,
              random.nextDouble() - 0.5,
              still ? 0 : random.nextGaussian(),
              still ? 0 : random.nextGaussian(),
              radius,
              depth);
      double[] ring = ring(random);
      double expected =
          polygon(ring).intersection(polygon(region.boundary(BOUNDARY_POINTS))).getArea();
      double inscribed = 4 * radius * Math.max(radius, depth) / BOUNDARY_POINTS;
      assertEquals(expected, overlap(region, ring), inscribed, "case " + c);
    }
  }

  /** A point of the region beyond a side would let cells that break away be left out. */
  @Test
  void noPointOfTheRegionIsBeyondASide() {
    Random random = new Random(6);
    for (int c = 0; c < 400; c++) {
      boolean still = c % 5 == 0;
      ImpactRegion region =
          new ImpactRegion(
              random.nextDouble() - 0.5,
              random.nextDouble() - 0.5,
              still ? 0 : random.nextGaussian(),
              still ? 0 : random.nextGaussian(),
              0.3 + random.nextDouble(),
              0.3 + 2 * random.nextDouble());
      double[] boundary = region.boundary(64);
      for (int i = 0; i < 64; i++) {
        double x = boundary[2 * i] - region.contactX();
        double y = boundary[2 * i + 1] - region.contactY();
        assertEquals(0, beyond(region, 1 - 1e-12, x, y), "case " + c);
        assertNotEquals(0, beyond(region, 1.1, x, y), "case " + c);
      }
    }
  }

  private static int beyond(RegionOfEffect region, double factor, double x, double y) {
    return region.sidesBeyond(region.contactX() + factor * x, region.contactY() + factor * y);
  }

  @Test
  void anEdgeSeenFromTheOtherSideHasTheOppositeTerm() {
    Random random = new Random(5);
    ImpactRegion region = new ImpactRegion(0.1, -0.2, 1, 2, 0.8, 1.5);
    for (int c = 0; c < 1000; c++) {
      double ax = 4 * random.nextDouble() - 2;
      double ay = 4 * random.nextDouble() - 2;
      double bx = 4 * random.nextDouble() - 2;
      double by = 4 * random.nextDouble() - 2;
      double there = region.overlap(ax, ay, bx, by);
      assertEquals(-there, region.overlap(bx, by, ax, ay), 1e-13);
    }
  }
}
