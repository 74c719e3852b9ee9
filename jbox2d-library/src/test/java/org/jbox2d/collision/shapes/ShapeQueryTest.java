package org.jbox2d.collision.shapes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import net.jqwik.api.constraints.IntRange;
import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Points, rays, distances and boxes. */
class ShapeQueryTest {

  private static final float CLOSE = 2e-5f;

  @Property(tries = 500, seed = "71")
  void aRayHitsWhereTheDistanceBecomesZero(
      @ForAll @IntRange(min = 0, max = 3) int kind,
      @ForAll @FloatRange(min = -3, max = 3) float angle,
      @ForAll @FloatRange(min = -8, max = 8) float x1,
      @ForAll @FloatRange(min = -8, max = 8) float y1,
      @ForAll @FloatRange(min = -8, max = 8) float x2,
      @ForAll @FloatRange(min = -8, max = 8) float y2) {
    Shape shape = shape(kind);
    Transform xf = transform(angle);
    RayCastInput input = input(x1, y1, x2, y2, 1);
    RayCastOutput output = new RayCastOutput();
    Vec2 normal = new Vec2();
    for (int child = 0; child < shape.getChildCount(); child++) {
      boolean startsInside = shape.computeDistanceToOut(xf, input.p1, child, normal) <= CLOSE;
      boolean hit = shape.raycast(output, input, xf, child);
      float until = hit ? output.fraction : 1f;
      if (!startsInside) {
        assertFreeUntil(shape, xf, child, input, until);
      }
      if (hit) {
        Vec2 at = along(input, until);
        assertEquals(0f, shape.computeDistanceToOut(xf, at, child, normal), CLOSE);
        assertEquals(1f, output.normal.length(), 1e-5f);
        assertTrue(Vec2.dot(output.normal, input.p2.sub(input.p1)) <= CLOSE);
      }
    }
  }

  /** Short of the hit, no point is in a solid shape, and a line is not crossed. */
  private static void assertFreeUntil(
      Shape shape, Transform xf, int child, RayCastInput input, float until) {
    Vec2 normal = new Vec2();
    float last = 0;
    for (int i = 0; i <= 200; i++) {
      float t = until * i / 200f;
      float distance = shape.computeDistanceToOut(xf, along(input, t), child, normal);
      assertTrue(distance >= -CLOSE, () -> "inside at " + t + " before " + until);
      if (i > 0 && i < 200) {
        float step = input.p2.sub(input.p1).length() * until / 200;
        assertTrue(Math.abs(distance - last) <= step + CLOSE);
      }
      last = distance;
    }
  }

  @Property(tries = 500, seed = "72")
  void distancesGrowAlongTheirNormalAndAgreeWithTestPoint(
      @ForAll @IntRange(min = 0, max = 3) int kind,
      @ForAll @FloatRange(min = -3, max = 3) float angle,
      @ForAll @FloatRange(min = -6, max = 6) float x,
      @ForAll @FloatRange(min = -6, max = 6) float y) {
    Shape shape = shape(kind);
    Transform xf = transform(angle);
    Vec2 p = new Vec2(x, y);
    Vec2 normal = new Vec2();
    Vec2 ignored = new Vec2();
    for (int child = 0; child < shape.getChildCount(); child++) {
      float distance = shape.computeDistanceToOut(xf, p, child, normal);
      assertEquals(1f, normal.length(), 1e-5f);
      Vec2 nearest = p.sub(normal.mul(distance));
      assertEquals(0f, shape.computeDistanceToOut(xf, nearest, child, ignored), CLOSE);
      if (distance > 0) {
        Vec2 farther = p.add(normal);
        assertEquals(distance + 1, shape.computeDistanceToOut(xf, farther, child, ignored), CLOSE);
      }
      if (kind < 2 && Math.abs(distance) > CLOSE) {
        assertEquals(distance < 0, shape.testPoint(xf, p));
      }
      if (kind >= 2) {
        assertTrue(distance >= 0);
        assertFalse(shape.testPoint(xf, p));
      }
    }
  }

  @Property(tries = 300, seed = "73")
  void boxesHoldTheShapeAndItsSkinAndNoMore(
      @ForAll @IntRange(min = 0, max = 3) int kind,
      @ForAll @FloatRange(min = -3, max = 3) float angle) {
    Shape shape = shape(kind);
    Transform xf = transform(angle);
    AABB box = new AABB();
    Vec2 normal = new Vec2();
    for (int child = 0; child < shape.getChildCount(); child++) {
      shape.computeAABB(box, xf, child);
      float skin = kind == 0 ? 0 : shape.m_radius;
      assertTrue(box.isValid());
      for (int side = 0; side < 4; side++) {
        float least = Float.POSITIVE_INFINITY;
        for (int i = 0; i <= 2000; i++) {
          Vec2 p = onSide(box, side, i / 2000f);
          least = Math.min(least, shape.computeDistanceToOut(xf, p, child, normal));
        }
        assertEquals(skin, least, 2e-3f);
        assertTrue(least >= skin - CLOSE);
      }
    }
  }

