package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.broadphase.DefaultBroadPhaseBuffer;
import org.jbox2d.collision.broadphase.DynamicTree;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.pooling.normal.DefaultWorldPool;
import org.junit.jupiter.api.Test;

/** Contacts are passed over while tight boxes are apart; that must not be seen in the motion. */
class TightBoxesTest {
  private static World world(boolean passOver) {
    DefaultBroadPhaseBuffer broadPhase =
        new DefaultBroadPhaseBuffer(new DynamicTree()) {
          @Override
          public boolean testTightOverlap(int proxyIdA, int proxyIdB, float slack) {
            return passOver
                ? super.testTightOverlap(proxyIdA, proxyIdB, slack)
                : testOverlap(proxyIdA, proxyIdB);
          }
        };
    World world = new World(new Vec2(0f, -10f), new DefaultWorldPool(10, 10), broadPhase);
    PolygonShape box = new PolygonShape();
    box.setAsBox(20f, 1f);
    world.createBody(new BodyDef()).createFixture(box, 0f);
    box.setAsBox(0.1f, 0.2f);
    CircleShape ball = new CircleShape();
    ball.m_radius = 0.15f;
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    for (int i = 0; i < 60; i++) {
      def.position.set(0.37f * (i % 8) + 0.01f * i, 1.5f + 0.45f * (i / 8));
      def.angle = 0.3f * i;
      def.bullet = i % 10 == 0;
      world.createBody(def).createFixture(i % 3 == 0 ? ball : box, 1f);
    }
    return world;
  }

  private static int[] bitsAfter(World world, int steps) {
    for (int i = 0; i < steps; i++) {
      world.step(1f / 60f, 8, 3);
    }
    int[] bits = new int[3 * world.getBodyCount()];
    int k = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      bits[k++] = Float.floatToRawIntBits(b.getPosition().x);
      bits[k++] = Float.floatToRawIntBits(b.getPosition().y);
      bits[k++] = Float.floatToRawIntBits(b.getAngle());
    }
    return bits;
  }

  @Test
  void passingOverContactsChangesNoBit() {
    World world = world(true);
    int[] bits = bitsAfter(world, 200);
    assertTrue(world.getContactCount() > 60, "a pile with contacts");
    assertArrayEquals(bitsAfter(world(false), 200), bits);
  }

  @Test
  void splintersHaveContactsWithTheirNeighboursAlone() {
    World world = new World(new Vec2());
    PolygonShape box = new PolygonShape();
    box.setAsBox(0.01f, 0.01f);
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    int side = 10;
    for (int i = 0; i < side * side; i++) {
      def.position.set(0.05f * (i % side), 0.05f * (i / side));
      world.createBody(def).createFixture(box, 1f);
    }
    world.step(1f / 60f, 8, 3);
    // Each is within reach of the eight around it at most, which makes four contacts a body.
    assertTrue(world.getContactCount() <= 4 * side * side, "contacts: " + world.getContactCount());
  }
}
