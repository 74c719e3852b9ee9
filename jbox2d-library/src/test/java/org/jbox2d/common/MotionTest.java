package org.jbox2d.common;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;

/** Rotations, transforms, sweeps and views. */
class MotionTest {

  private static final float CLOSE = 2e-5f;

  @Property(tries = 300, seed = "21")
  void rotationsAddTheirAngles(
      @ForAll @FloatRange(min = -1.5f, max = 1.5f) float first,
      @ForAll @FloatRange(min = -1.5f, max = 1.5f) float second) {
    Rot q = new Rot(first);
    Rot r = new Rot(second);
    Rot out = new Rot();
    Rot.mul(q, r, out);
    assertEquals(first + second, out.getAngle(), CLOSE);
    Rot.mulTrans(q, r, out);
    assertEquals(second - first, out.getAngle(), CLOSE);
    Rot alias = q.clone();
    Rot.mul(alias, r, alias);
    assertEquals(first + second, alias.getAngle(), CLOSE);
    Vec2 v = new Vec2(2, -1);
    Rot.mulToOut(q, v, v);
    Rot.mulTrans(q, v, v);
    assertNear(new Vec2(2, -1), v);
    assertEquals(1f, q.s * q.s + q.c * q.c, 3e-7f);
  }

  @Test
  void axesAreTheImagesOfTheUnitVectors() {
    Rot q = new Rot(MathUtils.HALF_PI);
    Vec2 axis = new Vec2();
    q.getXAxis(axis);
    assertNear(new Vec2(0, 1), axis);
    q.getYAxis(axis);
    assertNear(new Vec2(-1, 0), axis);
  }

  @Property(tries = 300, seed = "22")
  void transformsComposeAndInvert(
      @ForAll @FloatRange(min = -20, max = 20) float x,
      @ForAll @FloatRange(min = -20, max = 20) float y,
      @ForAll @FloatRange(min = -7, max = 7) float angle) {
    Transform a = new Transform(new Vec2(x, y), new Rot(angle));
    Transform b = new Transform(new Vec2(y, -x), new Rot(0.5f - angle));
    Vec2 v = new Vec2(1.5f, -2.5f);

    assertNear(v, Transform.mulTrans(a, Transform.mul(a, v)));
    assertNear(Transform.mul(a, Transform.mul(b, v)), Transform.mul(Transform.mul(a, b), v));
    assertNear(
        Transform.mulTrans(a, Transform.mul(b, v)), Transform.mul(Transform.mulTrans(a, b), v));

    Vec2 alias = v.clone();
    Transform.mulToOut(a, alias, alias);
    assertNear(Transform.mul(a, v), alias);
    Transform.mulTransToOut(a, alias, alias);
    assertNear(v, alias);
    Transform overB = new Transform(b);
    Transform.mulToOut(a, overB, overB);
    assertNear(Transform.mul(a, Transform.mul(b, v)), Transform.mul(overB, v));
    overB.set(b);
    Transform.mulTransToOut(a, overB, overB);
    assertNear(Transform.mulTrans(a, Transform.mul(b, v)), Transform.mul(overB, v));
  }

  @Test
  void aSweepGoesStraightFromStartToEnd() {
    Sweep sweep = sweep();
    Transform xf = new Transform();
    for (int i = 0; i <= 4; i++) {
      float beta = i / 4f;
      sweep.getTransform(xf, beta);
      Vec2 center = Transform.mul(xf, sweep.localCenter);
      assertNear(new Vec2(1 + 4 * beta, 2 - 8 * beta), center);
      assertEquals(0.5f + beta, xf.q.getAngle(), CLOSE);
    }
  }

  @Test
  void advancingKeepsTheMotion() {
    Sweep sweep = sweep();
    Transform before = new Transform();
    sweep.getTransform(before, 0.625f);
    sweep.advance(0.25f);
    assertEquals(0.25f, sweep.alpha0);
    Transform after = new Transform();
    sweep.getTransform(after, 0.5f);
    assertNear(before.p, after.p);
    assertEquals(before.q.getAngle(), after.q.getAngle(), CLOSE);
    sweep.advance(0.625f);
    sweep.getTransform(after, 0f);
    assertNear(before.p, after.p);
  }

  @Test
  void normalizingTakesOffWholeTurns() {
    Sweep sweep = sweep();
    sweep.a0 = -20f;
    sweep.a = -19f;
    sweep.normalize();
    assertTrue(sweep.a0 >= 0 && sweep.a0 < MathUtils.TWOPI);
    assertEquals(1f, sweep.a - sweep.a0, CLOSE);
    assertEquals(StrictMath.sin(-20), StrictMath.sin(sweep.a0), CLOSE);
  }

  @Test
  void aViewShowsItsCentreInTheMiddleAndFlips() {
    OBBViewportTransform view = new OBBViewportTransform();
    view.setExtents(320, 240);
    view.setCamera(10, 5, 20);
    view.setYFlip(true);
    Vec2 out = new Vec2();
    view.getWorldToScreen(new Vec2(10, 5), out);
    assertEquals(new Vec2(320, 240), out);
    view.getWorldToScreen(new Vec2(11, 6), out);
    assertEquals(new Vec2(340, 220), out);
    view.getWorldVectorToScreen(new Vec2(1, 1), out);
    assertEquals(new Vec2(20, -20), out);
    assertEquals(new Mat22(20, 0, 0, 20), view.getMat22Representation());
  }

  @Property(tries = 300, seed = "23")
  void viewsThereAndBack(
      @ForAll @FloatRange(min = -50, max = 50) float x,
      @ForAll @FloatRange(min = -50, max = 50) float y,
      @ForAll @FloatRange(min = 0.5f, max = 50) float scale,
      @ForAll boolean flip) {
    OBBViewportTransform view = new OBBViewportTransform();
    view.setExtents(new Vec2(400, 300));
    view.setCamera(3, -4, scale);
    view.mulByTransform(Mat22.createRotationalTransform(0.3f));
    view.setYFlip(flip);
    OBBViewportTransform copy = new OBBViewportTransform();
    copy.set(view);
    Vec2 v = new Vec2(x, y);
    copy.getWorldToScreen(v, v);
    copy.getScreenToWorld(v, v);
    assertEquals(0f, v.sub(new Vec2(x, y)).length(), 1e-4f);
    copy.getWorldVectorToScreen(v, v);
    copy.getScreenVectorToWorld(v, v);
    assertEquals(0f, v.sub(new Vec2(x, y)).length(), 2e-4f);
  }

  private static Sweep sweep() {
    Sweep sweep = new Sweep();
    sweep.localCenter.set(0.3f, -0.2f);
    sweep.c0.set(1, 2);
    sweep.c.set(5, -6);
    sweep.a0 = 0.5f;
    sweep.a = 1.5f;
    return sweep;
  }

  private static void assertNear(Vec2 expected, Vec2 actual) {
    assertEquals(
        0f,
        expected.sub(actual).length(),
        CLOSE * (1 + expected.length()),
        () -> expected + " " + actual);
  }
}
