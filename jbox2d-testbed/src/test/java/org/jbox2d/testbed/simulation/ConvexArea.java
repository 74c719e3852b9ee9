package org.jbox2d.testbed.simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;

/**
 * The convex parts of a body in world coordinates, and the area that they share with another's.
 * Parts are intersected by clipping one by each edge of the other (Sutherland, Hodgman 1974), in
 * doubles.
 */
final class ConvexArea {
  private final List<double[]> parts = new ArrayList<>();

  ConvexArea(Body body) {
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      if (f.getShape() instanceof PolygonShape polygon) {
        double[] part = new double[2 * polygon.getVertexCount()];
        for (int i = 0; i < polygon.getVertexCount(); i++) {
          Vec2 v = Transform.mul(body.getTransform(), polygon.getVertex(i));
          part[2 * i] = v.x;
          part[2 * i + 1] = v.y;
        }
        parts.add(part);
      } else if (f.getShape() instanceof CircleShape) {
        throw new AssertionError("a fragment is made of polygons");
      }
    }
  }

  /** Sum of the lengths of all edges. */
  double edges() {
    double sum = 0;
    for (double[] p : parts) {
      int n = p.length / 2;
      for (int i = 0; i < n; i++) {
        int j = (i + 1) % n;
        sum += Math.hypot(p[2 * j] - p[2 * i], p[2 * j + 1] - p[2 * i + 1]);
      }
    }
    return sum;
  }

  double overlap(ConvexArea other) {
    double sum = 0;
    for (double[] a : parts) {
      for (double[] b : other.parts) {
        sum += area(clip(a, b));
      }
    }
    return sum;
  }

  private static double[] clip(double[] subject, double[] window) {
    double[] rest = subject;
    int n = window.length / 2;
    for (int i = 0; i < n && rest.length > 0; i++) {
      int j = (i + 1) % n;
      rest = clip(rest, window[2 * i], window[2 * i + 1], window[2 * j], window[2 * j + 1]);
    }
    return rest;
  }

  /** What lies to the left of the line from a to b. */
  private static double[] clip(double[] p, double ax, double ay, double bx, double by) {
    double[] out = new double[2 * p.length + 4];
    int count = 0;
    int n = p.length / 2;
    for (int i = 0; i < n; i++) {
      int j = (i + 1) % n;
      double here = (bx - ax) * (p[2 * i + 1] - ay) - (by - ay) * (p[2 * i] - ax);
      double there = (bx - ax) * (p[2 * j + 1] - ay) - (by - ay) * (p[2 * j] - ax);
      if (here >= 0) {
        out[count++] = p[2 * i];
        out[count++] = p[2 * i + 1];
      }
      if (here * there < 0) {
        double t = here / (here - there);
        out[count++] = p[2 * i] + t * (p[2 * j] - p[2 * i]);
        out[count++] = p[2 * i + 1] + t * (p[2 * j + 1] - p[2 * i + 1]);
      }
    }
    return Arrays.copyOf(out, count);
  }

  private static double area(double[] p) {
    double twice = 0;
    int n = p.length / 2;
    for (int i = 0; i < n; i++) {
      int j = (i + 1) % n;
      twice += p[2 * i] * p[2 * j + 1] - p[2 * j] * p[2 * i + 1];
    }
    return 0.5 * twice;
  }
}
