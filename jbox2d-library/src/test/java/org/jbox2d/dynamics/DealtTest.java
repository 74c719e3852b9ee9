package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Contacts and joints of large islands are dealt in parts that take turns. */
class DealtTest {
  /** Each gets a place of its own, and those made one after the other come apart by the parts. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 4})
  void eachGetsAPlace(int parts) {
    for (int n = 1; n < 300; n++) {
      boolean[] taken = new boolean[n];
      int apart = 0;
      for (int i = 0; i < n; i++) {
        int place = Islands.dealt(i, n, parts);
        assertTrue(place >= 0 && place < n && !taken[place], n + ": " + i + " to " + place);
        taken[place] = true;
        apart += i > 0 && place == Islands.dealt(i - 1, n, parts) + parts ? 1 : 0;
      }
      assertEquals(Math.max(0, n - Math.min(n, parts)), apart, "of " + n);
    }
  }
}
