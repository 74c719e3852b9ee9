package org.jbox2d.benchmarks.scenes;

import java.util.Random;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;

/** Random convex polygons. */
final class Polygons {
  /** Part of its sector within which a vertex is placed; less than 1 keeps vertices apart. */
  private static final double SPREAD = 0.8;

  private Polygons() {}

  /** A convex polygon of 4 to 7 vertices on a circle, counter-clockwise. */
  static PolygonShape random(Random random, float radius) {
    int n = 4 + random.nextInt(4);
    Vec2[] vertices = new Vec2[n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + SPREAD * random.nextDouble()) / n;
      vertices[i] =
          new Vec2(
              (float) (radius * StrictMath.cos(angle)), (float) (radius * StrictMath.sin(angle)));
    }
    PolygonShape shape = new PolygonShape();
    shape.set(vertices, n);
    return shape;
  }
}
