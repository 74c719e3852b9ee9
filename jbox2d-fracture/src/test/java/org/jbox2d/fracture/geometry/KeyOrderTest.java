package org.jbox2d.fracture.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class KeyOrderTest {
  private static final int CASES = 600;

  private static double key(Random random, int kind) {
    return switch (kind) {
      case 0 -> random.nextDouble();
      case 1 -> random.nextInt(5) - 2;
      case 2 -> 1e6 + random.nextInt(9) * 0x1p-30;
      case 3 -> (random.nextBoolean() ? 1 : -1) * Math.pow(10, random.nextInt(120) - 60);
      case 4 -> random.nextBoolean() ? 0.0 : -0.0;
      default -> random.nextGaussian() * random.nextGaussian();
    };
  }

  @Test
  void ascendingAndStableForKeysOfEveryKind() {
    Random random = new Random(3);
    KeyOrder order = new KeyOrder();
    for (int c = 0; c < CASES; c++) {
      int n = random.nextInt(c % 20 == 0 ? 2000 : 80);
      double[] keys = new double[n];
      for (int i = 0; i < n; i++) {
        keys[i] = key(random, c % 7 == 6 ? random.nextInt(6) : c % 7);
      }
      // Adding zero makes -0 and 0 the same for the comparator too.
      int[] expected =
          IntStream.range(0, n)
              .boxed()
              .sorted(Comparator.comparingDouble(i -> keys[i] + 0.0))
              .mapToInt(Integer::intValue)
              .toArray();
      assertArrayEquals(expected, Arrays.copyOf(order.ascending(keys, n), n), "case " + c);
    }
  }
}
