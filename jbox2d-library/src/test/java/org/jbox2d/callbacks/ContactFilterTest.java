package org.jbox2d.callbacks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

class ContactFilterTest {

  private final World world = new World(new Vec2());
  private final ContactFilter filter = new ContactFilter();

  @Test
  void allCollideByDefault() {
    assertTrue(collide(fixture(1, 0xffff, 0), fixture(1, 0xffff, 0)));
  }

  @Test
  void eachMaskMustHoldTheOthersCategory() {
    assertTrue(collide(fixture(2, 4, 0), fixture(4, 2, 0)));
    assertFalse(collide(fixture(2, 4, 0), fixture(4, 1, 0)));
    assertFalse(collide(fixture(2, 4, 0), fixture(8, 2, 0)));
  }

  @Test
  void aCommonGroupGoesBeforeTheMasks() {
    assertTrue(collide(fixture(2, 0, 5), fixture(4, 0, 5)));
    assertFalse(collide(fixture(1, 0xffff, -5), fixture(1, 0xffff, -5)));
    assertTrue(collide(fixture(1, 0xffff, -5), fixture(1, 0xffff, -6)));
    assertFalse(collide(fixture(2, 0, 5), fixture(4, 0, 6)));
  }

  @Test
  void impulsesHaveRoomForEachContactPoint() {
    ContactImpulse impulse = new ContactImpulse();
    assertEquals(Settings.maxManifoldPoints, impulse.normalImpulses.length);
    assertEquals(Settings.maxManifoldPoints, impulse.tangentImpulses.length);
    assertEquals(0, impulse.count);
  }

  /** The answer must not depend on the order. */
  private boolean collide(Fixture a, Fixture b) {
    boolean answer = filter.shouldCollide(a, b);
    assertEquals(answer, filter.shouldCollide(b, a));
    return answer;
  }

  private Fixture fixture(int category, int mask, int group) {
    CircleShape circle = new CircleShape();
    circle.m_radius = 1;
    FixtureDef def = new FixtureDef();
    def.shape = circle;
    def.filter.categoryBits = category;
    def.filter.maskBits = mask;
    def.filter.groupIndex = group;
    return world.createBody(new BodyDef()).createFixture(def);
  }
}
