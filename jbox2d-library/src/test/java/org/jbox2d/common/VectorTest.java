package org.jbox2d.common;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import org.junit.jupiter.api.Test;

class VectorTest {

  private final Vec2 a = new Vec2(3, -4);
  private final Vec2 b = new Vec2(0.5f, 2);

  @Test
  void sumsAndMultiplesLeaveTheirOperands() {
    assertEquals(new Vec2(3.5f, -2), a.add(b));
    assertEquals(new Vec2(2.5f, -6), a.sub(b));
    assertEquals(new Vec2(-6, 8), a.mul(-2));
    assertEquals(new Vec2(-3, 4), a.negate());
    assertEquals(new Vec2(3, 4), a.abs());
    assertEquals(new Vec2(3, 4), Vec2.abs(a));
    assertEquals(new Vec2(3, -4), a);
  }

  @Test
  void localOperationsChangeAndReturnTheirOwner() {
    Vec2 v = a.clone();
    assertNotSame(a, v);
    assertSame(v, v.addLocal(b).addLocal(1, 1).subLocal(b).mulLocal(2).negateLocal());
    assertEquals(new Vec2(-8, 6), v);
    v.absLocal();
    assertEquals(new Vec2(8, 6), v);
    v.setZero();
    assertEquals(new Vec2(), v);
  }

  @Test
  void crossProductsAreTheThreeDimensionalOnes() {
    assertEquals(8f, Vec2.cross(a, b));
    assertEquals(-6.5f, Vec2.dot(a, b));
    assertEquals(new Vec2(-8, -6), Vec2.cross(a, 2));
    assertEquals(new Vec2(8, 6), Vec2.cross(2, a));
    assertEquals(new Vec2(4, 3), a.skew());
    assertEquals(Vec2.cross(a, b), Vec2.dot(a.skew(), b));
  }

  @Test
  void outputsMayBeInputs() {
    Vec2 v = a.clone();
    Vec2.crossToOut(v, 2, v);
    assertEquals(Vec2.cross(a, 2), v);
    v.set(a);
    Vec2.crossToOut(2, v, v);
    assertEquals(Vec2.cross(2, a), v);
    v.set(a);
    Vec2.minToOut(v, b, v);
    assertEquals(Vec2.min(a, b), v);
    v.set(a);
    Vec2.maxToOut(v, b, v);
    assertEquals(Vec2.max(a, b), v);
    v.set(a);
    Vec2.negateToOut(v, v);
    assertEquals(a.negate(), v);
    Vec2 out = new Vec2();
    Vec2.crossToOutUnsafe(a, 2, out);
    assertEquals(Vec2.cross(a, 2), out);
    Vec2.crossToOutUnsafe(2, a, out);
    assertEquals(Vec2.cross(2, a), out);
  }

  @Test
  void lengthAndDirection() {
    assertEquals(5f, a.length());
    assertEquals(25f, a.lengthSquared());
    Vec2 v = a.clone();
    assertEquals(5f, v.normalize());
    assertEquals(1f, v.length(), 1e-6f);
    assertEquals(0f, Vec2.cross(a, v), 1e-6f);
    Vec2 tiny = new Vec2(1e-8f, 0);
    assertEquals(0f, tiny.normalize());
    assertEquals(new Vec2(1e-8f, 0), tiny);
  }

  @Test
  void validMeansFinite() {
    assertTrue(new Vec2(Float.MAX_VALUE, -Float.MAX_VALUE).isValid());
    assertFalse(new Vec2(Float.NaN, 0).isValid());
    assertFalse(new Vec2(0, Float.NEGATIVE_INFINITY).isValid());
  }

  @Test
  void equalityIsThatOfBits() {
    assertEquals(new Vec2(Float.NaN, 1), new Vec2(Float.NaN, 1));
    assertNotEquals(new Vec2(0f, 1), new Vec2(-0f, 1));
    assertEquals(a.hashCode(), a.clone().hashCode());
    assertEquals("(3.0,-4.0)", a.toString());
  }

  @Test
  void vectorsOfThree() {
    Vec3 u = new Vec3(1, 2, 3);
    Vec3 w = new Vec3(-2, 0.5f, 4);
    assertEquals(11f, Vec3.dot(u, w));
    Vec3 cross = Vec3.cross(u, w);
    assertEquals(new Vec3(6.5f, -10, 4.5f), cross);
    Vec3 alias = u.clone();
    Vec3.crossToOut(alias, w, alias);
    assertEquals(cross, alias);
    assertEquals(new Vec3(-1, 2.5f, 7), u.add(w));
    assertEquals(new Vec3(3, 1.5f, -1), u.sub(w));
    assertEquals(new Vec3(-2, -4, -6), u.mul(2).negateLocal());
    assertEquals(u, u.add(w).subLocal(w));
    assertEquals(u.hashCode(), new Vec3(u).hashCode());
  }

  @Test
  void aSweepSurvivesSerialization() throws IOException, ClassNotFoundException {
    Sweep sweep = new Sweep();
    sweep.c.set(1, 2);
    sweep.localCenter.set(3, 4);
    sweep.a = 5;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(sweep);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      assertEquals(sweep.toString(), in.readObject().toString());
    }
  }
}
