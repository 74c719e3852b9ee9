package org.jbox2d.dynamics;

import org.jbox2d.callbacks.DestructionListener;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.joints.JointEdge;

/** The bodies of a world. */
final class WorldBodies {
  /** The newest body. */
  Body list;

  int count;

  /** How many of them stop others within a step; see {@link Body#isObstacle}. */
  int obstacles;

  private final World world;

  WorldBodies(World world) {
    this.world = world;
  }

  /** See {@link World#createBody}; the definition has been checked. */
  Body create(BodyDef def) {
    Body b = new Body(def, world);
    b.m_next = list;
    if (list != null) {
      list.m_prev = b;
    }
    list = b;
    count++;
    obstacles += b.isObstacle() ? 1 : 0;
    world.awake.enter(b);
    return b;
  }

  /** See {@link World#destroyBody}; the body is of this world. */
  void destroy(Body body) {
    destroyJoints(body);
    for (ContactEdge edge = body.m_contactList; edge != null; edge = body.m_contactList) {
      world.m_contactManager.destroy(edge.contact);
    }
    destroyFixtures(body);
    if (body.m_world == null) {
      // A listener destroyed it meanwhile.
      return;
    }
    world.awake.remove(body);
    if (body.m_prev != null) {
      body.m_prev.m_next = body.m_next;
    } else {
      list = body.m_next;
    }
    if (body.m_next != null) {
      body.m_next.m_prev = body.m_prev;
    }
    body.m_world = null;
    world.awake.changes++;
    count--;
    obstacles -= body.isObstacle() ? 1 : 0;
  }

  private void destroyJoints(Body body) {
    for (JointEdge edge = body.m_jointList; edge != null; edge = body.m_jointList) {
      DestructionListener listener = world.getDestructionListener();
      if (listener != null) {
        listener.sayGoodbye(edge.joint);
      }
      // The listener may have destroyed it itself.
      if (body.m_jointList == edge) {
        world.destroyJoint(edge.joint);
      }
    }
  }

  private void destroyFixtures(Body body) {
    for (Fixture f = body.m_fixtureList; f != null; f = body.m_fixtureList) {
      DestructionListener listener = world.getDestructionListener();
      if (listener != null) {
        listener.sayGoodbye(f);
      }
      if (body.m_fixtureList != f) {
        continue;
      }
      body.m_fixtureList = f.m_next;
      body.m_fixtureCount--;
      f.destroyProxies(world.m_contactManager.m_broadPhase);
      f.destroy();
    }
  }
}
