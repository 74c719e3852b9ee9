package org.jbox2d.testbed.simulation;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;

/**
 * A 64-bit hash of the state of a world: the bits of position, angle, velocity and angular velocity
 * of each body, whether it is awake and how many fixtures it has, in the order of the world's list,
 * and the number of contacts. Equal runs have equal hashes, to the last bit of each float.
 */
public final class StateHash {
  /** Offset basis of FNV-1a (Fowler, Noll, Vo), 64 bits. */
  private static final long BASIS = 0xcbf29ce484222325L;

  /** Prime of FNV-1a, 64 bits. */
  private static final long PRIME = 0x100000001b3L;

  private long hash = BASIS;

  private StateHash() {}

  /** Returns the hash of a world between steps. */
  public static long of(World world) {
    StateHash state = new StateHash();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      state.add(b);
    }
    state.add(world.getBodyCount());
    state.add(world.getContactCount());
    return state.hash;
  }

  /** Returns a short hash of each body's state, the oldest body first. */
  public static int[] ofBodies(World world) {
    int[] hashes = new int[world.getBodyCount()];
    int i = hashes.length;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      StateHash state = new StateHash();
      state.add(b);
      hashes[--i] = Long.hashCode(state.hash);
    }
    return hashes;
  }

  private void add(Body b) {
    add(b.getType().ordinal());
    add(b.isAwake() ? 1 : 0);
    add(b.m_fixtureCount);
    add(b.getPosition().x);
    add(b.getPosition().y);
    add(b.getAngle());
    add(b.getLinearVelocity().x);
    add(b.getLinearVelocity().y);
    add(b.getAngularVelocity());
  }

  private void add(float value) {
    add(Float.floatToRawIntBits(value));
  }

  private void add(int bits) {
    for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
      hash = (hash ^ (bits >>> shift & 0xff)) * PRIME;
    }
  }
}
