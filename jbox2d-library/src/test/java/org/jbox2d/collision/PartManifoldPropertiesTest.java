package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jbox2d.collision.narrowphase.PartShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * A convex polygon cut into triangles: what touches the whole touches a part, and no part pushes
 * along the normal of a cut. The whole polygon is the oracle.
 */
class PartManifoldPropertiesTest {
  private static final float RADIUS = 2f * Settings.polygonRadius;

  /** Cosine of the angle between two normals that are the same but for rounding. */
  private static final float SAME = 0.99999f;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final Manifold ofWhole = new Manifold();

  private PolygonShape whole;
  private Shape[] parts;

  @Property(tries = 3000, seed = "11")
  void whatTouchesTheWholeTouchesAPartByItsOutline(@ForAll long seed) {
    Random random = new Random(seed);
    Transform xfA = cutUp(random);
    float size = 0.05f + random.nextFloat();
    PolygonShape other = polygon(random, size);
    Transform xfB = near(random, xfA, 1f + size);
    collision.collidePolygons(ofWhole, whole, xfA, other, xfB);
    boolean touched = false;
    for (Shape part : parts) {
      collision.collideParts(manifold, (PolygonShape) part, xfA, other, xfB, 0f, 0f);
      if (manifold.pointCount > 0) {
        touched = true;
        boolean ofA = manifold.type == Manifold.ManifoldType.FACE_A;
        assertTrue(!ofA || isOfOutline(manifold.localNormal), "normal " + manifold.localNormal);
      }
    }
    assertTrue(touched || ofWhole.pointCount == 0 || isSlight(xfA, other, xfB), "no contact");
  }

  @Property(tries = 3000, seed = "12")
  void aDiscIsPushedByTheOutlineAlone(@ForAll long seed) {
    Random random = new Random(seed);
    Transform xfA = cutUp(random);
    CircleShape disc = new CircleShape();
    disc.m_radius = 0.02f + 0.5f * random.nextFloat();
    Transform xfB = near(random, xfA, 1f + disc.m_radius);
    collision.collidePolygonAndCircle(ofWhole, whole, xfA, disc, xfB);
    float nearest = Float.POSITIVE_INFINITY;
    boolean touched = false;
    for (Shape part : parts) {
      collision.collidePolygonAndCircle(manifold, (PolygonShape) part, xfA, disc, xfB);
      if (manifold.pointCount > 0) {
        touched = true;
        boolean same = Vec2.dot(manifold.localNormal, ofWhole.localNormal) > SAME;
        nearest = Math.min(nearest, same ? 0f : 1f);
        assertTrue(manifold.corner || isOfOutline(manifold.localNormal), "normal");
      }
    }
    assertTrue(touched || ofWhole.pointCount == 0, "no contact");
    // Where the distance to two edges is the same up to rounding, either is right.
    assertTrue(!touched || nearest == 0f || isBetweenEdges(xfA, xfB), "other than the whole's");
  }

  @Property(tries = 200, seed = "13")
  void partsThatTouchInVerticesAloneAreNotLinked(@ForAll long seed) {
    Random random = new Random(seed);
    PolygonShape a = polygon(random, 1f);
    PolygonShape b = polygon(random, 1f);
    Vec2 shift = new Vec2(5f, 0f);
    for (int i = 0; i < b.m_count; i++) {
      b.m_vertices[i].addLocal(shift);
    }
    assertNull(PartShape.link(new Shape[] {a, b, new CircleShape()}));
  }

  /** Cuts a random convex polygon into the triangles between its middle and its edges. */
  private Transform cutUp(Random random) {
    do {
      whole = polygon(random, 1f);
    } while (whole.m_count < 4);
    Vec2 middle = new Vec2();
    for (int i = 0; i < whole.m_count; i++) {
      middle.addLocal(whole.m_vertices[i].mul(1f / whole.m_count));
    }
    boolean fan = random.nextBoolean();
    int n = whole.m_count;
    Shape[] triangles = new Shape[fan ? n - 2 : n];
    for (int i = 0; i < triangles.length; i++) {
      PolygonShape triangle = new PolygonShape();
      Vec2 apex = fan ? whole.m_vertices[n - 1] : middle;
      triangle.set(new Vec2[] {apex, whole.m_vertices[i], whole.m_vertices[(i + 1) % n]}, 3);
      triangles[i] = triangle;
    }
    parts = PartShape.link(triangles);
    assertTrue(parts != null && !Arrays.asList(parts).contains(null));
    Transform xf = new Transform();
    xf.set(new Vec2(random.nextFloat(), random.nextFloat()), 6f * random.nextFloat());
    return xf;
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

  private static Transform near(Random random, Transform xf, float reach) {
    float angle = 6.3f * random.nextFloat();
    float distance = reach * random.nextFloat();
    Transform near = new Transform();
    near.set(
        new Vec2(
            xf.p.x + distance * MathUtils.cos(angle), xf.p.y + distance * MathUtils.sin(angle)),
        6.3f * random.nextFloat());
    return near;
  }

  private boolean isOfOutline(Vec2 normal) {
    for (int i = 0; i < whole.m_count; i++) {
      if (Vec2.dot(normal, whole.m_normals[i]) > SAME) {
        return true;
      }
    }
    return false;
  }

  /** Whether the skins just touch: corners opposite each other have round ends, cut faces not. */
  private boolean isSlight(Transform xfA, PolygonShape other, Transform xfB) {
    double distance =
        ConvexOracle.distance(ConvexOracle.corners(whole, xfA), ConvexOracle.corners(other, xfB));
    return distance > 0.9 * RADIUS;
  }

  /** Whether the two edges nearest to the centre of a disc are equally near, up to rounding. */
  private boolean isBetweenEdges(Transform xfA, Transform xfB) {
    Vec2 c = Transform.mulTrans(xfA, xfB.p);
    float[] heights = new float[whole.m_count];
    for (int i = 0; i < heights.length; i++) {
      Vec2 v = whole.m_vertices[i];
      heights[i] = Vec2.dot(whole.m_normals[i], c.sub(v));
    }
    Arrays.sort(heights);
    int last = heights.length - 1;
    return heights[last] > 0f || heights[last] - heights[last - 1] < 1e-4f;
  }
}
