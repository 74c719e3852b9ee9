package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.callbacks.ContactFilter;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The search for pairs leaves out those that the default filter would drop. With a filter of a
 * program's own, which decides the same, it finds them all: the contacts must be no others.
 */
class PairFilterTest {
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void contactsAreThoseOfAWorldThatAsksTheFilterOfEachPair(long seed) {
    Crowd crowd = new Crowd(seed, new ContactFilter());
    Crowd asked = new Crowd(seed, new ContactFilter() {});
    int touched = 0;
    for (int n = 0; n < 500; n++) {
      crowd.changeOne();
      asked.changeOne();
      crowd.world.step(1 / 60f, 4, 2);
      asked.world.step(1 / 60f, 4, 2);
      assertEquals(asked.contacts(), crowd.contacts());
      assertEquals(StateHash.of(asked.world), StateHash.of(crowd.world));
      WorldInvariants.check(crowd.world);
      touched += crowd.world.getContactCount();
    }
    assertTrue(touched > 500);
  }

  /** Discs that fly about in a region without gravity, each with a filter of its own. */
  private static final class Crowd {
    final World world = new World(new Vec2());
    private final Random random;
    private final List<Fixture> fixtures = new ArrayList<>();
    private int made;

    Crowd(long seed, ContactFilter filter) {
      random = new Random(seed);
      world.setContactFilter(filter);
      for (int i = 0; i < 25; i++) {
        add();
      }
    }

    private void add() {
      BodyDef def = new BodyDef();
      def.type = random.nextInt(4) == 0 ? BodyType.STATIC : BodyType.DYNAMIC;
      def.position.set(3 * random.nextFloat(), 3 * random.nextFloat());
      def.linearVelocity.set(4 * random.nextFloat() - 2, 4 * random.nextFloat() - 2);
      FixtureDef fixture = new FixtureDef();
      fixture.shape = new CircleShape();
      fixture.shape.m_radius = 0.2f;
      fixture.density = 1;
      fixture.restitution = 1;
      fixture.userData = made++;
      change(fixture.filter);
      fixtures.add(world.createBody(def).createFixture(fixture));
    }

    private void change(Filter filter) {
      filter.categoryBits = random.nextInt(8);
      filter.maskBits = random.nextInt(8);
      filter.groupIndex = random.nextInt(3) == 0 ? random.nextInt(5) - 2 : 0;
    }

    void changeOne() {
      Fixture one = fixtures.get(random.nextInt(fixtures.size()));
      Filter filter = new Filter();
      change(filter);
      switch (random.nextInt(12)) {
        case 0 -> one.setFilterData(filter);
        case 1 -> one.getFilterData().set(filter);
        case 2 -> {
          one.m_filter.set(filter);
          one.refilter();
        }
        case 3 -> one.m_body.setActive(!one.m_body.isActive());
        case 4 -> {
          fixtures.remove(one);
          world.destroyBody(one.m_body);
          add();
        }
        default -> one.m_body.setLinearVelocity(wayTo(3 * random.nextFloat(), one).mul(10));
      }
    }

    /** They come back, and some so fast that they are followed within the step. */
    private static Vec2 wayTo(float place, Fixture fixture) {
      return new Vec2(place, place).sub(fixture.m_body.getPosition());
    }

    List<String> contacts() {
      List<String> pairs = new ArrayList<>();
      for (Contact c = world.getContactList(); c != null; c = c.getNext()) {
        pairs.add(c.m_fixtureA.m_userData + ", " + c.m_fixtureB.m_userData);
      }
      return pairs;
    }
  }

  /** A gate that has been asked for its filter may be opened and closed without another word. */
  @Test
  void aFilterThatIsHeldByAProgramTakesEffectWhenItIsChanged() {
    World world = new World(new Vec2());
    Fixture gate = disc(world, BodyType.STATIC, 0);
    gate.m_filter.categoryBits = 2;
    gate.refilter();
    Filter held = gate.getFilterData();
    Fixture ball = disc(world, BodyType.DYNAMIC, -1.2f);
    ball.m_filter.maskBits = 4;
    ball.refilter();
    ball.m_body.setLinearVelocity(new Vec2(1, 0));
    world.step(1 / 60f, 8, 3);
    assertNull(world.getContactList());
    held.categoryBits = 4;
    for (int n = 0; n < 30; n++) {
      world.step(1 / 60f, 8, 3);
    }
    assertNotNull(world.getContactList());
    assertTrue(ball.m_body.getPosition().x < -0.95f, "it went into the gate");
  }

  /** It is 4 cm from touching, and has been looked at before. */
  @Test
  void aContactThatIsFlaggedIsFilteredThoughItIsApart() {
    World world = new World(new Vec2());
    Fixture one = disc(world, BodyType.STATIC, 0);
    disc(world, BodyType.DYNAMIC, 1.04f);
    world.step(1 / 60f, 8, 3);
    world.step(1 / 60f, 8, 3);
    Contact contact = world.getContactList();
    assertNotNull(contact);
    one.getFilterData().maskBits = 0;
    contact.flagForFiltering();
    world.step(1 / 60f, 8, 3);
    assertNull(world.getContactList());
    contact.flagForFiltering();
    world.step(1 / 60f, 8, 3);
    WorldInvariants.check(world);
  }

  private static Fixture disc(World world, BodyType type, float x) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, 0);
    CircleShape shape = new CircleShape();
    shape.m_radius = 0.5f;
    return world.createBody(def).createFixture(shape, 1);
  }
}
