package org.jbox2d.testbed.scenes;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.contacts.Contact;

/** Gives contacts with a belt the speed of its surface. */
final class Belts implements ContactListener {
  private final List<Body> belts = new ArrayList<>();
  private final List<Float> speeds = new ArrayList<>();

  /** Adds a belt; its upper side moves to the right at the given speed, m/s. */
  void add(Body belt, float speed) {
    belts.add(belt);
    speeds.add(speed);
  }

  @Override
  public void preSolve(Contact contact, Manifold oldManifold) {
    int a = belts.indexOf(contact.getFixtureA().getBody());
    int b = belts.indexOf(contact.getFixtureB().getBody());
    if (a >= 0) {
      contact.setTangentSpeed(speeds.get(a));
    } else if (b >= 0) {
      contact.setTangentSpeed(speeds.get(b));
    }
  }

  @Override
  public void beginContact(Contact contact) {}

  @Override
  public void endContact(Contact contact) {}

  @Override
  public void postSolve(Contact contact, ContactImpulse impulse) {}
}
