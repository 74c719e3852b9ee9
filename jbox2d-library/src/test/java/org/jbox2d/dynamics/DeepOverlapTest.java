package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;

/** Bodies that were made in each other. */
class DeepOverlapTest {
  /**
   * Nine boxes, each in its neighbours by 0.3 m, come apart and lie still. With substeps they flew
   * apart at 2.1 m/s: one pass took back but a part of the speeds that pushed them.
   */
  @Test
  void aHeapComesApartWithoutABurst() {
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
    for (int i = 0; i < 180; i++) {
      world.step(1f / 60f, 8, 3);
    }
    for (int i = 0; i < boxes.length; i++) {
      assertTrue(boxes[i].getLinearVelocity().length() < 0.25f);
      for (int k = 0; k < i; k++) {
        float apart = boxes[i].getPosition().sub(boxes[k].getPosition()).length();
        assertTrue(apart > 0.9f);
      }
    }
    assertEquals(9, world.getBodyCount());
  }
}
