package org.jbox2d.testbed.scenes;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.contacts.Contact;

/**
 * Lets bodies pass platforms from below. Whether a body passes is settled when they begin to touch,
 * and holds until they no longer do: a body that turns back half-way falls out again.
 */
final class OneSided implements ContactListener {
  private final List<Body> platforms = new ArrayList<>();
  private final List<Float> tops = new ArrayList<>();
  private final Set<Contact> passing = Collections.newSetFromMap(new IdentityHashMap<>());

  /** Adds a platform with its upper side at the given height, m. */
  void add(Body platform, float top) {
    platforms.add(platform);
    tops.add(top);
  }

  @Override
  public void beginContact(Contact contact) {
    int a = platforms.indexOf(contact.getFixtureA().getBody());
    int b = platforms.indexOf(contact.getFixtureB().getBody());
    Body guest = (a >= 0 ? contact.getFixtureB() : contact.getFixtureA()).getBody();
    int platform = Math.max(a, b);
    if (platform >= 0 && guest.getWorldCenter().y < tops.get(platform)) {
      passing.add(contact);
    }
  }

  @Override
  public void preSolve(Contact contact, Manifold oldManifold) {
    if (passing.contains(contact)) {
      contact.setEnabled(false);
    }
  }

  @Override
  public void endContact(Contact contact) {
    passing.remove(contact);
  }

  @Override
  public void postSolve(Contact contact, ContactImpulse impulse) {}
}
