package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Tells whether the manifold of two polygons is still good: they have hardly moved against each
 * other since it was made. In a pile at rest that is so for most of the pairs, most of the time
 * (Box2D 3.2 has the idea under the name of contact recycling).
 *
 * <p>A manifold is kept in the bodies' frames, and solvers find depths from it where the bodies are
 * now; so those stay exact. What lags behind is which features touch, and where the edge of one
 * cuts off the face of the other. Polygons that do not touch are not looked at again before they
 * could have come to.
 *
 * <p>With {@code x = R w + t} the place of a point w of B in A's frame, {@code R = (c, -s; s, c)},
 * no point of B has gone further than
 *
 * <pre>  |t - t0| + |R - R0| max |w|,   |R - R0|^2 = (c - c0)^2 + (s - s0)^2</pre>
 *
 * <p>Programs may change shapes in place, and a listener the manifold; both are told by checksums:
 * that of a shape is taken once a step, however many contacts it has, that of the manifold after
 * the listener has had it.
 */
public final class KeptManifold {
  /**
   * Way that polygons in touch may go before their manifold is made anew, in linear slops. The slop
   * is the depth at which solvers leave contacts alone, so that a tenth of it is not felt.
   */
  private static final float HARMLESS_SLOPS = 0.1f;

  /** Factors of checksums: odd, so that no bit is lost. */
  private static final int FACTOR_X = 0x9E3779B1;

  private static final int FACTOR_Y = 0x85EBCA77;

  /**
   * What must have moved less since the manifold before, in ways that it may go, for a manifold to
   * be kept at all: what moves on as fast makes its manifold anew in the next step anyway.
   */
  private static final float CALM = 2f;

  // The place of B in A's frame where the manifold was made.
  private float c;
  private float s;
  private float tx;
  private float ty;

  /** Distance of B's farthest vertex from the origin of its frame, m. */
  private float reach;

  /** How far a point of B may go, m; 0 if nothing is kept. */
  private float room;

  private int shapes;
  private int content;

  /** Keeps nothing. */
  public void forget() {
    room = 0f;
  }

  /**
   * Keeps a manifold that has just been made, if it is likely to be good for longer.
   *
   * @param separation of the polygons, without their skins, at least, m
   * @param shapes {@link #checksum(PolygonShape)} of both polygons, {@link #joined}
   */
  public void keep(
      Manifold manifold,
      PolygonShape a,
      Transform xfA,
      PolygonShape b,
      Transform xfB,
      float separation,
      int shapes) {
    float cA = xfA.q.c;
    float sA = xfA.q.s;
    float gx = xfB.p.x - xfA.p.x;
    float gy = xfB.p.y - xfA.p.y;
    float x = cA * gx + sA * gy;
    float y = cA * gy - sA * gx;
    float dx = x - tx;
    float dy = y - ty;
    float way =
        manifold.pointCount > 0
            ? HARMLESS_SLOPS * Settings.linearSlop
            : separation - (a.m_radius + b.m_radius);
    tx = x;
    ty = y;
    if (way > 0f && dx * dx + dy * dy < CALM * CALM * way * way) {
      c = cA * xfB.q.c + sA * xfB.q.s;
      s = cA * xfB.q.s - sA * xfB.q.c;
      reach = reach(b);
      this.shapes = shapes;
      content = checksum(manifold);
      room = way;
    } else {
      room = 0f;
    }
  }

  private static float reach(PolygonShape polygon) {
    float most = 0f;
    for (int i = 0; i < polygon.m_count; i++) {
      Vec2 w = polygon.m_vertices[i];
      float square = w.x * w.x + w.y * w.y;
      most = square > most ? square : most;
    }
    return (float) Math.sqrt(most);
  }

  /** Whether the manifold that was kept is good for these places too, if the shapes are as then. */
  public boolean isGood(Transform xfA, Transform xfB) {
    if (room == 0f) {
      return false;
    }
    float cA = xfA.q.c;
    float sA = xfA.q.s;
    float gx = xfB.p.x - xfA.p.x;
    float gy = xfB.p.y - xfA.p.y;
    float dc = cA * xfB.q.c + sA * xfB.q.s - c;
    float ds = cA * xfB.q.s - sA * xfB.q.c - s;
    float dx = cA * gx + sA * gy - tx;
    float dy = cA * gy - sA * gx - ty;
    // (p + q)^2 is at most 2 p^2 + 2 q^2.
    return 2f * (dx * dx + dy * dy + reach * reach * (dc * dc + ds * ds)) < room * room;
  }

  /**
   * Whether the polygons are as they were when the manifold was kept.
   *
   * @param shapes as in {@link #keep}
   */
  public boolean isOf(int shapes) {
    return this.shapes == shapes;
  }

  /** Forgets a manifold that is no longer what was kept. */
  public void forgetIfChanged(Manifold manifold) {
    if (room != 0f && content != checksum(manifold)) {
      forget();
    }
  }

  /** One number for the checksums of A and B. */
  public static int joined(int a, int b) {
    return a + FACTOR_X * b;
  }

  /** Tells polygons apart, by all but certainty. */
  public static int checksum(PolygonShape polygon) {
    int sum = Float.floatToRawIntBits(polygon.m_radius);
    for (int i = 0; i < polygon.m_count; i++) {
      sum = FACTOR_X * sum + of(polygon.m_vertices[i]);
    }
    return sum;
  }

  private static int checksum(Manifold manifold) {
    int n = manifold.pointCount;
    int sum = n;
    if (n > 0) {
      sum = FACTOR_X * sum + manifold.type.ordinal();
      sum = FACTOR_X * sum + of(manifold.localNormal);
      sum = FACTOR_X * sum + of(manifold.localPoint);
      for (int i = 0; i < n; i++) {
        ManifoldPoint p = manifold.points[i];
        sum = FACTOR_X * sum + of(p.localPoint) + p.id.getKey();
      }
    }
    return sum;
  }

  private static int of(Vec2 v) {
    return Float.floatToRawIntBits(v.x) + FACTOR_Y * Float.floatToRawIntBits(v.y);
  }
}
