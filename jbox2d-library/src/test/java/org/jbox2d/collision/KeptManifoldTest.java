package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.narrowphase.KeptManifold;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.contacts.Contact;

/** Manifolds that are kept while polygons hardly move: a manifold made anew is the oracle. */
class KeptManifoldTest {
  private static final float RADIUS = 2f * Settings.polygonRadius;
  private static final int WALK = 40;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final Manifold fresh = new Manifold();
  private final KeptManifold kept = new KeptManifold();
  private PolygonShape a;
  private PolygonShape b;
  private Transform xfA;
  private Transform xfB;

  @Property(tries = 4000, seed = "21")
  void whatIsKeptHasTheDepthOfWhatIsMadeAnew(@ForAll long seed) {
    Random random = new Random(seed);
    pair(random);
    float pace = (float) Math.pow(10, -2 - 4 * random.nextDouble());
    keep();
    for (int i = 0; i < WALK; i++) {
      walk(random, xfA, pace);
      walk(random, xfB, pace);
      if (!isKept()) {
        keep();
        continue;
      }
      collision.collidePolygons(fresh, a, xfA, b, xfB);
      if (manifold.pointCount == 0) {
        assertEquals(0, fresh.pointCount, "touches, but was not looked at");
      } else {
        float now = fresh.pointCount == 0 ? RADIUS : lowest(fresh);
        assertEquals(now, lowest(manifold), 0.25f * Settings.linearSlop + 0.03f * Math.abs(now));
      }
    }
  }

  @Property(tries = 4000, seed = "22")
  void theManifoldDoesNotDependOnTheGuess(@ForAll long seed) {
    Random random = new Random(seed);
    pair(random);
    collision.collidePolygons(manifold, a, xfA, b, xfB);
    for (int i = 0; i < 4; i++) {
      int guess = random.nextInt(1 << 17) & 0x10707;
      collision.collidePolygons(fresh, a, xfA, b, xfB, guess);
      assertEquals(manifold.pointCount, fresh.pointCount);
      for (int k = 0; k < fresh.pointCount; k++) {
        assertEquals(manifold.type, fresh.type);
        assertEquals(manifold.localNormal, fresh.localNormal);
        assertEquals(manifold.points[k].localPoint, fresh.points[k].localPoint);
        assertEquals(manifold.points[k].id.getKey(), fresh.points[k].id.getKey());
      }
    }
  }

  @Example
  void aPairAtRestIsKept() {
    box(0.02f);
    assertTrue(isKept());
    box(-0.3f);
    assertTrue(isKept());
  }

  @Example
  void aShapeOrAManifoldChangedInPlaceIsSeen() {
    box(0.02f);
    a.m_vertices[2].y += 1e-6f;
    assertFalse(isKept(), "vertex");
    box(0.02f);
    b.m_radius = 0.02f;
    assertFalse(isKept(), "skin");
    box(0.02f);
    manifold.pointCount = 1;
    assertFalse(isKept(), "points");
    box(0.02f);
    manifold.localNormal.set(1f, 0f);
    assertFalse(isKept(), "normal");
    box(-0.3f);
    b.setAsBox(0.5f, 0.9f);
    assertFalse(isKept(), "shape");
  }

  /** The floor under a resting box is raised by writing its vertices: the box is lifted. */
  @Example
  void aFloorRaisedInPlaceLiftsWhatRests() {
    World world = new World(new Vec2(0f, -10f));
    world.setAllowSleep(false);
    Body ground = box(world, 0f, 5f, BodyType.STATIC);
    PolygonShape floor = (PolygonShape) ground.getFixtureList().getShape();
    Body top = box(world, 1.5f, 0.5f, BodyType.DYNAMIC);
    step(world, 60);
    float before = top.getPosition().y;
    for (int i = 0; i < floor.m_count; i++) {
      if (floor.m_vertices[i].y > 0f) {
        floor.m_vertices[i].y += 0.1f;
      }
    }
    step(world, 60);
    assertEquals(before + 0.1f, top.getPosition().y, 0.01f);
  }

