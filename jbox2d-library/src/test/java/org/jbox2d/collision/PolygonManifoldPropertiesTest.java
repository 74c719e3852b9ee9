package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.Manifold.ManifoldType;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;

/** Manifolds of random convex polygons against brute force. */
class PolygonManifoldPropertiesTest {

  private static final double RADIUS = 2.0 * Settings.polygonRadius;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final Manifold other = new Manifold();
  private final WorldManifold world = new WorldManifold();
  private final WorldManifold otherWorld = new WorldManifold();

  private PolygonShape a;
  private PolygonShape b;
  private Transform xfA;
  private Transform xfB;
  private double size;
  private double tolerance;

  @Property(tries = 3000, seed = "2")
  void normalIsTheAxisOfLeastPenetration(@ForAll long seed) {
    place(new Random(seed), true);
    double[] cornersA = ConvexOracle.corners(a, xfA);
    double[] cornersB = ConvexOracle.corners(b, xfB);
    double best = ConvexOracle.maxFaceSeparation(cornersA, cornersB);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    if (best > 0.0) {
      return;
    }
    assertTrue(manifold.pointCount > 0, "overlap without contact");
    world.initialize(manifold, xfA, a.m_radius, xfB, b.m_radius);
    double along = ConvexOracle.separationAlong(world.normal.x, world.normal.y, cornersA, cornersB);
    double margin = 0.1 * Settings.linearSlop + 0.02 * Math.abs(best);
    assertTrue(along <= best + tolerance);
    assertTrue(along >= best - 1.05 * margin - tolerance, along + " instead of " + best);
    double deepest = world.separations[0];
    if (manifold.pointCount == 2) {
      deepest = Math.min(deepest, world.separations[1]);
    }
    // The deepest vertex lies over the reference face, unless the margin chose the face.
    assertEquals(along - RADIUS, deepest, 1.05 * margin + tolerance);
  }

  @Property(tries = 3000, seed = "3")
  void contactExistsExactlyWithinTheSkins(@ForAll long seed) {
    Random random = new Random(seed);
    place(random, false);
    ConvexOracle.moveToGap(a, xfA, b, xfB, 1.5 * RADIUS * random.nextDouble());
    double[] cornersA = ConvexOracle.corners(a, xfA);
    double[] cornersB = ConvexOracle.corners(b, xfB);
    double distance = ConvexOracle.distance(cornersA, cornersB);
    if (distance == 0.0) {
      return;
    }
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    if (distance > RADIUS + tolerance) {
      assertEquals(0, manifold.pointCount);
    } else if (distance < 0.95 * RADIUS - tolerance) {
      // Between two corners the last twentieth may be lost: neither face need lead to both.
      assertTrue(manifold.pointCount > 0, "distance " + distance);
      world.initialize(manifold, xfA, a.m_radius, xfB, b.m_radius);
      double faces = ConvexOracle.maxFaceSeparation(cornersA, cornersB);
      double nearest = RADIUS + world.separations[0];
      if (manifold.pointCount == 2) {
        nearest = Math.min(nearest, RADIUS + world.separations[1]);
      }
      double margin = 0.1 * Settings.linearSlop + 0.02 * RADIUS;
      assertTrue(nearest <= distance + 2.0 * margin + tolerance, nearest + " at " + distance);
      if (distance < faces + 1e-9) {
        // A vertex over a face: the separation is the distance.
        assertEquals(distance, nearest, margin + tolerance);
      }
    }
  }

  @Property(tries = 2000, seed = "4")
  void swappingTheShapesTurnsTheNormal(@ForAll long seed) {
    place(new Random(seed), true);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    collision.collidePolygons(other, b, xfB, a, xfA);
    assertEquals(manifold.pointCount > 0, other.pointCount > 0);
    if (manifold.pointCount == 0 || (manifold.type == ManifoldType.FACE_A) == isFaceA(other)) {
      // Within the margin each call prefers its own first shape.
      return;
    }
    world.initialize(manifold, xfA, a.m_radius, xfB, b.m_radius);
    otherWorld.initialize(other, xfB, b.m_radius, xfA, a.m_radius);
    assertEquals(manifold.pointCount, other.pointCount);
    assertEquals(world.normal.x, -otherWorld.normal.x, 1e-5);
    assertEquals(world.normal.y, -otherWorld.normal.y, 1e-5);
    for (int i = 0; i < manifold.pointCount; i++) {
      assertEquals(world.points[i].x, otherWorld.points[i].x, 2.0 * tolerance);
      assertEquals(world.points[i].y, otherWorld.points[i].y, 2.0 * tolerance);
      other.points[i].id.flip();
      assertTrue(manifold.points[i].id.isEqual(other.points[i].id));
    }
  }

