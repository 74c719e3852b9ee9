package org.jbox2d.internal;

import java.util.Arrays;

/**
 * A set of longs with open addressing. Linear probing keeps a look-up within one or two cache
 * lines; removal shifts the rest of the cluster back (Knuth, TAOCP volume 3, section 6.4, algorithm
 * R) instead of leaving tombstones, so that the table does not degrade under the steady insertion
 * and removal of contact pairs. It has no iteration, on purpose: nothing of the simulation may
 * depend on the order of a hash table. No allocation but for growth.
 */
public final class LongHashSet {
  private static final int MIN_CAPACITY = 16;

  /** Marks a free slot; the key 0 itself is kept in {@link #hasZero}. */
  private static final long FREE = 0;

  /** Slots; the length is a power of two, and at most half of them are in use. */
  private long[] slots;

  private int mask;
  private int used;
  private boolean hasZero;

  /** An empty set. */
  public LongHashSet() {
    this(0);
  }

  /**
   * An empty set.
   *
   * @param expected number of keys it takes before it first grows, from 0 to 2^28
   */
  public LongHashSet(int expected) {
    if (expected < 0 || expected > 1 << 28) {
      throw new IllegalArgumentException("expected size must be in [0, 2^28]: " + expected);
    }
    int capacity = MIN_CAPACITY;
    while (capacity < 2 * expected) {
      capacity *= 2;
    }
    slots = new long[capacity];
    mask = capacity - 1;
  }

  public int size() {
    return hasZero ? used + 1 : used;
  }

  public boolean contains(long key) {
    return key == FREE ? hasZero : slots[find(key)] == key;
  }

  /** Adds a key; returns whether it was new. */
  public boolean add(long key) {
    if (key == FREE) {
      boolean isNew = !hasZero;
      hasZero = true;
      return isNew;
    }
    int slot = find(key);
    if (slots[slot] == key) {
      return false;
    }
    if (2 * (used + 1) > slots.length) {
      grow();
      slot = find(key);
    }
    slots[slot] = key;
    used++;
    return true;
  }

  /** Removes a key; returns whether it was there. */
  public boolean remove(long key) {
    if (key == FREE) {
      boolean was = hasZero;
      hasZero = false;
      return was;
    }
    int slot = find(key);
    if (slots[slot] != key) {
      return false;
    }
    closeGap(slot);
    used--;
    return true;
  }

  /** Empties the set and keeps its storage. */
  public void clear() {
    Arrays.fill(slots, FREE);
    used = 0;
    hasZero = false;
  }

  /** The slot that holds the key, or else the free slot at which its probing ends. */
  private int find(long key) {
    int slot = home(key);
    while (slots[slot] != key && slots[slot] != FREE) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  /**
   * Refills the slot of a removed key. A later key of the same cluster may move into the gap if its
   * home does not lie (cyclically) behind the gap, that is if its distance from home is at least
   * its distance from the gap.
   */
  private void closeGap(int gap) {
    int slot = gap;
    while (true) {
      slot = (slot + 1) & mask;
      long key = slots[slot];
      if (key == FREE) {
        slots[gap] = FREE;
        return;
      }
      int fromHome = (slot - home(key)) & mask;
      int fromGap = (slot - gap) & mask;
      if (fromHome >= fromGap) {
        slots[gap] = key;
        gap = slot;
      }
    }
  }

  private void grow() {
    long[] old = slots;
    slots = new long[2 * old.length];
    mask = slots.length - 1;
    for (long key : old) {
      if (key != FREE) {
        slots[find(key)] = key;
      }
    }
  }

  /**
   * The slot at which probing for a key starts: the 64-bit finalizer of Stafford's variant 13
   * (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators", section 4),
   * which spreads consecutive ids over all bits.
   */
  private int home(long key) {
    long h = key;
    h = (h ^ (h >>> 30)) * 0xBF58476D1CE4E5B9L;
    h = (h ^ (h >>> 27)) * 0x94D049BB133111EBL;
    return (int) (h ^ (h >>> 31)) & mask;
  }
}
