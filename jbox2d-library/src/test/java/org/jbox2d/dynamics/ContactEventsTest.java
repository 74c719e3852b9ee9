package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.jbox2d.callbacks.ContactFilter;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** The listener hears of each touch once, in order, with fixtures, whatever happens meanwhile. */
class ContactEventsTest {

  /** Checks the order of events of each contact. */
  private static class Recorder implements ContactListener {
    final List<String> events = new ArrayList<>();
    final Set<Contact> touching = new HashSet<>();
    private final Set<Contact> presolved = new HashSet<>();

    @Override
    public void beginContact(Contact contact) {
      checkFixtures(contact);
      assertTrue(contact.isTouching());
      assertTrue(touching.add(contact), "begun twice");
      events.add("begin");
    }

    @Override
    public void endContact(Contact contact) {
      checkFixtures(contact);
      assertTrue(touching.remove(contact), "ended without having begun");
      presolved.remove(contact);
      events.add("end");
    }

    @Override
    public void preSolve(Contact contact, Manifold oldManifold) {
      checkFixtures(contact);
      assertTrue(touching.contains(contact), "solved before begun");
      assertNotNull(oldManifold);
      assertTrue(contact.getManifold().pointCount > 0);
      presolved.add(contact);
      events.add("pre");
    }

    @Override
    public void postSolve(Contact contact, ContactImpulse impulse) {
      checkFixtures(contact);
      assertTrue(presolved.remove(contact) || wakesInStep(), "post without pre");
      assertEquals(contact.getManifold().pointCount, impulse.count);
      assertTrue(impulse.normalImpulses[0] >= 0f);
      events.add("post");
    }

    /**
     * Whether bodies may be put to sleep while they touch an awake one. Then the islands of the
     * same step wake them again, and their other contacts are solved as they were when put to
     * sleep.
     */
    boolean wakesInStep() {
      return false;
    }

    private static void checkFixtures(Contact contact) {
      assertNotNull(contact.getFixtureA().getBody());
      assertNotNull(contact.getFixtureB().getBody());
    }
  }

  private final World world = Make.world();
  private final Body ground = Make.ground(world);
  private final Recorder recorder = new Recorder();

  {
    world.setContactListener(recorder);
  }

  @Test
  void aBounceBeginsAndEnds() {
    Body ball = Make.disc(world, 0f, 1f, 0.5f);
    Make.surface(ball, 0f, 1f);
    Make.steps(world, 40);
    assertEquals(List.of("begin", "pre", "post", "end"), recorder.events.subList(0, 4));
    assertEquals(1, recorder.events.stream().filter("begin"::equals).count());
  }

