package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies that were made in each other. */
class DeepOverlapTest {
  /**
   * Nine boxes, each in its neighbours by 0.3 m, come apart and lie still, with any rate of steps.
   * With substeps they flew apart at 2.1 m/s, and when that was mended for 60 steps a second at 1.3
   * and 1.7 m/s with 120 and 240: passes took back but a part of the speeds that pushed them. Taken
   * away is what comes in above 5 mm/s of the mean energy; a corner box may have twice that.
   */
  @ParameterizedTest
  @ValueSource(ints = {30, 60, 120, 240})
  void aHeapComesApartWithoutABurst(int rate) {
    World world = new World(new Vec2(0f, 0f));
    world.setSolver(Solver.softStep());
    Body[] boxes = new Body[9];
    for (int i = 0; i < boxes.length; i++) {
      BodyDef def = new BodyDef();
      def.type = BodyType.DYNAMIC;
      def.position.set(0.7f * (i % 3), 0.7f * (i / 3));
      PolygonShape box = new PolygonShape();
      box.setAsBox(0.5f, 0.5f);
      boxes[i] = world.createBody(def);
      boxes[i].createFixture(box, 1f).setFriction(0.5f);
    }
    for (int i = 0; i < 3 * rate; i++) {
      world.step(1f / rate, 8, 3);
    }
    for (int i = 0; i < boxes.length; i++) {
      assertEquals(0f, boxes[i].getLinearVelocity().length(), 0.02f);
      for (int k = 0; k < i; k++) {
        float apart = boxes[i].getPosition().sub(boxes[k].getPosition()).length();
        assertTrue(apart > 0.9f);
      }
    }
    assertEquals(9, world.getBodyCount());
  }
}
