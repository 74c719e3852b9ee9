package org.jbox2d.collision.shapes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PolygonHullTest {

  @Provide
  Arbitrary<Vec2[]> points() {
    Arbitrary<Float> coordinate =
        Arbitraries.oneOf(
            Arbitraries.floats().between(-1, 1),
            Arbitraries.integers().between(-3, 3).map(i -> i * 0.25f));
    Arbitrary<Vec2> point = Combinators.combine(coordinate, coordinate).as(Vec2::new);
    Arbitrary<Float> scale = Arbitraries.of(0.05f, 1f, 30f, 1000f);
    Arbitrary<Float> offset = Arbitraries.of(0f, 0f, 100f, -10_000f);
    return Combinators.combine(point.array(Vec2[].class).ofMinSize(3).ofMaxSize(8), scale, offset)
        .as(PolygonHullTest::place);
  }

  private static Vec2[] place(Vec2[] points, float scale, float offset) {
    return Arrays.stream(points)
        .map(p -> new Vec2(p.x * scale + offset, p.y * scale - offset))
        .toArray(Vec2[]::new);
  }

  @Property(tries = 2000, seed = "51")
  void hullsAreConvexHoldTheirInputAndAreTheirOwnHulls(@ForAll("points") Vec2[] points) {
    PolygonShape shape = new PolygonShape();
    Assume.that(hasAreaAndSets(shape, points));

    assertTrue(shape.validate());
    List<Vec2> input = Arrays.asList(points);
    float reach = reach(points);
    for (int i = 0; i < shape.m_count; i++) {
      Vec2 vertex = shape.m_vertices[i];
      assertTrue(input.contains(vertex), () -> vertex + " is none of the points");
      assertEquals(1f, shape.m_normals[i].length(), 1e-6f);
      for (Vec2 p : points) {
        double height =
            shape.m_normals[i].x * ((double) p.x - vertex.x)
                + shape.m_normals[i].y * ((double) p.y - vertex.y);
        double tolerance = 0.5 * Settings.linearSlop + 16 * Settings.EPSILON * reach;
        assertTrue(height <= tolerance, () -> p + " sticks out by " + height);
      }
    }
    assertStartsAtLowestOfRightmost(shape);

    PolygonShape again = new PolygonShape();
    again.set(shape.m_vertices, shape.m_count);
    assertArrayEquals(vertices(shape), vertices(again));
  }

  @Property(tries = 500, seed = "52")
  void theOrderOfThePointsDoesNotMatterIfTheyAreApart(@ForAll("points") Vec2[] points) {
    Assume.that(areApart(points));
    PolygonShape shape = new PolygonShape();
    Assume.that(hasAreaAndSets(shape, points));
    Vec2[] reversed = points.clone();
    for (int i = 0; i < points.length; i++) {
      reversed[i] = points[points.length - 1 - i];
    }
    PolygonShape other = new PolygonShape();
    other.set(reversed, reversed.length);
    assertArrayEquals(vertices(shape), vertices(other));
  }

  @Test
  void collinearAndInnerPointsAreDropped() {
    PolygonShape shape = new PolygonShape();
    Vec2[] points = points(0, 0, 0.5f, 0, 1, 0, 1, 1, 0.5f, 0.5f, 0, 1, 0, 0.4f);
    shape.set(points, points.length);
    assertArrayEquals(points(1, 0, 1, 1, 0, 1, 0, 0), vertices(shape));
    assertEquals(new Vec2(0.5f, 0.5f), shape.m_centroid);
    assertEquals(8, shape.m_vertices.length);
  }

  /** Points on a slanted line are rounded to float, so their cross product is not exactly zero. */
  @ParameterizedTest
  @ValueSource(floats = {0.01f, 1f, 1000f})
  void pointsOnASlantedEdgeAreDroppedInAllSizes(float size) {
    for (int k = 1; k < 40; k++) {
      float t = k / 40f;
      Vec2 a = new Vec2(0.1f * size, 0.3f * size);
      Vec2 b = new Vec2(1.7f * size, 1.1f * size);
      Vec2 between = new Vec2(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
      PolygonShape shape = new PolygonShape();
      shape.set(new Vec2[] {a, between, b, new Vec2(-size, 2 * size)}, 4);
      assertEquals(3, shape.m_count);
    }
  }

  /** A regular octagon is as far from collinear as its size allows. */
  @ParameterizedTest
  @ValueSource(floats = {0.01f, 1f, 1000f})
  void octagonsKeepAllVerticesInAllSizes(float radius) {
    Vec2[] points = new Vec2[8];
    for (int i = 0; i < 8; i++) {
      float angle = i * MathUtils.QUARTER_PI;
      points[i] = new Vec2(radius * MathUtils.cos(angle), radius * MathUtils.sin(angle));
    }
    PolygonShape shape = new PolygonShape();
    shape.set(points, 8);
    assertEquals(8, shape.m_count);
  }

  @Test
  void pointsCloserThanHalfTheSlopAreMerged() {
    float near = 0.4f * Settings.linearSlop;
    PolygonShape shape = new PolygonShape();
    shape.set(points(0, 0, 1, 0, 1, near, 0.5f, 1), 4);
    assertArrayEquals(points(1, 0, 0.5f, 1, 0, 0), vertices(shape));
  }

  @Test
  void theVerticesOfTheShapeItselfMayBeItsInput() {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(1, 2);
    shape.m_vertices[0].set(-3, -2);
    shape.set(shape.m_vertices, 4);
    assertArrayEquals(points(1, -2, 1, 2, -1, 2, -3, -2), vertices(shape));
  }

  @Test
  void thePooledOverloadDoesTheSame() {
    PolygonShape shape = new PolygonShape();
    shape.set(points(0, 0, 1, 0, 0, 1), 3, null, null);
    assertArrayEquals(points(1, 0, 0, 1, 0, 0), vertices(shape));
  }

  @Test
  void badInputIsNamedAndChangesNothing() {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(1, 1);
    Vec2[] before = vertices(shape);
    assertRefused(shape, "finite: (NaN", points(0, 0, 1, 0, Float.NaN, 1));
    assertRefused(shape, "finite: (0.0,-Infinity", points(1, 0, 1, 1, 0, Float.NEGATIVE_INFINITY));
    assertRefused(shape, ": 2", points(0, 0, 1, 0));
    assertRefused(shape, ": 9", points(0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 8));
    assertRefused(shape, "only 2 of 3", points(0, 0, 1, 0, 1, 0.001f));
    assertRefused(shape, "collinear", points(0, 0, 1, 1, 2, 2));
    assertRefused(shape, "collinear", points(0.1f, 0.1f, 0.7f, 0.7f, 100.3f, 100.3f));
    IllegalArgumentException more =
        assertThrows(IllegalArgumentException.class, () -> shape.set(points(0, 0, 1, 0, 0, 1), 4));
    assertTrue(more.getMessage().contains(": 4"));
    assertArrayEquals(before, vertices(shape));
  }

  @ParameterizedTest
  @ValueSource(floats = {0f, -1f, Float.NaN, Float.POSITIVE_INFINITY})
  void badBoxSizesAreRefused(float size) {
    PolygonShape shape = new PolygonShape();
    String value = String.valueOf(size);
    for (IllegalArgumentException e :
        List.of(
            assertThrows(IllegalArgumentException.class, () -> shape.setAsBox(size, 1)),
            assertThrows(IllegalArgumentException.class, () -> shape.setAsBox(1, size)),
            assertThrows(
                IllegalArgumentException.class, () -> shape.setAsBox(1, size, new Vec2(), 0)))) {
      assertTrue(e.getMessage().endsWith(value), e.getMessage());
    }
    assertEquals(0, shape.m_count);
  }

  @Test
  void badBoxPlacesAreRefused() {
    PolygonShape shape = new PolygonShape();
    assertThrows(
        IllegalArgumentException.class, () -> shape.setAsBox(1, 1, new Vec2(Float.NaN, 0), 0));
    assertThrows(
        IllegalArgumentException.class,
        () -> shape.setAsBox(1, 1, new Vec2(), Float.POSITIVE_INFINITY));
    assertEquals(0, shape.m_count);
  }

  @Test
  void boxesGoRoundFromTheLowerLeft() {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(2, 1);
    assertArrayEquals(points(-2, -1, 2, -1, 2, 1, -2, 1), vertices(shape));
    assertTrue(shape.validate());
    shape.setAsBox(2, 1, new Vec2(5, 6), MathUtils.HALF_PI);
    assertEquals(new Vec2(5, 6), shape.m_centroid);
    assertEquals(0f, shape.m_vertices[0].sub(new Vec2(6, 4)).length(), 1e-6f);
    assertEquals(0f, shape.m_normals[0].sub(new Vec2(1, 0)).length(), 1e-6f);
    assertTrue(shape.validate());
  }

  @Test
  void validateFindsClockwiseAndConcavePolygonsWrittenByHand() {
    PolygonShape shape = new PolygonShape();
    assertFalse(shape.validate());
    shape.setAsBox(1, 1);
    shape.m_vertices[2].set(-0.5f, -0.5f);
    assertFalse(shape.validate());
    shape.setAsBox(1, 1);
    Vec2 corner = shape.m_vertices[1].clone();
    shape.m_vertices[1].set(shape.m_vertices[3]);
    shape.m_vertices[3].set(corner);
    assertFalse(shape.validate());
  }

  @Test
  void clonesShareNothing() {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(1, 1);
    shape.m_radius = 0.5f;
    PolygonShape copy = (PolygonShape) shape.clone();
    shape.m_vertices[0].set(9, 9);
    shape.m_normals[0].set(9, 9);
    assertEquals(new Vec2(-1, -1), copy.getVertex(0));
    assertEquals(new Vec2(0, -1), copy.getNormals()[0]);
    assertEquals(4, copy.getVertexCount());
    assertEquals(0.5f, copy.getRadius());
  }

  /** The limit may be assigned between the making of a shape and that of a fixture. */
  @Test
  void clonesKeepTheirCapacityWhateverTheSettings() {
    int before = Settings.maxPolygonVertices;
    try {
      Settings.maxPolygonVertices = 12;
      PolygonShape wide = new PolygonShape();
      Vec2[] points = new Vec2[12];
      for (int i = 0; i < 12; i++) {
        float angle = i * MathUtils.TWOPI / 12;
        points[i] = new Vec2(MathUtils.cos(angle), MathUtils.sin(angle));
      }
      wide.set(points, 12);
      Settings.maxPolygonVertices = 8;
      PolygonShape copy = (PolygonShape) wide.clone();
      assertArrayEquals(vertices(wide), vertices(copy));
      assertEquals(12, copy.m_count);
    } finally {
      Settings.maxPolygonVertices = before;
    }
  }

  private static void assertRefused(PolygonShape shape, String named, Vec2[] points) {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> shape.set(points, points.length));
    assertTrue(e.getMessage().contains(named), e.getMessage());
  }

  private static void assertStartsAtLowestOfRightmost(PolygonShape shape) {
    Vec2 first = shape.m_vertices[0];
    for (int i = 1; i < shape.m_count; i++) {
      Vec2 v = shape.m_vertices[i];
      assertTrue(v.x < first.x || v.x == first.x && v.y > first.y);
    }
  }

  /** Sets the points; if they are refused, they must be flat or close together. */
  private static boolean hasAreaAndSets(PolygonShape shape, Vec2[] points) {
    float reach = reach(points);
    if (largestTriangle(points) > 4 * reach * (Settings.linearSlop + 1e-5 * reach)) {
      shape.set(points, points.length);
      return true;
    }
    try {
      shape.set(points, points.length);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  private static double largestTriangle(Vec2[] points) {
    double largest = 0;
    for (Vec2 a : points) {
      for (Vec2 b : points) {
        for (Vec2 c : points) {
          double cross =
              ((double) b.x - a.x) * ((double) c.y - a.y)
                  - ((double) b.y - a.y) * ((double) c.x - a.x);
          largest = Math.max(largest, cross);
        }
      }
    }
    return largest;
  }

  private static boolean areApart(Vec2[] points) {
    for (int i = 0; i < points.length; i++) {
      for (int j = 0; j < i; j++) {
        if (MathUtils.distance(points[i], points[j]) <= Settings.linearSlop) {
          return false;
        }
      }
    }
    return true;
  }

  private static float reach(Vec2[] points) {
    float reach = 0;
    for (Vec2 p : points) {
      reach = Math.max(reach, Math.max(Math.abs(p.x), Math.abs(p.y)));
    }
    return reach;
  }

  private static Vec2[] points(float... coordinates) {
    Vec2[] points = new Vec2[coordinates.length / 2];
    for (int i = 0; i < points.length; i++) {
      points[i] = new Vec2(coordinates[2 * i], coordinates[2 * i + 1]);
    }
    return points;
  }

  private static Vec2[] vertices(PolygonShape shape) {
    Vec2[] vertices = new Vec2[shape.m_count];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = shape.m_vertices[i].clone();
    }
    return vertices;
  }
}
