package org.jbox2d.dynamics;

import java.util.Arrays;

/**
 * The bodies that a step looks at: awake, active and not static. Dense, so that what sleeps costs
 * nothing; a body's place in it is its solver slot. A removal moves the last body into the gap.
 */
final class AwakeSet {
  Body[] bodies = new Body[64];
  int count;

  void add(Body body) {
    if (body.awakeIndex >= 0) {
      return;
    }
    if (count == bodies.length) {
      bodies = Arrays.copyOf(bodies, count + (count >> 1));
    }
    body.awakeIndex = count;
    bodies[count++] = body;
  }

  void remove(Body body) {
    int i = body.awakeIndex;
    if (i < 0) {
      return;
    }
    Body last = bodies[--count];
    bodies[i] = last;
    last.awakeIndex = i;
    bodies[count] = null;
    body.awakeIndex = -1;
  }
}