  private static Vec2 onSide(AABB box, int side, float t) {
    float x = box.lowerBound.x + t * (box.upperBound.x - box.lowerBound.x);
    float y = box.lowerBound.y + t * (box.upperBound.y - box.lowerBound.y);
    switch (side) {
      case 0:
        return new Vec2(x, box.lowerBound.y);
      case 1:
        return new Vec2(box.upperBound.x, y);
      case 2:
        return new Vec2(x, box.upperBound.y);
      default:
        return new Vec2(box.lowerBound.x, y);
    }
  }

  @Test
  void raysAtACircle() {
    Shape circle = shape(0);
    Transform xf = new Transform();
    RayCastOutput output = new RayCastOutput();
    assertTrue(circle.raycast(output, input(0.5f, 10, 0.5f, 0, 1), xf, 0));
    assertEquals(0.8f, output.fraction, 1e-6f);
    assertEquals(0f, output.normal.sub(new Vec2(0, 1)).length(), 1e-6f);
    assertFalse(circle.raycast(output, input(0.5f, 10, 0.5f, 0, 0.79f), xf, 0));
    assertFalse(circle.raycast(output, input(0.5f, 0.5f, 9, 9, 1), xf, 0), "starts inside");
    assertFalse(circle.raycast(output, input(5, 5, 5, 5, 1), xf, 0), "has no length");
    assertFalse(circle.raycast(output, input(0.5f, 3, 0.5f, 9, 1), xf, 0), "points away");
  }

  /** A ray of 100 km with a hit of millimetre precision: the discriminant must not cancel. */
  @Test
  void longRaysAtSmallCirclesArePrecise() {
    CircleShape circle = new CircleShape();
    circle.m_radius = 0.05f;
    RayCastOutput output = new RayCastOutput();
    RayCastInput input = input(-100_000, 0.03f, 100_000, 0.03f, 1);
    assertTrue(circle.raycast(output, input, new Transform(), 0));
    assertEquals(0.8f, -output.normal.x, 1e-4f);
    assertEquals(0.6f, output.normal.y, 1e-4f);
  }

