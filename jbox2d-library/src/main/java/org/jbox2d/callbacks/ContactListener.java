package org.jbox2d.callbacks;

import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.contacts.Contact;

/**
 * Hears of contacts. The world is locked during all of these calls; to change it, use {@code
 * World.defer}.
 */
public interface ContactListener {
  /** Two fixtures begin to touch. */
  void beginContact(Contact contact);

  /**
   * Two fixtures cease to touch; also called when one of them is destroyed. Both fixtures are still
   * whole.
   */
  void endContact(Contact contact);

  /**
   * A touching contact is about to be solved; it may be disabled for this step. Not called for
   * sensors.
   *
   * @param oldManifold the manifold of the step before
   */
  void preSolve(Contact contact, Manifold oldManifold);

  /**
   * A contact has been solved.
   *
   * @param impulse the impulses of its points; valid only during the call
   */
  void postSolve(Contact contact, ContactImpulse impulse);
}
