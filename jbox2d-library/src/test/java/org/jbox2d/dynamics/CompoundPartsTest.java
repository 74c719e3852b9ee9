package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.jbox2d.collision.WorldManifold;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Edges that two parts of a compound share are no surfaces.
 *
 * <p>Splinters that a blow had driven into a body of several parts stayed there, up to a quarter of
 * a metre deep: each of two parts pushed them into the other one.
 */
class CompoundPartsTest {
  /** How deep bodies may rest in each other, m: what the solvers leave at most, 3 slops. */
  private static final float AT_REST = 3f * Settings.linearSlop;

  static Stream<Solver> solvers() {
    return Stream.of(Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive());
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void aSplinterAcrossAnInnerEdgeComesOutThroughTheSurface(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    plate(world);
    // 0.2 m deep, and 0.05 m wide: the way out over the seam would be far shorter.
    Body splinter = Make.box(world, BodyType.DYNAMIC, 0.005f, 0.9f, 0.025f, 0.1f);
    for (int i = 0; i < 120; i++) {
      Make.steps(world, 1);
      assertTrue(splinter.getLinearVelocity().length() < 3.5f, "thrown out");
    }
    assertTrue(lowest(splinter) > 1f - AT_REST, "still in: " + splinter.getPosition());
    assertEquals(0f, splinter.getPosition().x, 0.3f);
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void aDiscInsideComesOutThroughTheNearestSurface(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    plate(world);
    Body disc = Make.disc(world, -0.02f, 0.85f, 0.05f);
    Make.steps(world, 120);
    assertTrue(disc.getPosition().y > 1.05f - AT_REST, "still in: " + disc.getPosition());
  }

  /**
   * A body that has jumped into a compound within a step is stopped by the surface it came through,
   * not let out by the nearest one: it would leave behind, and not be felt.
   */
  @Test
  void whatHasJumpedInIsStoppedWhereItCameIn() {
    for (boolean round : new boolean[] {false, true}) {
      World world = Make.weightless();
      world.setContinuousPhysics(false);
      plate(world);
      Body shot = Make.body(world, BodyType.DYNAMIC, 0.01f, 1.4f);
      shot.createFixture(round ? Make.circle(0.05f) : Make.boxShape(0.05f, 0.05f), 1f);
      shot.setLinearVelocity(new Vec2(0f, -60f));
      Make.steps(world, 1);
      // Now it is nearer to the lower surface.
      assertEquals(0.4f, shot.getPosition().y, 1e-3f);
      assertEquals(-60f, shot.getLinearVelocity().y, 1e-3f);
      Make.steps(world, 1);
      assertEquals(0f, shot.getLinearVelocity().y, 0.3f);
      Make.steps(world, 60);
      assertTrue(shot.getPosition().y > 1f, "at " + shot.getPosition());
    }
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void whatSlidesOverAnInnerEdgeIsNotHeldUp(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    plate(world);
    Body box = Make.box(world, BodyType.DYNAMIC, -1.5f, 1.1f, 0.1f, 0.1f);
    box.getFixtureList().setFriction(0f);
    Body disc = Make.disc(world, -1f, 1.1f, 0.1f);
    disc.getFixtureList().setFriction(0f);
    box.setLinearVelocity(new Vec2(3f, 0f));
    disc.setLinearVelocity(new Vec2(3f, 0f));
    Make.steps(world, 50);
    for (Body b : List.of(box, disc)) {
      assertTrue(b.getPosition().x > 0.9f, "at " + b.getPosition());
      assertEquals(3f, b.getLinearVelocity().x, 1e-3f);
      assertEquals(1.1f, b.getPosition().y, 0.02f);
    }
  }

  /**
   * Beside the notch of an L, the upright's side is a surface, though the foot's end lies on it.
   */
  @Test
  void anEdgeThatIsSharedInPartStaysASurface() {
    World world = Make.weightless();
    Body body = Make.body(world, BodyType.STATIC, 0f, 0f);
    Shape[] parts = {box(-0.5f, 1.5f, 0.5f, 1.5f), box(1f, 0.5f, 1f, 0.5f)};
    body.createFixture(new FixtureDef(), () -> parts);
    Body shard = Make.box(world, BodyType.DYNAMIC, 0.07f, 1.5f, 0.1f, 0.1f);
    Make.steps(world, 60);
    assertTrue(shard.getPosition().x > 0.1f - AT_REST, "at " + shard.getPosition());
    assertEquals(1.5f, shard.getPosition().y, 1e-3f);
  }

  @Test
  void whereAPartHasGoneItsNeighboursEdgeIsASurface() {
    World world = Make.weightless();
    Body body = plate(world);
    Fixture right = body.getFixtureList();
    assertTrue(right.testPoint(new Vec2(1f, 0.5f)));
    body.destroyFixture(right);
    Body shard = Make.box(world, BodyType.DYNAMIC, 0.07f, 0.5f, 0.1f, 0.1f);
    Body disc = Make.disc(world, 0.07f, 0.2f, 0.1f);
    Make.steps(world, 60);
    assertTrue(shard.getPosition().x > 0.1f - AT_REST, "at " + shard.getPosition());
    assertEquals(0.5f, shard.getPosition().y, 1e-3f);
    assertTrue(disc.getPosition().x > 0.1f - AT_REST, "at " + disc.getPosition());
  }

  @Test
  void aCloneOfAPartStandsAlone() {
    World world = Make.weightless();
    Body of = plate(world);
    Body alone = Make.body(world, BodyType.STATIC, 10f, 0f);
    alone.createFixture(of.getFixtureList().getNext().getShape(), 0f);
    Body shard = Make.box(world, BodyType.DYNAMIC, 10.07f, 0.5f, 0.1f, 0.1f);
    Make.steps(world, 60);
    assertTrue(shard.getPosition().x > 10.1f - AT_REST, "at " + shard.getPosition());
  }

  /** The shape of a fixture may be edited, also that of a part. */
  @Test
  void aPartMayGetMoreVertices() {
    World world = Make.world();
    Body body = plate(world);
    PolygonShape right = (PolygonShape) body.getFixtureList().getShape();
    PolygonShape bevelled = new PolygonShape();
    Vec2[] corners = {
      new Vec2(0f, 0f),
      new Vec2(2f, 0f),
      new Vec2(2f, 0.8f),
      new Vec2(1.8f, 1f),
      new Vec2(1.4f, 1.1f),
      new Vec2(0f, 1f)
    };
    bevelled.set(corners, corners.length);
    right.m_count = bevelled.m_count;
    for (int i = 0; i < right.m_count; i++) {
      right.m_vertices[i].set(bevelled.m_vertices[i]);
      right.m_normals[i].set(bevelled.m_normals[i]);
    }
    Body box = Make.box(world, BodyType.DYNAMIC, 1.9f, 1.2f, 0.05f, 0.05f);
    Make.steps(world, 60);
    assertTrue(box.getPosition().x > 2f, "slides off the bevel: " + box.getPosition());
  }

  /** An edge that crosses a seam from below holds the body by the edge's side, not by the seam. */
  @Test
  void aCompoundOnAnEdgeIsHeldByTheEdge() {
    World world = Make.world();
    Body ground = Make.body(world, BodyType.STATIC, 0f, 0f);
    EdgeShape edge = new EdgeShape();
    edge.set(new Vec2(-0.05f, 0f), new Vec2(0.05f, 0f));
    ground.createFixture(edge, 0f);
    Body body = Make.body(world, BodyType.DYNAMIC, 0f, -0.1f);
    body.setFixedRotation(true);
    Shape[] parts = {box(-1f, 0.5f, 1f, 0.5f), box(1f, 0.5f, 1f, 0.5f)};
    FixtureDef def = new FixtureDef();
    def.density = 1f;
    body.createFixture(def, () -> parts);
    WorldManifold manifold = new WorldManifold();
    for (int i = 0; i < 60; i++) {
      Make.steps(world, 1);
      for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
        c.getWorldManifold(manifold);
        assertFalse(c.isTouching() && Math.abs(manifold.normal.y) < 0.9f, "sideways");
      }
    }
    assertEquals(0f, body.getPosition().x, 1e-3f);
    assertTrue(body.getPosition().y > -AT_REST, "sank to " + body.getPosition());
  }

  /** Two boxes side by side with a seam at x = 0; their surface is at height 1. */
  private static Body plate(World world) {
    Body body = Make.body(world, BodyType.STATIC, 0f, 0f);
    Shape[] parts = {box(-1f, 0.5f, 1f, 0.5f), box(1f, 0.5f, 1f, 0.5f)};
    body.createFixture(new FixtureDef(), () -> parts);
    return body;
  }

  private static PolygonShape box(float x, float y, float hx, float hy) {
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(hx, hy, new Vec2(x, y), 0f);
    return shape;
  }

  private static float lowest(Body body) {
    PolygonShape shape = (PolygonShape) body.getFixtureList().getShape();
    float least = Float.POSITIVE_INFINITY;
    for (int i = 0; i < shape.m_count; i++) {
      least = Math.min(least, body.getWorldPoint(shape.m_vertices[i]).y);
    }
    return least;
  }
}
