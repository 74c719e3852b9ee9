package org.jbox2d.collision;

import java.util.Random;
import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/** Convex geometry by brute force in double, and random shapes: what the tests compare with. */
final class ConvexOracle {

  private ConvexOracle() {}

  /** World coordinates of a proxy's corners: x0, y0, x1, y1, ... */
  static double[] corners(DistanceProxy proxy, Transform xf) {
    double[] out = new double[2 * proxy.m_count];
    for (int i = 0; i < proxy.m_count; i++) {
      Vec2 v = proxy.m_vertices[i];
      out[2 * i] = (double) xf.q.c * v.x - (double) xf.q.s * v.y + xf.p.x;
      out[2 * i + 1] = (double) xf.q.s * v.x + (double) xf.q.c * v.y + xf.p.y;
    }
    return out;
  }

  static double[] corners(PolygonShape polygon, Transform xf) {
    DistanceProxy proxy = new DistanceProxy();
    proxy.set(polygon, 0);
    return corners(proxy, xf);
  }

  /** Least distance over all pairs of edges; zero if they cross or one contains the other. */
  static double distance(double[] a, double[] b) {
    if (contains(a, b[0], b[1]) || contains(b, a[0], a[1])) {
      return 0.0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < a.length; i += 2) {
      int i2 = (i + 2) % a.length;
      for (int j = 0; j < b.length; j += 2) {
        int j2 = (j + 2) % b.length;
        if (cross(a, i, i2, b, j, j2)) {
          return 0.0;
        }
        least = Math.min(least, pointToSegment(a[i], a[i + 1], b, j, j2));
        least = Math.min(least, pointToSegment(b[j], b[j + 1], a, i, i2));
      }
    }
    return least;
  }

  static double distanceToPoint(double[] polygon, double x, double y) {
    return distance(polygon, new double[] {x, y});
  }

  /** Greatest separation over the face normals of both counter-clockwise polygons. */
  static double maxFaceSeparation(double[] a, double[] b) {
    return Math.max(maxOverFaces(a, b), maxOverFaces(b, a));
  }

  /** Separation of b from a along a unit direction. */
  static double separationAlong(double nx, double ny, double[] a, double[] b) {
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < a.length; i += 2) {
      most = Math.max(most, nx * a[i] + ny * a[i + 1]);
    }
    double least = Double.POSITIVE_INFINITY;
    for (int j = 0; j < b.length; j += 2) {
      least = Math.min(least, nx * b[j] + ny * b[j + 1]);
    }
    return least - most;
  }

  private static double maxOverFaces(double[] a, double[] b) {
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < a.length; i += 2) {
      int i2 = (i + 2) % a.length;
      double ex = a[i2] - a[i];
      double ey = a[i2 + 1] - a[i + 1];
      double length = Math.sqrt(ex * ex + ey * ey);
      best = Math.max(best, separationAlong(ey / length, -ex / length, a, b));
    }
    return best;
  }

  private static boolean contains(double[] a, double x, double y) {
    if (a.length < 6) {
      return false;
    }
    for (int i = 0; i < a.length; i += 2) {
      int k = (i + 2) % a.length;
      if ((a[k] - a[i]) * (y - a[i + 1]) - (a[k + 1] - a[i + 1]) * (x - a[i]) < 0.0) {
        return false;
      }
    }
    return true;
  }

  private static boolean cross(double[] a, int i, int i2, double[] b, int j, int j2) {
    return side(a, i, i2, b, j) * side(a, i, i2, b, j2) < 0.0
        && side(b, j, j2, a, i) * side(b, j, j2, a, i2) < 0.0;
  }

  private static double side(double[] a, int i, int i2, double[] p, int k) {
    return Math.signum(
        (a[i2] - a[i]) * (p[k + 1] - a[i + 1]) - (a[i2 + 1] - a[i + 1]) * (p[k] - a[i]));
  }

  private static double pointToSegment(double x, double y, double[] s, int i, int i2) {
    double ex = s[i2] - s[i];
    double ey = s[i2 + 1] - s[i + 1];
    double squared = ex * ex + ey * ey;
    double f = squared > 0.0 ? ((x - s[i]) * ex + (y - s[i + 1]) * ey) / squared : 0.0;
    f = Math.max(0.0, Math.min(1.0, f));
    return Math.hypot(s[i] + f * ex - x, s[i + 1] + f * ey - y);
  }

  /** A convex polygon of 3 to 8 vertices around the origin, {@code size} in radius. */
  static PolygonShape randomPolygon(Random random, float size) {
    int count = 3 + random.nextInt(6);
    Vec2[] vertices = new Vec2[count];
    double phase = random.nextDouble() * 2.0 * Math.PI;
    double flat = 0.4 + 0.6 * random.nextDouble();
    for (int i = 0; i < count; i++) {
      double angle = phase + 2.0 * Math.PI * (i + 0.5 * random.nextDouble()) / count;
      vertices[i] =
          new Vec2(
              (float) (size * StrictMath.cos(angle)),
              (float) (size * flat * StrictMath.sin(angle)));
    }
    PolygonShape polygon = new PolygonShape();
    polygon.set(vertices, count);
    return polygon;
  }

  /** Moves B along the shortest connection until the distance of the cores is {@code gap}. */
  static void moveToGap(Shape a, Transform xfA, Shape b, Transform xfB, double gap) {
    DistanceInput input = new DistanceInput();
    input.proxyA.set(a, 0);
    input.proxyB.set(b, 0);
    input.transformA = xfA;
    input.transformB = xfB;
    DistanceOutput output = new DistanceOutput();
    new Distance().distance(output, new Distance.SimplexCache(), input);
    if (output.distance > 0f) {
      float part = (float) ((gap - output.distance) / output.distance);
      xfB.p.addLocal(
          part * (output.pointB.x - output.pointA.x), part * (output.pointB.y - output.pointA.y));
    }
  }

  /** From 0.05 m to 20 m, evenly in the logarithm. */
  static float randomSize(Random random) {
    return (float) (0.05 * StrictMath.pow(400.0, random.nextDouble()));
  }

  static Transform at(double x, double y, double angle) {
    Transform xf = new Transform();
    xf.set(new Vec2((float) x, (float) y), (float) angle);
    return xf;
  }

  static double angle(Random random) {
    return (random.nextDouble() - 0.5) * 2.0 * Math.PI;
  }
}
