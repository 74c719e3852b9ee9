package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class AABBTest {

  private final AABB box = new AABB(new Vec2(-1, -2), new Vec2(3, 4));

  @Test
  void cornersAreCopied() {
    Vec2 lower = new Vec2(-1, -1);
    AABB made = new AABB(lower, new Vec2(1, 1));
    AABB copy = new AABB(made);
    lower.set(9, 9);
    made.upperBound.set(9, 9);
    assertEquals(new Vec2(-1, -1), made.lowerBound);
    assertEquals(new Vec2(1, 1), copy.upperBound);
  }

  @Test
  void measures() {
    assertEquals(new Vec2(1, 1), box.getCenter());
    assertEquals(new Vec2(2, 3), box.getExtents());
    assertEquals(20f, box.getPerimeter());
    Vec2[] corners = {new Vec2(), new Vec2(), new Vec2(), new Vec2()};
    box.getVertices(corners);
    float doubleArea = 0;
    for (int i = 0; i < 4; i++) {
      doubleArea += Vec2.cross(corners[i], corners[(i + 1) % 4]);
    }
    assertEquals(48f, doubleArea);
    assertEquals(box.lowerBound, corners[0]);
  }

  @Test
  void validBoxesAreFiniteAndInOrder() {
    assertTrue(box.isValid());
    assertTrue(new AABB().isValid());
    assertFalse(new AABB(new Vec2(1, 0), new Vec2(0, 1)).isValid());
    assertFalse(new AABB(new Vec2(0, Float.NaN), new Vec2(1, 1)).isValid());
    assertFalse(new AABB(new Vec2(0, 0), new Vec2(1, Float.POSITIVE_INFINITY)).isValid());
  }

  @Property(tries = 300, seed = "31")
  void unionsHoldBothAndOverlapsShareAPoint(
      @ForAll @FloatRange(min = -5, max = 5) float x,
      @ForAll @FloatRange(min = -5, max = 5) float y,
      @ForAll @FloatRange(min = 0, max = 5) float width,
      @ForAll @FloatRange(min = 0, max = 5) float height) {
    AABB other = new AABB(new Vec2(x, y), new Vec2(x + width, y + height));
    AABB union = new AABB();
    union.combine(box, other);
    assertTrue(union.contains(box) && union.contains(other));
    AABB grown = new AABB(other);
    grown.combine(box);
    assertEquals(union.toString(), grown.toString());

    Vec2 low = Vec2.max(box.lowerBound, other.lowerBound);
    Vec2 high = Vec2.min(box.upperBound, other.upperBound);
    boolean sharesPoint = low.x <= high.x && low.y <= high.y;
    assertEquals(sharesPoint, AABB.testOverlap(box, other));
    assertEquals(sharesPoint, AABB.testOverlap(other, box));
  }

  @Test
  void raysAlongTheAxes() {
    assertHit(0.25f, new Vec2(-1, 0), -2, 0, 2, 0, 1);
    assertHit(0.5f, new Vec2(0, 1), 0, 6, 0, 2, 1);
    assertHit(0f, new Vec2(0, -1), 3, -2, 3, 2, 1);
    assertMiss(-2, 4.1f, 2, 4.1f, 1);
    assertMiss(3.1f, 6, 3.1f, 2, 1);
  }

  @Test
  void raysThatEndBeforeTheBoxOrStartInItMiss() {
    assertMiss(-2, 0, 2, 0, 0.2f);
    assertMiss(0, 0, 9, 0, 1);
    assertMiss(0, 0, 0, 0, 1);
    assertMiss(-5, 0, -5, 0, 1);
    assertMiss(5, 0, 9, 0, 1);
    assertMiss(Float.NaN, 0, 9, 0, 1);
  }

  @Property(tries = 500, seed = "32")
  void slantedRaysHitTheBorderFirst(
      @ForAll @FloatRange(min = -9, max = 9) float x,
      @ForAll @FloatRange(min = -9, max = 9) float dx,
      @ForAll @FloatRange(min = -9, max = 9) float dy) {
    RayCastInput input = input(x, 8, x + dx, 8 + dy, 1);
    RayCastOutput output = new RayCastOutput();
    boolean hit = box.raycast(output, input);
    boolean sampled = false;
    for (int i = 0; i <= 2000 && !sampled; i++) {
      float t = i / 2000f;
      sampled = isInside(x + t * dx, 8 + t * dy, -1e-3f);
      if (sampled) {
        assertTrue(hit && output.fraction <= t + 1e-5f);
      }
    }
    if (hit) {
      Vec2 at = new Vec2(x + output.fraction * dx, 8 + output.fraction * dy);
      assertTrue(isInside(at.x, at.y, 1e-4f));
      assertTrue(output.normal.x * dx + output.normal.y * dy < 0);
      assertFalse(isInside(at.x + 1e-3f * output.normal.x, at.y + 1e-3f * output.normal.y, 0));
    }
  }

  private boolean isInside(float x, float y, float margin) {
    return x >= -1 - margin && x <= 3 + margin && y >= -2 - margin && y <= 4 + margin;
  }

  private void assertHit(
      float fraction, Vec2 normal, float x1, float y1, float x2, float y2, float maxFraction) {
    RayCastOutput output = new RayCastOutput();
    assertTrue(box.raycast(output, input(x1, y1, x2, y2, maxFraction)));
    assertEquals(fraction, output.fraction);
    assertEquals(normal.x, output.normal.x);
    assertEquals(normal.y, output.normal.y);
  }

  private void assertMiss(float x1, float y1, float x2, float y2, float maxFraction) {
    RayCastOutput output = new RayCastOutput();
    output.fraction = 7;
    assertFalse(box.raycast(output, input(x1, y1, x2, y2, maxFraction)));
    assertEquals(7, output.fraction);
  }

  private static RayCastInput input(float x1, float y1, float x2, float y2, float maxFraction) {
    RayCastInput input = new RayCastInput();
    input.p1.set(x1, y1);
    input.p2.set(x2, y2);
    input.maxFraction = maxFraction;
    return input;
  }
}
