package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;

/**
 * Depth of overlap of polygons by separating axes, in double: an oracle that shares nothing with
 * the engine.
 */
final class Overlap {
  private Overlap() {}

  /** Returns the deepest overlap of the cores of polygons of different bodies, m; 0 if none. */
  static double deepest(List<Body> bodies) {
    List<double[]> polygons = new ArrayList<>();
    List<Body> owner = new ArrayList<>();
    for (Body b : bodies) {
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        if (f.getShape() instanceof PolygonShape) {
          polygons.add(world(b, (PolygonShape) f.getShape()));
          owner.add(b);
        }
      }
    }
    double deepest = 0;
    for (int i = 0; i < polygons.size(); i++) {
      for (int j = 0; j < i; j++) {
        if (owner.get(i) != owner.get(j)) {
          double gap =
              Math.max(
                  gap(polygons.get(i), polygons.get(j)), gap(polygons.get(j), polygons.get(i)));
          deepest = Math.max(deepest, -gap);
        }
      }
    }
    return deepest;
  }

  private static double[] world(Body b, PolygonShape p) {
    double[] xy = new double[2 * p.m_count];
    for (int i = 0; i < p.m_count; i++) {
      Vec2 w = b.getWorldPoint(p.m_vertices[i]);
      xy[2 * i] = w.x;
      xy[2 * i + 1] = w.y;
    }
    return xy;
  }

  /**
   * Largest distance of q from p along a normal of p; negative if they overlap along all of them.
   */
  private static double gap(double[] p, double[] q) {
    double largest = Double.NEGATIVE_INFINITY;
    int n = p.length / 2;
    for (int i = 0; i < n; i++) {
      int j = (i + 1) % n;
      double ex = p[2 * j] - p[2 * i];
      double ey = p[2 * j + 1] - p[2 * i + 1];
      double length = Math.hypot(ex, ey);
      double least = Double.POSITIVE_INFINITY;
      for (int k = 0; k < q.length / 2; k++) {
        double d = (ey * (q[2 * k] - p[2 * i]) - ex * (q[2 * k + 1] - p[2 * i + 1])) / length;
        least = Math.min(least, d);
      }
      largest = Math.max(largest, least);
    }
    return largest;
  }
}
