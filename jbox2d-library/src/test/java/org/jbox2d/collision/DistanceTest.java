package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.Distance.SimplexCache;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** GJK against the least distance over all pairs of edges. */
class DistanceTest {

  /** Rounding of float transforms and results, for each metre of extent. */
  private static final double RELATIVE = 1e-6;

  private final Distance distance = new Distance();
  private final DistanceInput input = new DistanceInput();
  private final DistanceOutput output = new DistanceOutput();
  private final SimplexCache cache = new SimplexCache();

  @Property(tries = 3000, seed = "1")
  void agreesWithBruteForce(@ForAll long seed) {
    Random random = new Random(seed);
    double sizeA = randomProxy(random, input.proxyA);
    double sizeB = randomProxy(random, input.proxyB);
    double reach = (sizeA + sizeB) * 2.0 * random.nextDouble();
    double direction = ConvexOracle.angle(random);
    input.transformA = ConvexOracle.at(3.0, -2.0, ConvexOracle.angle(random));
    input.transformB =
        ConvexOracle.at(
            3.0 + reach * StrictMath.cos(direction),
            -2.0 + reach * StrictMath.sin(direction),
            ConvexOracle.angle(random));
    double[] a = ConvexOracle.corners(input.proxyA, input.transformA);
    double[] b = ConvexOracle.corners(input.proxyB, input.transformB);
    double expected = ConvexOracle.distance(a, b);
    double tolerance = RELATIVE * (sizeA + sizeB + reach + 4.0);

    input.useRadii = false;
    cache.count = 0;
    distance.distance(output, cache, input);
    assertEquals(expected, output.distance, tolerance);
    assertTrue(output.iterations < 15, "iterations " + output.iterations);
    assertEquals(
        expected,
        Math.hypot(output.pointA.x - output.pointB.x, output.pointA.y - output.pointB.y),
        2.0 * tolerance);
    assertEquals(0.0, ConvexOracle.distanceToPoint(a, output.pointA.x, output.pointA.y), tolerance);
    assertEquals(0.0, ConvexOracle.distanceToPoint(b, output.pointB.x, output.pointB.y), tolerance);

    // Any start simplex gives the same distance, also one of other proxies.
    float cold = output.distance;
    cache.count = 1 + random.nextInt(3);
    for (int i = 0; i < cache.count; i++) {
      cache.indexA[i] = random.nextInt(8);
      cache.indexB[i] = random.nextInt(8);
    }
    distance.distance(output, cache, input);
    assertEquals(cold, output.distance, tolerance);
    distance.distance(output, cache, input);
    assertEquals(cold, output.distance, tolerance);
    assertTrue(output.iterations <= 1, "warm start took " + output.iterations);

    input.proxyA.m_radius = 0.25f;
    input.proxyB.m_radius = 0.5f;
    input.useRadii = true;
    distance.distance(output, cache, input);
    assertEquals(Math.max(0.0, expected - 0.75), output.distance, tolerance);
    assertEquals(
        output.distance,
        Math.hypot(output.pointA.x - output.pointB.x, output.pointA.y - output.pointB.y),
        2.0 * tolerance);
  }

  @Test
  void coincidentAndCollinearCornersEnd() {
    DistanceProxy a = input.proxyA;
    a.m_count = 4;
    for (int i = 0; i < 4; i++) {
      a.m_vertices[i].set(1f, 2f);
    }
    DistanceProxy b = input.proxyB;
    b.m_count = 5;
    for (int i = 0; i < 5; i++) {
      b.m_vertices[i].set(4f + (i % 3), 6f);
    }
    input.useRadii = false;
    distance.distance(output, cache, input);
    assertEquals(5f, output.distance, 1e-6f);

    b.m_count = 4;
    for (int i = 0; i < 4; i++) {
      b.m_vertices[i].set(1f, 2f);
    }
    distance.distance(output, cache, input);
    assertEquals(0f, output.distance);
    assertEquals(1f, output.pointA.x);
    assertEquals(2f, output.pointB.y);
  }

  @Test
  void distanceKeepsItsDigitsFarFromTheOrigin() {
    CircleShape circle = new CircleShape();
    circle.m_radius = 1f;
    input.proxyA.set(circle, 0);
    input.proxyB.set(circle, 0);
    input.transformA = ConvexOracle.at(1048576.0, -524288.0, 0.3);
    input.transformB = ConvexOracle.at(1048579.0, -524284.0, -0.7);
    input.useRadii = true;
    distance.distance(output, cache, input);
    assertEquals(3f, output.distance, 1e-6f);
  }

  @Test
  void proxiesTakeAllKindsOfShapes() {
    DistanceProxy proxy = new DistanceProxy();
    CircleShape circle = new CircleShape();
    circle.m_p.set(1f, 2f);
    circle.m_radius = 3f;
    proxy.set(circle, 0);
    assertEquals(1, proxy.getVertexCount());
    assertEquals(new Vec2(1f, 2f), proxy.getVertex(0));
    assertEquals(3f, proxy.m_radius);

    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(1f, 0f), new Vec2(2f, 5f));
    proxy.set(edge, 0);
    assertEquals(2, proxy.getVertexCount());
    assertEquals(1, proxy.getSupport(new Vec2(0f, 1f)));

    ChainShape chain = new ChainShape();
    chain.createLoop(new Vec2[] {new Vec2(0f, 0f), new Vec2(1f, 0f), new Vec2(0f, 1f)}, 3);
    proxy.set(chain, 2);
    assertEquals(new Vec2(0f, 1f), proxy.getVertex(0));
    assertEquals(new Vec2(0f, 0f), proxy.getVertex(1));
    assertEquals(new Vec2(0f, 0f), proxy.m_buffer[1]);
    assertThrows(IllegalArgumentException.class, () -> proxy.set(chain, -1));

    PolygonShape box = new PolygonShape();
    box.setAsBox(1f, 2f);
    proxy.set(box, 0);
    assertEquals(4, proxy.getVertexCount());
    assertEquals(new Vec2(1f, 2f), proxy.getSupportVertex(new Vec2(1f, 1f)));
  }

  /** Point, segment (sometimes without length) or polygon; returns its extent. */
  private static double randomProxy(Random random, DistanceProxy proxy) {
    float size = ConvexOracle.randomSize(random);
    switch (random.nextInt(4)) {
      case 0:
        proxy.m_count = 1;
        proxy.m_vertices[0].set(size * random.nextFloat(), size * random.nextFloat());
        break;
      case 1:
        proxy.m_count = 2;
        proxy.m_vertices[0].set(size * random.nextFloat(), -size * random.nextFloat());
        if (random.nextInt(4) == 0) {
          proxy.m_vertices[1].set(proxy.m_vertices[0]);
        } else {
          proxy.m_vertices[1].set(-size * random.nextFloat(), size * random.nextFloat());
        }
        break;
      default:
        proxy.set(ConvexOracle.randomPolygon(random, size), 0);
        break;
    }
    proxy.m_radius = 0f;
    return size;
  }
}