  /** What a listener does to a manifold holds for that step. */
  @Example
  void aManifoldEmptiedByAListenerIsFullInTheNextStep() {
    World world = new World(new Vec2(0f, -10f));
    world.setAllowSleep(false);
    box(world, 0f, 5f, BodyType.STATIC);
    box(world, 1.5f, 0.5f, BodyType.DYNAMIC);
    step(world, 60);
    int[] least = {Integer.MAX_VALUE};
    world.setContactListener(
        new ContactListener() {
          @Override
          public void beginContact(Contact contact) {}

          @Override
          public void endContact(Contact contact) {}

          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            least[0] = Math.min(least[0], contact.getManifold().pointCount);
            contact.getManifold().pointCount = 0;
          }

          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {}
        });
    step(world, 2);
    assertEquals(2, least[0]);
  }

  private void keep() {
    int guess = collision.collidePolygons(manifold, a, xfA, b, xfB, 0);
    assertTrue(guess >= 0);
    kept.keep(manifold, a, xfA, b, xfB, collision.separationOfPolygons(), shapes());
  }

  private int shapes() {
    return KeptManifold.joined(KeptManifold.checksum(a), KeptManifold.checksum(b));
  }

  private boolean isKept() {
    kept.forgetIfChanged(manifold);
    return kept.isGood(xfA, xfB) && kept.isOf(shapes());
  }

  /** B over A by its overlap of it, for two steps. */
  private void box(float overlap) {
    a = new PolygonShape();
    a.setAsBox(1f, 0.5f);
    b = new PolygonShape();
    b.setAsBox(0.5f, 0.5f);
    xfA = new Transform();
    xfB = new Transform();
    xfB.p.set(0.1f, 1f - overlap);
    kept.forget();
    keep();
    keep();
  }

  /** The height of the lowest point of a manifold over its face, where the polygons are now. */
  private float lowest(Manifold m) {
    boolean ofA = m.type == Manifold.ManifoldType.FACE_A;
    Transform plane = ofA ? xfA : xfB;
    Transform points = ofA ? xfB : xfA;
    Vec2 normal = new Vec2();
    Vec2 origin = new Vec2();
    Vec2 point = new Vec2();
    Rot.mulToOut(plane.q, m.localNormal, normal);
    Transform.mulToOut(plane, m.localPoint, origin);
    float least = Float.POSITIVE_INFINITY;
    for (int i = 0; i < m.pointCount; i++) {
      Transform.mulToOut(points, m.points[i].localPoint, point);
      least = Math.min(least, Vec2.dot(point.sub(origin), normal));
    }
    return least;
  }

  private void pair(Random random) {
    a = polygon(random, 0.1f + random.nextFloat());
    b = polygon(random, 0.1f + random.nextFloat());
    xfA = new Transform();
    xfA.set(new Vec2(10f * random.nextFloat(), -5f), 6f * random.nextFloat());
    float angle = 6.3f * random.nextFloat();
    float distance = 0.2f + 1.8f * random.nextFloat();
    xfB = new Transform();
    xfB.set(
        xfA.p.add(new Vec2(distance * MathUtils.cos(angle), distance * MathUtils.sin(angle))),
        6.3f * random.nextFloat());
    kept.forget();
  }

  private static void walk(Random random, Transform xf, float pace) {
    float angle = MathUtils.atan2(xf.q.s, xf.q.c) + pace * (random.nextFloat() - 0.5f);
    xf.set(
        xf.p.add(new Vec2(pace * (random.nextFloat() - 0.5f), pace * (random.nextFloat() - 0.5f))),
        angle);
  }

  private static PolygonShape polygon(Random random, float size) {
    int count = 3 + random.nextInt(6);
    Vec2[] corners = new Vec2[count];
    for (int i = 0; i < count; i++) {
      float angle = 2f * MathUtils.PI * (i + 0.6f * random.nextFloat()) / count;
      corners[i] = new Vec2(size * MathUtils.cos(angle), size * MathUtils.sin(angle));
    }
    PolygonShape shape = new PolygonShape();
    shape.set(corners, count);
    return shape;
  }

  private static Body box(World world, float y, float halfWidth, BodyType type) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(0f, y);
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(halfWidth, type == BodyType.STATIC ? 1f : 0.5f);
    Body body = world.createBody(def);
    body.createFixture(shape, 1f);
    return body;
  }

  private static void step(World world, int steps) {
    for (int i = 0; i < steps; i++) {
      world.step(1f / 60f, 8, 3);
    }
  }
}
