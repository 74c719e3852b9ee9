package org.jbox2d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LongHashSetTest {
  @Provide
  Arbitrary<Long> keys() {
    return Arbitraries.oneOf(
        Arbitraries.longs().between(-4, 40),
        Arbitraries.longs().between(0, 6).map(high -> high << 32),
        Arbitraries.of(Long.MIN_VALUE, Long.MAX_VALUE, 0L));
  }

  /**
   * Steady insertion and removal of few keys in a small table: clusters form, wrap around its end,
   * and must close again.
   */
  @Property(tries = 300, seed = "4711")
  void behavesLikeHashSet(@ForAll("keys") long first, @ForAll Random random) {
    LongHashSet set = new LongHashSet();
    Set<Long> model = new HashSet<>();
    int range = 1 + random.nextInt(60);
    for (int i = 0; i < 400; i++) {
      long key = first + random.nextInt(range) * (random.nextBoolean() ? 1L : 1L << 32);
      if (random.nextInt(5) < 3) {
        assertEquals(model.add(key), set.add(key));
      } else {
        assertEquals(model.remove(key), set.remove(key));
      }
      assertEquals(model.size(), set.size());
      if (i % 20 == 0) {
        assertSameKeys(model, set, first, range);
      }
    }
    assertSameKeys(model, set, first, range);
  }

  private static void assertSameKeys(Set<Long> model, LongHashSet set, long first, int range) {
    for (int k = -1; k <= range; k++) {
      assertEquals(model.contains(first + k), set.contains(first + k));
      long wide = first + k * (1L << 32);
      assertEquals(model.contains(wide), set.contains(wide));
    }
  }

  @Test
  void growsFarBeyondItsFirstCapacity() {
    LongHashSet set = new LongHashSet();
    for (long key = 0; key < 100_000; key++) {
      assertTrue(set.add(key * 0x100000001L));
    }
    assertEquals(100_000, set.size());
    for (long key = 0; key < 100_000; key++) {
      assertFalse(set.add(key * 0x100000001L));
      assertFalse(set.contains(key * 0x100000001L + 1));
    }
    for (long key = 0; key < 100_000; key += 2) {
      assertTrue(set.remove(key * 0x100000001L));
    }
    for (long key = 0; key < 100_000; key++) {
      assertEquals(key % 2 == 1, set.contains(key * 0x100000001L));
    }
  }

  @Test
  void clearForgetsAllKeysZeroIncluded() {
    LongHashSet set = new LongHashSet(100);
    set.add(0);
    set.add(7);
    set.clear();
    assertEquals(0, set.size());
    assertFalse(set.contains(0));
    assertFalse(set.contains(7));
    assertTrue(set.add(0));
  }

  @Test
  void refusesNegativeSize() {
    assertThrows(IllegalArgumentException.class, () -> new LongHashSet(-1));
  }
}
