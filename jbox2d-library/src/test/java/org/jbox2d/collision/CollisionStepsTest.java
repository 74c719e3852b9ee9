package org.jbox2d.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.Collision.ClipVertex;
import org.jbox2d.collision.Collision.EdgeResults;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** The steps of contact generation that {@link Collision} offers one by one. */
class CollisionStepsTest {

  private static final float TOLERANCE = 1e-5f;

  private final Collision collision = new Collision();

  @Test
  void clipKeepsTheInsideAndNamesTheCut() {
    ClipVertex[] in = {new ClipVertex(), new ClipVertex()};
    ClipVertex[] out = {new ClipVertex(), new ClipVertex()};
    in[0].v.set(-1f, 2f);
    in[0].id.indexB = 5;
    in[1].v.set(3f, 6f);
    in[1].id.indexB = 6;
    assertEquals(2, Collision.clipSegmentToLine(out, in, new Vec2(1f, 0f), 1f, 7));
    assertEquals(new Vec2(-1f, 2f), out[0].v);
    assertEquals(5, out[0].id.indexB);
    assertEquals(new Vec2(1f, 4f), out[1].v);
    assertEquals(7, out[1].id.indexA);
    assertEquals(ContactID.Type.VERTEX.ordinal(), out[1].id.typeA);
    assertEquals(ContactID.Type.FACE.ordinal(), out[1].id.typeB);
    assertEquals(0, Collision.clipSegmentToLine(out, in, new Vec2(0f, 1f), 1f, 7));
    assertEquals(2, Collision.clipSegmentToLine(out, in, new Vec2(0f, -1f), -2f, 7));
  }

  @Test
  void separationsAndIncidentEdgesOfTwoBoxes() {
    PolygonShape box = new PolygonShape();
    box.setAsBox(1f, 0.5f);
    // A box two metres wide lies at 3 m to the right, turned by a quarter.
    Transform xf1 = ConvexOracle.at(10.0, 0.0, Math.PI / 2.0);
    Transform xf2 = ConvexOracle.at(13.0, 0.2, 0.0);
    EdgeResults results = new EdgeResults();
    collision.findMaxSeparation(results, box, xf1, box, xf2);
    assertEquals(3f - 0.5f - 1f, results.separation, TOLERANCE);
    // Its outward normal is (1, 0) in the world: (0, -1) in the box.
    assertEquals(-1f, box.m_normals[results.edgeIndex].y, TOLERANCE);
    assertEquals(
        results.separation,
        collision.edgeSeparation(box, xf1, results.edgeIndex, box, xf2),
        TOLERANCE);

    ClipVertex[] incident = {new ClipVertex(), new ClipVertex()};
    collision.findIncidentEdge(incident, box, xf1, results.edgeIndex, box, xf2);
    for (ClipVertex end : incident) {
      assertEquals(12f, end.v.x, TOLERANCE);
      assertEquals(results.edgeIndex, end.id.indexA);
    }
    assertEquals(0.7f, incident[0].v.y, TOLERANCE);
    assertEquals(-0.3f, incident[1].v.y, TOLERANCE);
  }

  @Test
  void overlapIncludesTheSkins() {
    CircleShape circle = new CircleShape();
    circle.m_radius = 0.5f;
    PolygonShape box = new PolygonShape();
    box.setAsBox(1f, 1f);
    Transform xfA = ConvexOracle.at(0.0, 0.0, 0.0);
    assertTrue(
        collision.testOverlap(box, 0, circle, 0, xfA, ConvexOracle.at(1.5 + 0.0099, 0.0, 0.0)));
    assertFalse(
        collision.testOverlap(box, 0, circle, 0, xfA, ConvexOracle.at(1.5 + 0.0101, 0.0, 0.0)));
    assertTrue(collision.testOverlap(box, 0, circle, 0, xfA, xfA));
  }
}
