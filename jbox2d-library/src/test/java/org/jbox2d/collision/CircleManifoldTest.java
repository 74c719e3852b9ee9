package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.Manifold.ManifoldType;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Contacts of circles, against formulas and brute force. */
class CircleManifoldTest {

  private static final float TOLERANCE = 1e-5f;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final WorldManifold world = new WorldManifold();

  @Test
  void circlesTouchAlongTheirCentres() {
    CircleShape a = circle(1f, 0.5f, 0f);
    CircleShape b = circle(2f, 0f, 0f);
    Transform xfA = ConvexOracle.at(-0.5, 0.0, 0.0);
    Transform xfB = ConvexOracle.at(1.2, 1.6, 1.0);
    collision.collideCircles(manifold, a, xfA, b, xfB);
    assertEquals(1, manifold.pointCount);
    assertEquals(ManifoldType.CIRCLES, manifold.type);
    world.initialize(manifold, xfA, a.m_radius, xfB, b.m_radius);
    assertEquals(0.6f, world.normal.x, TOLERANCE);
    assertEquals(0.8f, world.normal.y, TOLERANCE);
    assertEquals(-1f, world.separations[0], TOLERANCE);

    collision.collideCircles(manifold, a, xfA, b, ConvexOracle.at(3.01, 0.0, 0.0));
    assertEquals(0, manifold.pointCount);
  }

  @Property(tries = 3000, seed = "11")
  void polygonAndCircleAgreeWithBruteForce(@ForAll long seed) {
    Random random = new Random(seed);
    float size = ConvexOracle.randomSize(random);
    PolygonShape polygon = ConvexOracle.randomPolygon(random, size);
    CircleShape circle = circle(0.5f * ConvexOracle.randomSize(random), 0.3f * size, 0f);
    double reach = (size + circle.m_radius) * 1.3 * random.nextDouble();
    double direction = ConvexOracle.angle(random);
    Transform xfA = ConvexOracle.at(2.0, 1.0, ConvexOracle.angle(random));
    Transform xfB =
        ConvexOracle.at(
            2.0 + reach * StrictMath.cos(direction),
            1.0 + reach * StrictMath.sin(direction),
            ConvexOracle.angle(random));
    double cx = xfB.p.x + (double) xfB.q.c * circle.m_p.x;
    double cy = xfB.p.y + (double) xfB.q.s * circle.m_p.x;
    double[] corners = ConvexOracle.corners(polygon, xfA);
    double distance = ConvexOracle.distanceToPoint(corners, cx, cy);
    double core = distance > 0.0 ? distance : faceSeparation(corners, cx, cy);
    double radius = polygon.m_radius + circle.m_radius;
    double tolerance = 2e-6 * (size + reach + 4.0);

    collision.collidePolygonAndCircle(manifold, polygon, xfA, circle, xfB);
    if (distance > radius + tolerance) {
      assertEquals(0, manifold.pointCount);
    } else if (distance < radius - tolerance) {
      assertEquals(1, manifold.pointCount);
      world.initialize(manifold, xfA, polygon.m_radius, xfB, circle.m_radius);
      assertEquals(core - radius, world.separations[0], 2.0 * tolerance);
      // The normal points out of the polygon, along the shortest way.
      double along =
          ConvexOracle.separationAlong(
              world.normal.x, world.normal.y, corners, new double[] {cx, cy});
      assertEquals(core, along, 2.0 * tolerance);
    }
  }

  @Property(tries = 2000, seed = "12")
  void edgeAndCircleTouchOnBothSidesAndRoundTheEnds(@ForAll long seed) {
    Random random = new Random(seed);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(random.nextFloat(), random.nextFloat()), new Vec2(-2f, random.nextFloat()));
    CircleShape circle = circle(0.1f + random.nextFloat(), 0f, 0f);
    Transform xfA = ConvexOracle.at(0.0, 0.0, ConvexOracle.angle(random));
    Transform xfB =
        ConvexOracle.at(4.0 * random.nextDouble() - 2.0, 4.0 * random.nextDouble() - 2.0, 0.5);
    Distance.DistanceProxy proxy = new Distance.DistanceProxy();
    proxy.set(edge, 0);
    double distance =
        ConvexOracle.distanceToPoint(ConvexOracle.corners(proxy, xfA), xfB.p.x, xfB.p.y);
    double radius = edge.m_radius + circle.m_radius;
    collision.collideEdgeAndCircle(manifold, edge, xfA, circle, xfB);
    if (distance > radius + TOLERANCE) {
      assertEquals(0, manifold.pointCount);
    } else if (distance < radius - TOLERANCE) {
      assertEquals(1, manifold.pointCount);
      world.initialize(manifold, xfA, edge.m_radius, xfB, circle.m_radius);
      assertEquals(distance - radius, world.separations[0], TOLERANCE);
    }
  }

  @Test
  void circleRollsOverAChainWithTheFaceNormal() {
    // Links of 0.5 m on a line, with ghosts: each contact has the line's normal.
    CircleShape circle = circle(0.3f, 0f, 0f);
    Transform xfA = ConvexOracle.at(0.0, 0.0, 0.0);
    for (int k = 0; k < 200; k++) {
      Transform xfB = ConvexOracle.at(0.6 + 0.009 * k, 0.305, 0.0);
      int touching = 0;
      for (int link = 0; link < 6; link++) {
        collision.collideEdgeAndCircle(manifold, link(link), xfA, circle, xfB);
        if (manifold.pointCount > 0) {
          touching++;
          world.initialize(manifold, xfA, Settings.polygonRadius, xfB, circle.m_radius);
          assertEquals(0f, world.normal.x, TOLERANCE);
          assertEquals(1f, world.normal.y, TOLERANCE);
        }
      }
      assertTrue(touching >= 1 && touching <= 2, "links touched: " + touching);
    }
  }

  /** Greatest height of a point above the lines of a counter-clockwise polygon's faces. */
  private static double faceSeparation(double[] corners, double x, double y) {
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < corners.length; i += 2) {
      int k = (i + 2) % corners.length;
      double ex = corners[k] - corners[i];
      double ey = corners[k + 1] - corners[i + 1];
      double height = ey * (x - corners[i]) - ex * (y - corners[i + 1]);
      best = Math.max(best, height / Math.hypot(ex, ey));
    }
    return best;
  }

  private static EdgeShape link(int index) {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(0.5f * index, 0f), new Vec2(0.5f * index + 0.5f, 0f));
    edge.m_vertex0.set(0.5f * index - 0.5f, 0f);
    edge.m_vertex3.set(0.5f * index + 1f, 0f);
    edge.m_hasVertex0 = true;
    edge.m_hasVertex3 = true;
    return edge;
  }

  private static CircleShape circle(float radius, float x, float y) {
    CircleShape circle = new CircleShape();
    circle.m_radius = radius;
    circle.m_p.set(x, y);
    return circle;
  }
}