  @Test
  void restingIsSolvedEachStepUntilAsleep() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.steps(world, 200);
    assertFalse(box.isAwake());
    int solved = recorder.events.size();
    Make.steps(world, 20);
    assertEquals(solved, recorder.events.size());
    assertEquals(1, recorder.touching.size());
    world.destroyBody(box);
    assertEquals("end", recorder.events.get(recorder.events.size() - 1));
    assertTrue(recorder.touching.isEmpty());
  }

  @Test
  void aSensorBeginsAndEndsWithoutSolving() {
    Body ball = Make.body(world, BodyType.DYNAMIC, 0f, 2f);
    FixtureDef def = new FixtureDef();
    def.shape = Make.circle(0.5f);
    def.isSensor = true;
    ball.createFixture(def);
    Make.steps(world, 120);
    assertEquals(List.of("begin", "end"), recorder.events);
    assertTrue(ball.getPosition().y < -5f, "a sensor holds nothing");
  }

  @Test
  void becomingASensorAndBackKeepsEventsPaired() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.steps(world, 10);
    box.getFixtureList().setSensor(true);
    Make.steps(world, 2);
    assertTrue(box.getPosition().y < 0.51f);
    box.getFixtureList().setSensor(false);
    Make.steps(world, 60);
    assertEquals(0.5f, box.getPosition().y, 0.03f);
    WorldInvariants.check(world);
  }

  @Test
  void aContactDisabledInPreSolveDoesNotPush() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 1f, 0.5f, 0.5f);
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            contact.setEnabled(false);
          }

          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {
            throw new AssertionError("a disabled contact is solved");
          }
        });
    Make.steps(world, 60);
    assertEquals(1f - Make.G * 61 / 60 / 2, box.getPosition().y, 0.02f);
  }

  @Test
  void disablingLastsForAStepOnly() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    boolean[] disable = {true};
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            if (disable[0]) {
              contact.setEnabled(false);
            }
          }
        });
    Make.steps(world, 3);
    disable[0] = false;
    Make.steps(world, 60);
    assertEquals(0.5f, box.getPosition().y, 0.03f);
  }

  @Test
  void destroyingInEachStateEndsWhatHadBegun() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.steps(world, 3);
    box.destroyFixture(box.getFixtureList());
    assertTrue(recorder.touching.isEmpty());
    WorldInvariants.check(world);
    box.createFixture(Make.boxShape(0.5f, 0.5f), 1f);
    Make.steps(world, 3);
    assertEquals(1, recorder.touching.size());
    box.setActive(false);
    assertTrue(recorder.touching.isEmpty());
    WorldInvariants.check(world);
    box.setActive(true);
    Make.steps(world, 3);
    assertEquals(1, recorder.touching.size());
    box.setType(BodyType.KINEMATIC);
    assertTrue(recorder.touching.isEmpty(), "kinematic and static do not collide");
    Make.steps(world, 3);
    assertEquals(0, world.getContactCount());
    box.setType(BodyType.DYNAMIC);
    Make.steps(world, 3);
    assertEquals(1, recorder.touching.size());
    box.setTransform(new Vec2(0f, 50f), 0f);
    Make.steps(world, 3);
    assertTrue(recorder.touching.isEmpty());
    WorldInvariants.check(world);
  }

  @Test
  void aListenerMayDestroyTheOtherBodyWhenAContactEndsOutsideAStep() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Body top = Make.box(world, BodyType.DYNAMIC, 0f, 1.51f, 0.5f, 0.5f);
    Make.steps(world, 3);
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void endContact(Contact contact) {
            if (contact.m_fixtureA.m_body == top || contact.m_fixtureB.m_body == top) {
              world.destroyBody(top);
            }
          }
        });
    world.destroyBody(box);
    assertEquals(1, world.getBodyCount());
    assertEquals(0, world.getContactCount());
    WorldInvariants.check(world);
  }

  @Test
  void aListenerThatThrowsOnDestructionLeavesAllInPlace() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Make.steps(world, 3);
    world.setContactListener(
        new CollisionResponseTest.QuietListener() {
          @Override
          public void endContact(Contact contact) {
            throw new UnsupportedOperationException("test");
          }
        });
    try {
      box.destroyFixture(box.getFixtureList());
    } catch (UnsupportedOperationException expected) {
      assertEquals("test", expected.getMessage());
    }
    WorldInvariants.check(world);
    assertEquals(1, box.m_fixtureCount);
    world.setContactListener(null);
    box.destroyFixture(box.getFixtureList());
    assertEquals(0, world.getContactCount());
    WorldInvariants.check(world);
  }

  @Test
  void filtersDecideAndMayChange() {
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    Filter filter = new Filter();
    filter.groupIndex = -3;
    ground.getFixtureList().setFilterData(filter);
    box.getFixtureList().setFilterData(filter);
    Make.steps(world, 20);
    assertTrue(recorder.events.isEmpty());
    box.setTransform(new Vec2(0f, 0.51f), 0f);
    box.setLinearVelocity(new Vec2());
    filter.groupIndex = 0;
    box.getFixtureList().setFilterData(filter);
    Make.steps(world, 20);
    assertEquals(0.5f, box.getPosition().y, 0.03f);
    assertEquals(1, recorder.touching.size());
  }

  @Test
  void aCustomFilterIsAskedAndNullLetsAllCollide() {
    world.setContactFilter(
        new ContactFilter() {
          @Override
          public boolean shouldCollide(Fixture a, Fixture b) {
            return false;
          }
        });
    Body box = Make.box(world, BodyType.DYNAMIC, 0f, 0.51f, 0.5f, 0.5f);
    Make.steps(world, 5);
    assertEquals(0, world.getContactCount());
    world.setContactFilter(null);
    box.getFixtureList().refilter();
    Make.steps(world, 1);
    assertEquals(1, world.getContactCount());
  }

  /**
   * A listener that does to the bodies whatever is allowed in a locked world, at random: nothing
   * breaks, and events stay paired.
   */
  @Property(tries = 8, seed = "4")
  void whateverAListenerDoesTheWorldStaysConsistent(
      @ForAll @LongRange(min = 1, max = 1_000_000) long seed) {
    World pile = Make.debris(60, seed);
    java.util.Random random = new java.util.Random(seed);
    Recorder meddler =
        new Recorder() {
          @Override
          public void beginContact(Contact contact) {
            super.beginContact(contact);
            meddle(contact);
          }

          @Override
          public void endContact(Contact contact) {
            super.endContact(contact);
            meddle(contact);
          }

          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {
            super.preSolve(contact, oldManifold);
            meddle(contact);
          }

          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {
            super.postSolve(contact, impulse);
            meddle(contact);
          }

          @Override
          boolean wakesInStep() {
            return true;
          }

          private void meddle(Contact contact) {
            Fixture fixture = random.nextBoolean() ? contact.m_fixtureA : contact.m_fixtureB;
            Body body = fixture.getBody();
            switch (random.nextInt(40)) {
              case 0 -> body.setAwake(false);
              case 1 -> body.setAwake(true);
              case 2 -> {
                body.setAwake(false);
                body.setAwake(true);
              }
              case 3 -> fixture.setSensor(!fixture.isSensor() && body.m_mass > 0f);
              case 4 -> fixture.refilter();
              case 5 -> contact.setEnabled(false);
              case 6 -> body.setFixedRotation(!body.isFixedRotation());
              case 7 -> body.resetMassData();
              case 8 -> body.setLinearVelocity(new Vec2(random.nextFloat(), 1f));
              case 9 -> body.applyForceToCenter(new Vec2(random.nextFloat(), 1f));
              case 10 -> body.setSleepingAllowed(random.nextBoolean());
              case 11 -> body.setBullet(random.nextBoolean());
              default -> {
                // mostly nothing, so that the pile moves on
              }
            }
          }
        };
    pile.setContactListener(meddler);
    for (int i = 0; i < 240; i++) {
      pile.step(Make.STEP, 8, 3);
      WorldInvariants.check(pile);
      if (i % 10 == 0) {
        Body body = pile.getBodyList();
        if (random.nextBoolean() && body.getType() == BodyType.DYNAMIC) {
          pile.destroyBody(body);
          WorldInvariants.check(pile);
        }
      }
    }
    assertTrue(meddler.events.size() > 100);
    Set<Contact> touching = new HashSet<>();
    for (Contact c = pile.getContactList(); c != null; c = c.getNext()) {
      if (c.isTouching()) {
        touching.add(c);
      }
    }
    assertEquals(touching, meddler.touching);
  }
}
