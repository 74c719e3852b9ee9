package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Contacts of polygons with single edges and with the links of chains. */
class EdgePolygonManifoldTest {

  private static final float TOLERANCE = 2e-5f;
  private static final double RADIUS = 2.0 * Settings.polygonRadius;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final WorldManifold world = new WorldManifold();
  private final Transform identity = new Transform();

  EdgePolygonManifoldTest() {
    identity.setIdentity();
  }

  @Property(tries = 3000, seed = "21")
  void singleEdgeTouchesExactlyWithinTheSkins(@ForAll long seed) {
    Random random = new Random(seed);
    float size = ConvexOracle.randomSize(random);
    PolygonShape polygon = ConvexOracle.randomPolygon(random, size);
    EdgeShape edge = new EdgeShape();
    edge.set(
        new Vec2(-size * (0.2f + random.nextFloat()), size * random.nextFloat()),
        new Vec2(size * (0.2f + random.nextFloat()), 0f));
    double reach = size * 2.0 * random.nextDouble();
    double direction = ConvexOracle.angle(random);
    Transform xfA = ConvexOracle.at(1.0, 2.0, ConvexOracle.angle(random));
    Transform xfB =
        ConvexOracle.at(
            1.0 + reach * StrictMath.cos(direction),
            2.0 + reach * StrictMath.sin(direction),
            ConvexOracle.angle(random));
    DistanceProxy proxy = new DistanceProxy();
    proxy.set(edge, 0);
    if (random.nextBoolean()) {
      ConvexOracle.moveToGap(edge, xfA, polygon, xfB, 1.5 * RADIUS * random.nextDouble());
    }
    double[] a = ConvexOracle.corners(proxy, xfA);
    double[] b = ConvexOracle.corners(polygon, xfB);
    double distance = ConvexOracle.distance(a, b);
    double tolerance = 2e-6 * (size + 4.0);

    collision.collideEdgeAndPolygon(manifold, edge, xfA, polygon, xfB);
    if (distance > RADIUS + tolerance) {
      assertEquals(0, manifold.pointCount);
    } else if (distance > 0.0 && distance < 0.95 * RADIUS - tolerance) {
      assertTrue(manifold.pointCount > 0, "no contact at " + distance);
    } else if (distance == 0.0) {
      assertTrue(manifold.pointCount > 0, "overlap without contact");
      world.initialize(manifold, xfA, edge.m_radius, xfB, polygon.m_radius);
      // Moving the polygon out along the normal by the depth ends the overlap.
      double depth = -RADIUS - ConvexOracle.separationAlong(world.normal.x, world.normal.y, a, b);
      double out = depth + RADIUS + 10.0 * tolerance;
      xfB.p.addLocal((float) (out * world.normal.x), (float) (out * world.normal.y));
      assertTrue(ConvexOracle.distance(a, ConvexOracle.corners(polygon, xfB)) > 0.0);
    }
  }

