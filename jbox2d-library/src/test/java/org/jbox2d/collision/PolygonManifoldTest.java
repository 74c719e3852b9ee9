package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Contacts of polygons with polygons and edges, by examples with known geometry. */
class PolygonManifoldTest {

  private static final float TOLERANCE = 2e-5f;

  private final Collision collision = new Collision();
  private final Manifold manifold = new Manifold();
  private final WorldManifold world = new WorldManifold();

  @Test
  void boxOnBoxTouchesInTwoPointsAtItsCorners() {
    PolygonShape ground = box(5f, 1f);
    PolygonShape top = box(0.5f, 0.5f);
    Transform xfA = at(100f, -50f, 0f);
    Transform xfB = at(101f, -48.495f, 0f);
    collision.collidePolygons(manifold, ground, xfA, top, xfB);

    assertEquals(2, manifold.pointCount);
    evaluate(xfA, ground.m_radius, xfB, top.m_radius);
    assertEquals(0f, world.normal.x, TOLERANCE);
    assertEquals(1f, world.normal.y, TOLERANCE);
    float left = Math.min(world.points[0].x, world.points[1].x);
    float right = Math.max(world.points[0].x, world.points[1].x);
    assertEquals(100.5f, left, TOLERANCE);
    assertEquals(101.5f, right, TOLERANCE);
    for (int i = 0; i < 2; i++) {
      assertEquals(0.005f - 2f * Settings.polygonRadius, world.separations[i], TOLERANCE);
    }
  }

  @Test
  void overhangingBoxIsCutAtTheEndOfTheTable() {
    PolygonShape table = box(1f, 1f);
    PolygonShape top = box(0.5f, 0.5f);
    Transform xfA = at(0f, 0f, 0f);
    Transform xfB = at(0.8f, 1.51f, 0f);
    collision.collidePolygons(manifold, table, xfA, top, xfB);
    assertEquals(2, manifold.pointCount);
    evaluate(xfA, table.m_radius, xfB, top.m_radius);
    assertEquals(1f, Math.max(world.points[0].x, world.points[1].x), TOLERANCE);
    assertEquals(0.3f, Math.min(world.points[0].x, world.points[1].x), TOLERANCE);
  }

  @Test
  void boxOnEdgeRestsOnEitherSide() {
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-10f, 0f), new Vec2(10f, 0f));
    PolygonShape box = box(0.5f, 0.25f);
    for (int side = -1; side <= 1; side += 2) {
      Transform xfB = at(3f, side * 0.265f, 0f);
      collision.collideEdgeAndPolygon(manifold, edge, at(0f, 0f, 0f), box, xfB);
      assertEquals(2, manifold.pointCount);
      evaluate(at(0f, 0f, 0f), edge.m_radius, xfB, box.m_radius);
      assertEquals(side, world.normal.y, TOLERANCE);
      assertEquals(0.015f - 0.02f, world.separations[0], TOLERANCE);
      assertEquals(0.015f - 0.02f, world.separations[1], TOLERANCE);
    }
  }

  @Test
  void polygonsFurtherThanTheirSkinsDoNotTouch() {
    PolygonShape box = box(0.5f, 0.5f);
    collision.collidePolygons(manifold, box, at(0f, 0f, 0f), box, at(1.0201f, 0f, 0f));
    assertEquals(0, manifold.pointCount);
    // Corners opposite each other: each face is within the skins, the corners are not.
    collision.collidePolygons(manifold, box, at(0f, 0f, 0f), box, at(1.018f, 1.018f, 0f));
    assertEquals(0, manifold.pointCount);
    collision.collidePolygons(manifold, box, at(0f, 0f, 0f), box, at(1.01f, 1.01f, 0f));
    assertEquals(1, manifold.pointCount);
  }

  @Test
  void boxSlidesOverButtedTilesWithoutCatching() {
    // At rest the skins overlap by a slop. No tile may then push sideways, wherever the box is.
    PolygonShape tile = box(0.5f, 0.5f);
    PolygonShape box = box(0.3f, 0.2f);
    for (int depth = 0; depth < 10; depth++) {
      float height = 0.7f + 2f * Settings.polygonRadius - 0.0005f - 0.0005f * depth;
      for (int k = 0; k < 1000; k++) {
        Transform xfB = at(-1f + 0.002f * k, height, 0f);
        for (int t = -2; t <= 2; t++) {
          Transform xfA = at(t, 0f, 0f);
          collision.collidePolygons(manifold, tile, xfA, box, xfB);
          if (manifold.pointCount > 0) {
            evaluate(xfA, tile.m_radius, xfB, box.m_radius);
            assertEquals(1f, world.normal.y, TOLERANCE, "tile " + t + " at " + xfB.p);
          }
        }
      }
    }
  }

  private void evaluate(Transform xfA, float radiusA, Transform xfB, float radiusB) {
    world.initialize(manifold, xfA, radiusA, xfB, radiusB);
    assertTrue(manifold.pointCount > 0);
  }

  private static PolygonShape box(float hx, float hy) {
    PolygonShape box = new PolygonShape();
    box.setAsBox(hx, hy);
    return box;
  }

  private static Transform at(float x, float y, float angle) {
    Transform xf = new Transform();
    xf.set(new Vec2(x, y), angle);
    return xf;
  }
}