  @Property(tries = 2000, seed = "5")
  void pointsLieOnTheIncidentEdgeAndOverTheReferenceFace(@ForAll long seed) {
    place(new Random(seed), true);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    if (manifold.pointCount == 0) {
      return;
    }
    world.initialize(manifold, xfA, a.m_radius, xfB, b.m_radius);
    double[] reference = ConvexOracle.corners(isFaceA(manifold) ? a : b, xfOf(true));
    double[] incident = ConvexOracle.corners(isFaceA(manifold) ? b : a, xfOf(false));
    double sign = isFaceA(manifold) ? 1.0 : -1.0;
    for (int i = 0; i < manifold.pointCount; i++) {
      // The world point is the middle between the skins; go back to the incident core.
      double half = 0.5 * world.separations[i];
      double radius = Settings.polygonRadius;
      double px = world.points[i].x + sign * world.normal.x * (half + radius);
      double py = world.points[i].y + sign * world.normal.y * (half + radius);
      assertEquals(0.0, ConvexOracle.distanceToPoint(incident, px, py), 2.0 * tolerance);
      double fx = world.points[i].x - sign * world.normal.x * (half + radius);
      double fy = world.points[i].y - sign * world.normal.y * (half + radius);
      assertTrue(ConvexOracle.distanceToPoint(reference, fx, fy) <= RADIUS + tolerance);
    }
  }

  @Property(tries = 1000, seed = "6")
  void commonTranslationChangesNoBit(@ForAll long seed) {
    Random random = new Random(seed);
    place(random, true);
    // On a grid of 2^-8 m the shifted positions are exact, up to 2^15 m from the origin.
    snap(xfA);
    snap(xfB);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    float dx = random.nextInt(60000) - 30000;
    float dy = random.nextInt(60000) - 30000;
    xfA.p.addLocal(dx, dy);
    xfB.p.addLocal(dx, dy);
    collision.collidePolygons(other, a, xfA, b, xfB);
    assertEquals(manifold.pointCount, other.pointCount);
    if (manifold.pointCount > 0) {
      assertEquals(manifold.type, other.type);
      assertEquals(manifold.localNormal, other.localNormal);
      assertEquals(manifold.localPoint, other.localPoint);
    }
    for (int i = 0; i < manifold.pointCount; i++) {
      assertEquals(manifold.points[i].localPoint, other.points[i].localPoint);
      assertTrue(manifold.points[i].id.isEqual(other.points[i].id));
    }
  }

  @Property(tries = 1000, seed = "7")
  void idsSurviveSmallMotions(@ForAll long seed) {
    Random random = new Random(seed);
    a = new PolygonShape();
    a.setAsBox(2f, 0.5f);
    b = ConvexOracle.randomPolygon(random, 0.5f + random.nextFloat());
    // B rests on A with one of its faces.
    int face = random.nextInt(b.m_count);
    double turn = StrictMath.atan2(-1.0, 0.0) - angleOf(b, face);
    double height = 0.515 - heightOf(b, face, turn);
    double x = 0.5 * random.nextDouble();
    xfA = ConvexOracle.at(0.0, 0.0, 0.0);
    xfB = ConvexOracle.at(x, height, turn);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    assertEquals(2, manifold.pointCount);
    for (int step = 0; step < 20; step++) {
      xfB =
          ConvexOracle.at(
              x + 0.002 * random.nextGaussian(),
              height + 0.0005 * random.nextGaussian(),
              turn + 0.0002 * random.nextGaussian());
      collision.collidePolygons(other, a, xfA, b, xfB);
      assertEquals(2, other.pointCount);
      for (int i = 0; i < 2; i++) {
        assertTrue(manifold.points[i].id.isEqual(other.points[i].id), "step " + step);
      }
    }
  }

  /** Two polygons near each other; with {@code overlap} mostly overlapping. */
  private void place(Random random, boolean overlap) {
    float sizeA = ConvexOracle.randomSize(random);
    float sizeB = ConvexOracle.randomSize(random);
    a = ConvexOracle.randomPolygon(random, sizeA);
    b = ConvexOracle.randomPolygon(random, sizeB);
    size = sizeA + sizeB;
    double reach = overlap ? size * random.nextDouble() : size * 1.2;
    double direction = ConvexOracle.angle(random);
    xfA = ConvexOracle.at(1.0, -2.0, ConvexOracle.angle(random));
    xfB =
        ConvexOracle.at(
            1.0 + reach * StrictMath.cos(direction),
            -2.0 + reach * StrictMath.sin(direction),
            ConvexOracle.angle(random));
    tolerance = 2e-6 * (size + 4.0);
  }

  private Transform xfOf(boolean reference) {
    return isFaceA(manifold) == reference ? xfA : xfB;
  }

  private static boolean isFaceA(Manifold manifold) {
    return manifold.type == ManifoldType.FACE_A;
  }

  private static void snap(Transform xf) {
    xf.p.set(Math.round(xf.p.x * 256f) / 256f, Math.round(xf.p.y * 256f) / 256f);
  }

  private static double angleOf(PolygonShape polygon, int face) {
    return StrictMath.atan2(polygon.m_normals[face].y, polygon.m_normals[face].x);
  }

  /** Height of a face's start after a turn about the origin. */
  private static double heightOf(PolygonShape polygon, int face, double turn) {
    return StrictMath.sin(turn) * polygon.m_vertices[face].x
        + StrictMath.cos(turn) * polygon.m_vertices[face].y;
  }
}