  @Test
  void boxSlidesOverAFlatChainWithTheFaceNormal() {
    ChainShape chain = chain(new float[] {0f, 0f, 1f, 0f, 2f, 0f, 2.5f, 0f, 3f, 0f, 5f, 0f});
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.3f, 0.2f);
    for (int side = -1; side <= 1; side += 2) {
      for (int depth = 0; depth < 8; depth++) {
        for (int k = 0; k < 500; k++) {
          double height = 0.2 + RADIUS - 0.0005 - 0.004 * depth;
          double tilt = 0.002 * (k % 7 - 3);
          Transform xfB = ConvexOracle.at(0.6 + 0.0071 * k, side * height, tilt);
          int points = touchAll(chain, box, xfB, (float) side);
          assertTrue(points >= 2 || depth == 0, "points " + points + " at " + xfB.p);
        }
      }
    }
  }

  /** Collides with each link; every normal must be that of the flat chain. */
  private int touchAll(ChainShape chain, PolygonShape box, Transform xfB, float side) {
    EdgeShape edge = new EdgeShape();
    int points = 0;
    for (int link = 0; link < chain.getChildCount(); link++) {
      chain.getChildEdge(edge, link);
      collision.collideEdgeAndPolygon(manifold, edge, identity, box, xfB);
      if (manifold.pointCount > 0) {
        world.initialize(manifold, identity, edge.m_radius, xfB, box.m_radius);
        assertEquals(0f, world.normal.x, TOLERANCE, "link " + link + " at " + xfB.p);
        assertEquals(side, world.normal.y, TOLERANCE);
      }
      points += manifold.pointCount;
    }
    return points;
  }

  @Test
  void cornerOfAHillTurnsTheNormalOnlyBetweenItsFaces() {
    // A box tips over a hilltop: flat, then down at 45 degrees.
    ChainShape hill = chain(new float[] {3f, -3f, 0f, 0f, -3f, 0f});
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.5f, 0.1f);
    EdgeShape edge = new EdgeShape();
    for (int k = 0; k <= 45; k++) {
      double tilt = -Math.PI / 180.0 * k;
      double h = 0.1 + RADIUS - 0.003;
      Transform xfB = ConvexOracle.at(-h * StrictMath.sin(tilt), h * StrictMath.cos(tilt), tilt);
      int points = 0;
      for (int link = 0; link < 2; link++) {
        hill.getChildEdge(edge, link);
        collision.collideEdgeAndPolygon(manifold, edge, identity, box, xfB);
        points += manifold.pointCount;
        if (manifold.pointCount > 0) {
          world.initialize(manifold, identity, edge.m_radius, xfB, box.m_radius);
          assertTrue(world.normal.y >= Math.sqrt(0.5) - TOLERANCE, "normal " + world.normal);
          assertTrue(world.normal.x >= -TOLERANCE, "normal " + world.normal);
          assertEquals(-StrictMath.sin(tilt), world.normal.x, 0.04, "tilt " + k);
        }
      }
      assertTrue(points > 0, "lost the hilltop at tilt " + k);
    }
  }

  @Test
  void valleyKeepsTheNormalsOfItsFaces() {
    ChainShape valley = chain(new float[] {3f, 3f, 0f, 0f, -3f, 0f});
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.2f, 0.2f);
    EdgeShape edge = new EdgeShape();
    for (int k = 0; k < 60; k++) {
      Transform xfB = ConvexOracle.at(-0.3 + 0.002 * k, 0.216, 0.0);
      for (int link = 0; link < 2; link++) {
        valley.getChildEdge(edge, link);
        collision.collideEdgeAndPolygon(manifold, edge, identity, box, xfB);
        if (manifold.pointCount > 0) {
          world.initialize(manifold, identity, edge.m_radius, xfB, box.m_radius);
          float root = (float) Math.sqrt(0.5);
          assertEquals(link == 0 ? -root : 0f, world.normal.x, TOLERANCE);
          assertEquals(link == 0 ? root : 1f, world.normal.y, TOLERANCE);
        }
      }
    }
  }

  @Test
  void edgeWithoutLengthActsAsAPoint() {
    EdgeShape edge = new EdgeShape();
    edge.m_vertex1.set(1f, 1f);
    edge.m_vertex2.set(1f, 1f);
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.5f, 0.5f);
    Transform xfB = ConvexOracle.at(1.2, 1.51, 0.0);
    collision.collideEdgeAndPolygon(manifold, edge, identity, box, xfB);
    assertEquals(1, manifold.pointCount);
    world.initialize(manifold, identity, edge.m_radius, xfB, box.m_radius);
    assertEquals(1f, world.normal.y, TOLERANCE);
    assertEquals(0.01f - RADIUS, world.separations[0], TOLERANCE);
  }

  @Test
  void pointStatesFollowTheIds() {
    Manifold before = new Manifold();
    Manifold after = new Manifold();
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-5f, 0f), new Vec2(5f, 0f));
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.5f, 0.5f);
    collision.collideEdgeAndPolygon(before, edge, identity, box, ConvexOracle.at(0.0, 0.515, 0.0));
    collision.collideEdgeAndPolygon(after, edge, identity, box, ConvexOracle.at(0.1, 0.52, 0.02));
    assertEquals(2, before.pointCount);
    assertEquals(1, after.pointCount);
    Collision.PointState[] states1 = new Collision.PointState[2];
    Collision.PointState[] states2 = new Collision.PointState[2];
    Collision.getPointStates(states1, states2, before, after);
    int persists = 0;
    int removed = 0;
    for (Collision.PointState state : states1) {
      persists += state == Collision.PointState.PERSIST_STATE ? 1 : 0;
      removed += state == Collision.PointState.REMOVE_STATE ? 1 : 0;
    }
    assertEquals(1, persists);
    assertEquals(1, removed);
    assertEquals(Collision.PointState.PERSIST_STATE, states2[0]);
    assertEquals(Collision.PointState.NULL_STATE, states2[1]);
    Collision.getPointStates(states1, states2, new Manifold(), after);
    assertEquals(Collision.PointState.ADD_STATE, states2[0]);
  }

  /** A chain through x0, y0, x1, y1, ... */
  private static ChainShape chain(float[] coordinates) {
    Vec2[] vertices = new Vec2[coordinates.length / 2];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = new Vec2(coordinates[2 * i], coordinates[2 * i + 1]);
    }
    ChainShape chain = new ChainShape();
    chain.createChain(vertices, vertices.length);
    return chain;
  }
}
