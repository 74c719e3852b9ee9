package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jbox2d.dynamics.contacts.ContactEdge;

/**
 * The bodies that a step looks at: awake, active and not static. Dense, so that what sleeps costs
 * nothing; a body's place in it is its solver slot. A removal moves the last body into the gap.
 */
final class AwakeSet {
  Body[] bodies = new Body[64];
  int count;

  /**
   * Rises with each change of what joints may tie together: the bodies here and their places, the
   * joints, whether bodies are active.
   */
  int changes;

  private final ContactManager contacts;

  /** Bodies put to sleep by hand during a step. */
  private final List<Body> leaving = new ArrayList<>();

  AwakeSet(ContactManager contacts) {
    this.contacts = contacts;
  }

  /** Lets the step look at a body and its contacts, if it is awake, active and can move. */
  void enter(Body b) {
    if (b.m_type == BodyType.STATIC || !b.isActive() || !b.isAwake() || b.m_world == null) {
      return;
    }
    if (b.awakeIndex < 0) {
      b.standStill();
      add(b);
    }
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      contacts.activate(edge.contact);
    }
  }

  private void add(Body body) {
    if (count == bodies.length) {
      bodies = Arrays.copyOf(bodies, count + (count >> 1));
    }
    changes++;
    body.awakeIndex = count;
    bodies[count++] = body;
  }

  /** Takes a body out; its contacts stay active. */
  void remove(Body body) {
    int i = body.awakeIndex;
    if (i < 0) {
      return;
    }
    changes++;
    Body last = bodies[--count];
    bodies[i] = last;
    last.awakeIndex = i;
    bodies[count] = null;
    body.awakeIndex = -1;
  }

  /**
   * A body has been put to sleep by hand.
   *
   * @param stepping whether a step is going on: then it leaves between phases, by {@link #letLeave}
   */
  void leave(Body b, boolean stepping) {
    if (b.awakeIndex < 0) {
      return;
    }
    if (stepping) {
      leaving.add(b);
    } else {
      letRest(b);
    }
  }

  /** Takes out what has been put to sleep by hand, and has not been woken since. */
  void letLeave() {
    for (int i = 0; i < leaving.size(); i++) {
      Body b = leaving.get(i);
      if (!b.isAwake()) {
        letRest(b);
      }
    }
    leaving.clear();
  }

  /** Puts a body to sleep between phases of the step. */
  void fallAsleep(Body b) {
    b.setAwake(false);
    letRest(b);
  }

  private void letRest(Body b) {
    remove(b);
    for (ContactEdge edge = b.m_contactList; edge != null; edge = edge.next) {
      if (edge.other.awakeIndex < 0) {
        contacts.letRest(edge.contact);
      }
    }
  }
}
