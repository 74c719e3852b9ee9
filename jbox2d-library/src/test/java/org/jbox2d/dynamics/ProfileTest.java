package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.contacts.Contact;
import org.junit.jupiter.api.Test;

/** The profile measures once somebody has asked for it. */
class ProfileTest {
  @Test
  void measuresFromTheFirstCallOn() {
    World world = Make.pyramid(8);
    Make.steps(world, 3);
    Profile profile = world.getProfile();
    assertEquals(0f, profile.step.getLast());
    Make.steps(world, 3);
    assertTrue(profile.step.getLast() > 0f);
    assertTrue(profile.solve.getLast() > 0f);
    assertTrue(profile.solve.getLast() <= profile.step.getLast());
  }

  /** Asked for in the middle of a step, it does not measure that step from nowhere. */
  @Test
  void aStepUnderWayIsNotMeasured() {
    World world = Make.world();
    Make.ground(world);
    Make.box(world, BodyType.DYNAMIC, 0f, 0.5f, 0.5f, 0.5f);
    Profile[] profile = new Profile[1];
    world.setContactListener(
        new ContactListener() {
          @Override
          public void beginContact(Contact contact) {
            profile[0] = world.getProfile();
          }

          @Override
          public void endContact(Contact contact) {}

          @Override
          public void preSolve(Contact contact, Manifold oldManifold) {}

          @Override
          public void postSolve(Contact contact, ContactImpulse impulse) {}
        });
    Make.steps(world, 1);
    assertEquals(0f, profile[0].step.getLast());
    assertEquals(0f, profile[0].solve.getLast());
    Make.steps(world, 1);
    assertTrue(profile[0].step.getLast() > 0f);
  }
}