  @Test
  void raysAtAnEdgeFromBothSides() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-1, 0), new Vec2(1, 0));
    Transform xf = new Transform();
    RayCastOutput output = new RayCastOutput();
    assertTrue(edge.raycast(output, input(0, 1, 0, -3, 1), xf, 0));
    assertEquals(0.25f, output.fraction);
    assertEquals(1f, output.normal.y);
    assertTrue(edge.raycast(output, input(0, -1, 0, 3, 1), xf, 0));
    assertEquals(-1f, output.normal.y);
    assertFalse(edge.raycast(output, input(-3, 0, 3, 0, 1), xf, 0), "parallel");
    assertFalse(edge.raycast(output, input(1.01f, 1, 1.01f, -1, 1), xf, 0), "beside");
    assertFalse(edge.raycast(output, input(0, 1, 0, -3, 0.2f), xf, 0), "too short");
  }

  @Test
  void distancesAtDegeneratePointsStillHaveADirection() {
    Transform xf = new Transform();
    Vec2 normal = new Vec2();
    CircleShape circle = (CircleShape) shape(0);
    assertEquals(-2f, circle.computeDistanceToOut(xf, circle.m_p, 0, normal));
    assertEquals(1f, normal.length());
    EdgeShape edge = (EdgeShape) shape(2);
    assertEquals(0f, edge.computeDistanceToOut(xf, edge.m_vertex1, 0, normal), CLOSE);
    assertEquals(1f, normal.length(), 1e-6f);
    edge.m_vertex2.set(edge.m_vertex1);
    assertEquals(
        1f, edge.computeDistanceToOut(xf, edge.m_vertex1.add(new Vec2(0, 1)), 0, normal), CLOSE);
    assertEquals(new Vec2(0, 1), normal);
  }

  @Test
  void circlesAnswerAsShapesOfOneVertex() {
    CircleShape circle = (CircleShape) shape(0);
    assertEquals(1, circle.getVertexCount());
    assertEquals(0, circle.getSupport(new Vec2(1, 0)));
    assertEquals(circle.m_p, circle.getSupportVertex(new Vec2(1, 0)));
    assertEquals(circle.m_p, circle.getVertex(0));
    assertThrows(IllegalArgumentException.class, () -> circle.getVertex(1));
    CircleShape copy = (CircleShape) circle.clone();
    circle.m_p.set(9, 9);
    circle.m_radius = 9;
    assertEquals(new Vec2(0.5f, 0), copy.m_p);
    assertEquals(2f, copy.m_radius);
    assertEquals(ShapeType.CIRCLE, copy.getType());
  }

  @ParameterizedTest
  @ValueSource(floats = {-1f, Float.NaN, Float.POSITIVE_INFINITY})
  void badRadiiAreRefused(float radius) {
    CircleShape circle = new CircleShape();
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> circle.setRadius(radius));
    assertTrue(e.getMessage().endsWith(String.valueOf(radius)));
    assertEquals(0f, circle.m_radius);
  }

  @Test
  void badEdgesAreRefused() {
    EdgeShape edge = new EdgeShape();
    Vec2 nan = new Vec2(Float.NaN, 0);
    assertThrows(IllegalArgumentException.class, () -> edge.set(nan, new Vec2()));
    assertThrows(IllegalArgumentException.class, () -> edge.set(new Vec2(), nan));
  }

  @Test
  void settingAnEdgeForgetsItsGhosts() {
    EdgeShape edge = new EdgeShape();
    edge.m_hasVertex0 = true;
    edge.m_vertex0.set(7, 7);
    edge.m_hasVertex3 = true;
    EdgeShape copy = (EdgeShape) edge.clone();
    edge.set(new Vec2(), new Vec2(1, 0));
    assertFalse(edge.m_hasVertex0 || edge.m_hasVertex3);
    assertTrue(copy.m_hasVertex0 && copy.m_hasVertex3);
    assertEquals(new Vec2(7, 7), copy.m_vertex0);
    assertEquals(Settings.polygonRadius, copy.m_radius);
  }

  /** Programs write subclasses of their own against the older release, which had no distance. */
  @Test
  void shapesWithoutDistanceSayTheirName() {
    Shape foreign = new ForeignShape();
    UnsupportedOperationException e =
        assertThrows(
            UnsupportedOperationException.class,
            () -> foreign.computeDistanceToOut(new Transform(), new Vec2(), 0, new Vec2()));
    assertTrue(e.getMessage().contains("ForeignShape"));
  }

  private static final class ForeignShape extends Shape {
    ForeignShape() {
      super(ShapeType.POLYGON);
    }

    @Override
    public int getChildCount() {
      return 1;
    }

    @Override
    public boolean testPoint(Transform xf, Vec2 p) {
      return false;
    }

    @Override
    public boolean raycast(
        RayCastOutput output, RayCastInput input, Transform transform, int childIndex) {
      return false;
    }

    @Override
    public void computeAABB(AABB aabb, Transform xf, int childIndex) {}

    @Override
    public void computeMass(MassData massData, float density) {}

    @Override
    public Shape clone() {
      return new ForeignShape();
    }
  }

  private static Shape shape(int kind) {
    switch (kind) {
      case 0:
        CircleShape circle = new CircleShape();
        circle.m_p.set(0.5f, 0);
        circle.m_radius = 2;
        return circle;
      case 1:
        return ShapeMassTest.polygon(5, 0.2f, 1.5f, 0.3f);
      case 2:
        EdgeShape edge = new EdgeShape();
        edge.set(new Vec2(-2, 1), new Vec2(1.5f, -0.5f));
        return edge;
      default:
        ChainShape chain = new ChainShape();
        chain.createLoop(new Vec2[] {new Vec2(-2, -1), new Vec2(2, -1), new Vec2(0, 2)}, 3);
        return chain;
    }
  }

  private static Transform transform(float angle) {
    Transform xf = new Transform();
    xf.set(new Vec2(0.7f, -1.1f), angle);
    return xf;
  }

  private static RayCastInput input(float x1, float y1, float x2, float y2, float maxFraction) {
    RayCastInput input = new RayCastInput();
    input.p1.set(x1, y1);
    input.p2.set(x2, y2);
    input.maxFraction = maxFraction;
    return input;
  }

  private static Vec2 along(RayCastInput input, float t) {
    return new Vec2(
        input.p1.x + t * (input.p2.x - input.p1.x), input.p1.y + t * (input.p2.y - input.p1.y));
  }
}
