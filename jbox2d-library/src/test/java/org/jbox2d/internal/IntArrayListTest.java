package org.jbox2d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class IntArrayListTest {
  @Property(tries = 200, seed = "4712")
  void behavesLikeArrayList(
      @ForAll List<Integer> operations, @ForAll @IntRange(min = 0, max = 20) int capacity) {
    IntArrayList list = new IntArrayList(capacity);
    List<Integer> model = new ArrayList<>();
    for (int value : operations) {
      int at = model.isEmpty() ? 0 : Math.floorMod(value, model.size());
      switch (model.isEmpty() ? 0 : Math.floorMod(value, 6)) {
        case 1 -> assertEquals(model.remove(model.size() - 1), list.pop());
        case 2 -> {
          list.set(at, value);
          model.set(at, value);
        }
        case 3 -> {
          list.removeSwap(at);
          int last = model.remove(model.size() - 1);
          if (at < model.size()) {
            model.set(at, last);
          }
        }
        default -> {
          list.add(value);
          model.add(value);
        }
      }
      assertEquals(model.size(), list.size());
      assertEquals(model.isEmpty(), list.isEmpty());
    }
    for (int i = 0; i < model.size(); i++) {
      assertEquals(model.get(i), list.get(i));
    }
    int[] elements = Arrays.copyOf(list.raw(), list.size());
    assertEquals(model, Arrays.stream(elements).boxed().toList());
    list.clear();
    assertTrue(list.isEmpty());
  }

  @Test
  void refusesNegativeCapacity() {
    assertThrows(IllegalArgumentException.class, () -> new IntArrayList(-1));
  }
}
