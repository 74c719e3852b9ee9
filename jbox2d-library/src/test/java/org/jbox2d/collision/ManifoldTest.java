package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.jbox2d.collision.Manifold.ManifoldType;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

class ManifoldTest {

  private static final float CLOSE = 1e-5f;

  @Test
  void keysTellFeaturesApart() {
    ContactID id = new ContactID();
    id.indexA = 1;
    id.indexB = 2;
    id.typeA = (byte) ContactID.Type.VERTEX.ordinal();
    id.typeB = (byte) ContactID.Type.FACE.ordinal();
    assertEquals(0x01020001, id.getKey());
    ContactID flipped = new ContactID(id);
    flipped.flip();
    assertEquals(0x02010100, flipped.getKey());
    assertFalse(id.isEqual(flipped));
    assertTrue(id.compareTo(flipped) < 0 && flipped.compareTo(id) > 0);
    flipped.flip();
    assertTrue(id.isEqual(flipped));
    assertEquals(0, id.compareTo(flipped));
    flipped.zero();
    assertEquals(0, flipped.getKey());
  }

  /** A negative byte must not spill into the others. */
  @Test
  void keysOfLargeIndicesDiffer() {
    ContactID a = new ContactID();
    a.indexB = (byte) 200;
    ContactID b = new ContactID(a);
    b.indexA = 1;
    assertNotEquals(a.getKey(), b.getKey());
  }

  @Test
  void copiesAreDeep() {
    Manifold manifold = manifold(ManifoldType.FACE_A, 0, 1, 0, 1);
    manifold.points[0].normalImpulse = 3;
    Manifold copy = new Manifold(manifold);
    manifold.points[0].normalImpulse = 4;
    manifold.points[0].localPoint.set(9, 9);
    manifold.localNormal.set(9, 9);
    assertEquals(3, copy.points[0].normalImpulse);
    assertEquals(new Vec2(0, 1), copy.points[0].localPoint);
    assertEquals(new Vec2(0, 1), copy.localNormal);
    assertEquals(ManifoldType.FACE_A, copy.type);
    assertEquals(1, copy.pointCount);
  }

  @Property(tries = 200, seed = "41")
  void circlesTouchHalfwayBetweenTheirSurfaces(
      @ForAll @FloatRange(min = -3, max = 3) float angle,
      @ForAll @FloatRange(min = 0.5f, max = 4) float distance) {
    Transform xfA = new Transform(new Vec2(2, 1), new Rot(0.4f));
    Vec2 towards = new Vec2((float) StrictMath.cos(angle), (float) StrictMath.sin(angle));
    Transform xfB = new Transform(xfA.p.add(towards.mul(distance)), new Rot(2f));
    Manifold manifold = manifold(ManifoldType.CIRCLES, 0, 0, 0, 0);
    WorldManifold world = new WorldManifold();
    world.initialize(manifold, xfA, 1f, xfB, 0.5f);
    assertNear(towards, world.normal);
    assertEquals(distance - 1.5f, world.separations[0], CLOSE);
    assertNear(xfA.p.add(towards.mul(1 + 0.5f * (distance - 1.5f))), world.points[0]);
  }

  @Test
  void coincidentCentresHaveADirectionAllTheSame() {
    Transform xf = new Transform(new Vec2(2, 1), new Rot(0.4f));
    WorldManifold world = new WorldManifold();
    world.initialize(manifold(ManifoldType.CIRCLES, 0, 0, 0, 0), xf, 1f, xf, 0.5f);
    assertEquals(1f, world.normal.length(), CLOSE);
    assertEquals(-1.5f, world.separations[0], CLOSE);
  }

  /** A floor, its top at y = 1 and turned with A, and a point of B 0.3 above it. */
  @Property(tries = 200, seed = "42")
  void facesOfAPushUpAndFacesOfBDown(
      @ForAll @FloatRange(min = -3, max = 3) float angleA,
      @ForAll @FloatRange(min = -3, max = 3) float angleB) {
    Transform xfA = new Transform(new Vec2(2, 1), new Rot(angleA));
    Transform xfB = new Transform(new Vec2(-1, 3), new Rot(angleB));
    Vec2 point = Transform.mul(xfA, new Vec2(0.7f, 1.3f));
    Vec2 inB = Transform.mulTrans(xfB, point);
    Vec2 up = Transform.mul(xfA, new Vec2(0, 1)).sub(xfA.p);
    Vec2 middle = Transform.mul(xfA, new Vec2(0.7f, 1f + 0.5f * (0.3f + 0.02f - 0.01f)));
    WorldManifold world = new WorldManifold();

    world.initialize(manifold(ManifoldType.FACE_A, 0, 1, inB.x, inB.y), xfA, 0.02f, xfB, 0.01f);
    assertNear(up, world.normal);
    assertNear(middle, world.points[0]);
    assertEquals(0.27f, world.separations[0], CLOSE);

    world.initialize(manifold(ManifoldType.FACE_B, 0, 1, inB.x, inB.y), xfB, 0.01f, xfA, 0.02f);
    assertNear(up.negate(), world.normal);
    assertNear(middle, world.points[0]);
    assertEquals(0.27f, world.separations[0], CLOSE);
  }

  @Test
  void withoutPointsNothingChanges() {
    WorldManifold world = new WorldManifold();
    world.normal.set(3, 4);
    world.initialize(new Manifold(), new Transform(), 1, new Transform(), 1);
    assertEquals(new Vec2(3, 4), world.normal);
  }

  private static Manifold manifold(
      ManifoldType type, float localX, float localY, float x, float y) {
    Manifold manifold = new Manifold();
    manifold.type = type;
    manifold.localPoint.set(localX, localY);
    manifold.localNormal.set(0, 1);
    manifold.points[0].localPoint.set(x, y);
    manifold.pointCount = 1;
    return manifold;
  }

  private static void assertNear(Vec2 expected, Vec2 actual) {
    assertEquals(0f, expected.sub(actual).length(), CLOSE, () -> expected + " " + actual);
  }
}
