package org.jbox2d.common;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;

class MatrixTest {

  private final Mat22 a = new Mat22(1, 2, 3, 4);
  private final Mat22 b = new Mat22(-1, 0.5f, 2, 5);
  private final Vec2 v = new Vec2(7, -3);

  @Test
  void argumentsGoByRows() {
    assertEquals(new Vec2(1, 3), a.ex);
    assertEquals(new Vec2(2, 4), a.ey);
    assertEquals(a, new Mat22().set(1, 2, 3, 4));
    assertEquals(a, new Mat22(new Vec2(1, 3), new Vec2(2, 4)));
    assertEquals("[1.0,2.0]\n[3.0,4.0]", a.toString());
  }

  @Test
  void productsWithVectors() {
    assertEquals(new Vec2(1, 9), a.mul(v));
    assertEquals(new Vec2(-2, 2), a.mulTrans(v));
    Vec2 alias = v.clone();
    a.mulToOut(alias, alias);
    assertEquals(new Vec2(1, 9), alias);
    alias.set(v);
    a.mulTransToOut(alias, alias);
    assertEquals(new Vec2(-2, 2), alias);
    Vec2 out = new Vec2();
    Mat22.mulTransToOutUnsafe(a, v, out);
    assertEquals(new Vec2(-2, 2), out);
    a.mulToOutUnsafe(v, out);
    assertEquals(new Vec2(1, 9), out);
  }

  @Test
  void productsWithMatrices() {
    Mat22 product = new Mat22(3, 10.5f, 5, 21.5f);
    Mat22 transposed = new Mat22(5, 15.5f, 6, 21);
    assertEquals(product, a.mul(b));
    assertEquals(product, a.clone().mulLocal(b));
    assertEquals(transposed, a.mulTrans(b));
    assertEquals(transposed, a.clone().mulTransLocal(b));
    Mat22 alias = b.clone();
    Mat22.mulToOut(a, alias, alias);
    assertEquals(product, alias);
    alias.set(b);
    Mat22.mulTransToOut(a, alias, alias);
    assertEquals(transposed, alias);
  }

  @Test
  void specialMatrices() {
    Mat22 turn = Mat22.createRotationalTransform(0.7f);
    assertEquals(0.7f, turn.getAngle(), 1e-6f);
    Vec2 image = turn.mul(new Vec2(1, 0));
    assertEquals(StrictMath.sin(0.7f), image.y, 1e-7);
    assertEquals(new Vec2(14, -6), Mat22.createScaleTransform(2).mul(v));
    assertEquals(
        new Mat22(1, 2.5f, 5, 9), new Mat22(2, 2, 3, 4).addLocal(new Mat22(-1, 0.5f, 2, 5)));
    assertEquals(new Mat22(1, 0.5f, 2, 5), Mat22.abs(b));
  }

  @Test
  void singularMatricesGiveZero() {
    Mat22 singular = new Mat22(1, 2, 2, 4);
    assertEquals(0f, singular.solve(v).length());
    assertEquals(0f, singular.invert().mul(v).length());
    assertEquals(0f, Vec3.dot(new Mat33().solve33(new Vec3(1, 2, 3)), new Vec3(1, 1, 1)));
    Mat33 inverse = new Mat33();
    new Mat33().getSymInverse33(inverse);
    assertEquals(new Mat33(), inverse);
  }

  @Property(tries = 500, seed = "11")
  void solutionsOfTwoSatisfyTheirSystem(
      @ForAll @FloatRange(min = -10, max = 10) float m12,
      @ForAll @FloatRange(min = -10, max = 10) float m21,
      @ForAll @FloatRange(min = -100, max = 100) float bx,
      @ForAll @FloatRange(min = -100, max = 100) float by) {
    Mat22 m = new Mat22(21, m12, m21, 22);
    Vec2 rhs = new Vec2(bx, by);
    assertNear(rhs, m.mul(m.solve(rhs)));
    assertNear(rhs, m.mul(m.invert().mul(rhs)));
    assertNear(rhs, m.mul(m.clone().invertLocal().mul(rhs)));

    Mat33 embedded = new Mat33(21, m21, 5, m12, 22, 5, 5, 5, 5);
    assertNear(rhs, Mat33.mul22(embedded, embedded.solve22(rhs)));
    Mat33 inverse = new Mat33();
    embedded.getInverse22(inverse);
    assertNear(rhs, Mat33.mul22(embedded, Mat33.mul22(inverse, rhs)));
  }

  @Property(tries = 500, seed = "12")
  void solutionsOfThreeSatisfyTheirSystem(
      @ForAll @FloatRange(min = -8, max = 8) float p,
      @ForAll @FloatRange(min = -8, max = 8) float q,
      @ForAll @FloatRange(min = -8, max = 8) float r,
      @ForAll @FloatRange(min = -100, max = 100) float bx,
      @ForAll @FloatRange(min = -100, max = 100) float bz) {
    Vec3 rhs = new Vec3(bx, -bz, bz);
    Mat33 any = new Mat33(25, p, q, r, 26, -p, -q, 3, 27);
    assertNear(rhs, Mat33.mul(any, any.solve33(rhs)));
    Vec3 alias = rhs.clone();
    any.solve33ToOut(alias, alias);
    Mat33.mulToOut(any, alias, alias);
    assertNear(rhs, alias);

    Mat33 symmetric = new Mat33(25, p, q, p, 26, r, q, r, 27);
    Mat33 inverse = new Mat33();
    symmetric.getSymInverse33(inverse);
    assertNear(rhs, Mat33.mul(symmetric, Mat33.mul(inverse, rhs)));
  }

  private static void assertNear(Vec2 expected, Vec2 actual) {
    assertEquals(
        0f,
        expected.sub(actual).length(),
        1e-5f * (1 + expected.length()),
        () -> expected + " " + actual);
  }

  private static void assertNear(Vec3 expected, Vec3 actual) {
    Vec3 residual = expected.sub(actual);
    float size = 1 + Math.abs(expected.x) + Math.abs(expected.y) + Math.abs(expected.z);
    assertEquals(
        0f, Vec3.dot(residual, residual), 1e-10f * size * size, () -> expected + " " + actual);
  }
}
