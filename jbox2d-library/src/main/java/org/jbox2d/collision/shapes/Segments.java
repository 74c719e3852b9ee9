package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * What edges and the children of chains have in common: a segment from {@code v1} to {@code v2} in
 * body coordinates.
 */
final class Segments {

  private Segments() {}

  /**
   * The ray and the segment both in body coordinates; the normal is the one that faces the ray.
   * Parallel rays miss.
   */
  static boolean raycast(RayCastOutput output, RayCastInput input, Transform xf, Vec2 v1, Vec2 v2) {
    Rot q = xf.q;
    double ox = (double) input.p1.x - xf.p.x;
    double oy = (double) input.p1.y - xf.p.y;
    double wx = (double) input.p2.x - input.p1.x;
    double wy = (double) input.p2.y - input.p1.y;
    double px = q.c * ox + q.s * oy - v1.x;
    double py = q.c * oy - q.s * ox - v1.y;
    double dx = q.c * wx + q.s * wy;
    double dy = q.c * wy - q.s * wx;
    double ex = (double) v2.x - v1.x;
    double ey = (double) v2.y - v1.y;

    // p + t d = s e, solved by cross products with e and with d
    double denominator = dx * ey - dy * ex;
    if (denominator == 0) {
      return false;
    }
    double t = (ex * py - ey * px) / denominator;
    double s = (dx * py - dy * px) / denominator;
    if (!(t >= 0 && t <= input.maxFraction && s >= 0 && s <= 1)) {
      return false;
    }

    double length = Math.sqrt(ex * ex + ey * ey);
    double side = denominator > 0 ? -1 : 1;
    float nx = (float) (side * ey / length);
    float ny = (float) (-side * ex / length);
    output.fraction = (float) t;
    output.normal.set(q.c * nx - q.s * ny, q.s * nx + q.c * ny);
    return true;
  }

  /**
   * Distance of {@code p} to the nearest point of the segment; on the segment the normal is its
   * right-hand one.
   */
  static float distance(Transform xf, Vec2 p, Vec2 v1, Vec2 v2, Vec2 normalOut) {
    Rot q = xf.q;
    double ox = (double) p.x - xf.p.x;
    double oy = (double) p.y - xf.p.y;
    double dx = q.c * ox + q.s * oy - v1.x;
    double dy = q.c * oy - q.s * ox - v1.y;
    double ex = (double) v2.x - v1.x;
    double ey = (double) v2.y - v1.y;
    double ee = ex * ex + ey * ey;
    double t = ee > 0 ? (dx * ex + dy * ey) / ee : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    double nx = dx - t * ex;
    double ny = dy - t * ey;
    double distance = Math.sqrt(nx * nx + ny * ny);
    double length = distance;
    if (distance == 0) {
      nx = ee > 0 ? ey : 1;
      ny = ee > 0 ? -ex : 0;
      length = Math.sqrt(nx * nx + ny * ny);
    }
    nx /= length;
    ny /= length;
    normalOut.set((float) (q.c * nx - q.s * ny), (float) (q.s * nx + q.c * ny));
    return (float) distance;
  }

  static void computeAABB(AABB aabb, Transform xf, Vec2 v1, Vec2 v2, float radius) {
    Rot q = xf.q;
    float x1 = q.c * v1.x - q.s * v1.y + xf.p.x;
    float y1 = q.s * v1.x + q.c * v1.y + xf.p.y;
    float x2 = q.c * v2.x - q.s * v2.y + xf.p.x;
    float y2 = q.s * v2.x + q.c * v2.y + xf.p.y;
    aabb.lowerBound.set(Math.min(x1, x2) - radius, Math.min(y1, y2) - radius);
    aabb.upperBound.set(Math.max(x1, x2) + radius, Math.max(y1, y2) + radius);
  }
}
