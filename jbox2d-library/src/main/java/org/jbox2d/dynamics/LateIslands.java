package org.jbox2d.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.SolverBodies;
import org.jbox2d.dynamics.solver.SpinBooks;

/**
 * Puts bodies that lag behind where they would be. Their impulses acted where they were before, so
 * to move them changes the angular momentum; where nothing outside can have taken part in a blow
 * and what came of it, its islands get that back.
 */
final class LateIslands {
  private final AwakeSet awake;
  private final Islands islands;
  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private final SpinBooks spin;

  /** Slots of all bodies of the islands that are moved together. */
  private int[] slots = new int[16];

  private int slotCount;

  /** Islands whose bodies have been collected. */
  private boolean[] collected = new boolean[0];

  LateIslands(AwakeSet awake, Islands islands, SolverBodies bodies, ContactConstraints contacts) {
    this.awake = awake;
    this.islands = islands;
    this.bodies = bodies;
    this.contacts = contacts;
    spin = new SpinBooks(bodies);
  }

  /** Moves bodies, which have been solved in this step, by what they lag behind. */
  void moveOn(List<Laggards.Lag> lags) {
    collected = new boolean[islands.count];
    for (List<Laggards.Lag> together : divide(lags)) {
      collectIslands(together);
      boolean closed = isClosed(together);
      if (closed) {
        spin.open(slots, 0, slotCount);
      }
      for (Laggards.Lag lag : together) {
        move(lag);
      }
      if (closed) {
        spin.closeMoved(slots, 0, slotCount, SpinBooks.LARGE);
        readVelocities();
      }
    }
  }

  /** Brings together what shares a group or an island, in the order given. */
  private Iterable<List<Laggards.Lag>> divide(List<Laggards.Lag> lags) {
    int[] parent = new int[lags.size()];
    Map<Object, Integer> ofGroup = new IdentityHashMap<>();
    Map<Integer, Integer> ofIsland = new HashMap<>();
    for (int i = 0; i < parent.length; i++) {
      parent[i] = i;
      Object group = lags.get(i).group;
      unite(parent, i, group == null ? null : ofGroup.putIfAbsent(group, i));
      unite(parent, i, ofIsland.putIfAbsent(islandOf(lags.get(i)), i));
    }
    List<List<Laggards.Lag>> parts = new ArrayList<>();
    int[] part = new int[parent.length];
    for (int i = 0; i < parent.length; i++) {
      int root = find(parent, i);
      if (root == i) {
        part[i] = parts.size();
        parts.add(new ArrayList<>());
      }
      parts.get(part[root]).add(lags.get(i));
    }
    return parts;
  }

  private static int find(int[] parent, int i) {
    while (parent[i] != i) {
      i = parent[i];
    }
    return i;
  }

  /** The root of a set is its first member. */
  private static void unite(int[] parent, int i, Integer other) {
    if (other != null) {
      int a = find(parent, i);
      int b = find(parent, other);
      parent[Math.max(a, b)] = Math.min(a, b);
    }
  }

  private int islandOf(Laggards.Lag lag) {
    return islands.islandOf[lag.body.m_islandIndex];
  }

  /** Collects the bodies of all islands of some bodies. */
  private void collectIslands(List<Laggards.Lag> lags) {
    slotCount = 0;
    for (Laggards.Lag lag : lags) {
      int k = islandOf(lag);
      if (!collected[k]) {
        collected[k] = true;
        int n = islands.bodyStart[k + 1] - islands.bodyStart[k];
        if (slots.length < slotCount + n) {
          slots = Arrays.copyOf(slots, 2 * (slotCount + n));
        }
        System.arraycopy(islands.bodies, islands.bodyStart[k], slots, slotCount, n);
        slotCount += n;
      }
    }
  }

  /** Whether all of the blows were among bodies that nothing outside touches. */
  private boolean isClosed(List<Laggards.Lag> lags) {
    for (Laggards.Lag lag : lags) {
      if (lag.group == null || !isAlone(islandOf(lag))) {
        return false;
      }
    }
    return true;
  }

  /** Whether the bodies of an island touch each other alone, and have no joints. */
  private boolean isAlone(int k) {
    return !islands.hasJoints(k)
        && spin.areAlone(
            islands.bodies,
            islands.bodyStart[k],
            islands.bodyStart[k + 1],
            contacts,
            islands.contactStart[k],
            islands.contactStart[k + 1]);
  }

  private void move(Laggards.Lag lag) {
    lag.move();
    int o = SolverBodies.STRIDE * lag.body.m_islandIndex;
    bodies.pos[o] = lag.body.m_sweep.c.x;
    bodies.pos[o + 1] = lag.body.m_sweep.c.y;
  }

  private void readVelocities() {
    for (int i = 0; i < slotCount; i++) {
      Body b = awake.bodies[slots[i]];
      int o = SolverBodies.STRIDE * slots[i];
      b.m_linearVelocity.set(bodies.vel[o], bodies.vel[o + 1]);
      b.m_angularVelocity = bodies.vel[o + 2];
    }
  }
}
