package org.jbox2d.fracture;

import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.contacts.Contact;

/**
 * Runs a task after a step and before its fractures: it is deferred from {@code preSolve}, so it is
 * queued before fractures are, which are recorded after solving.
 */
final class BeforeFracture implements ContactListener {
  private final World world;
  private final Runnable task;
  private boolean queued;

  private BeforeFracture(World world, Runnable task) {
    this.world = world;
    this.task = task;
  }

  static void listen(World world, Runnable task) {
    world.setContactListener(new BeforeFracture(world, task));
  }

  @Override
  public void preSolve(Contact contact, Manifold oldManifold) {
    if (!queued) {
      queued = true;
      world.defer(
          () -> {
            queued = false;
            task.run();
          });
    }
  }

  @Override
  public void beginContact(Contact contact) {}

  @Override
  public void endContact(Contact contact) {}

  @Override
  public void postSolve(Contact contact, ContactImpulse impulse) {}
}
