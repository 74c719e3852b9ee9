package org.jbox2d.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** The solution, put into the system, gives the right side. */
class BlockTridiagonalTest {
  private static final int CASES = 200;

  @Test
  void solvesSystemsBehindEachOther() {
    BlockTridiagonal system = new BlockTridiagonal();
    Random random = new Random(1);
    for (int k = 0; k < CASES; k++) {
      int first = 1 + random.nextInt(20);
      int second = 1 + random.nextInt(20);
      double[][] a = matrix(first, random);
      double[][] b = matrix(second, random);
      double[] rightA = right(first, random);
      double[] rightB = right(second, random);
      system.ensureCapacity(first + second);
      write(system, 0, a, rightA);
      write(system, first, b, rightB);
      system.solve(0, first);
      system.solve(first, first + second);
      check(system, 0, a, rightA);
      check(system, first, b, rightB);
    }
  }

  /** {@code J M^-1 J^T} of a row of points with random masses between them, as in a chain. */
  private static double[][] matrix(int n, Random random) {
    double[][] j = new double[2 * n][3 * n + 3];
    double[] inverse = new double[3 * n + 3];
    for (int body = 0; body <= n; body++) {
      inverse[3 * body] = Math.pow(10, 4 * random.nextDouble() - 2);
      inverse[3 * body + 1] = inverse[3 * body];
      inverse[3 * body + 2] = inverse[3 * body] * Math.pow(10, random.nextDouble());
    }
    for (int i = 0; i < n; i++) {
      for (int side = 0; side < 2; side++) {
        int at = 3 * (i + side);
        double sign = side == 0 ? -1 : 1;
        j[2 * i][at] = sign;
        j[2 * i + 1][at + 1] = sign;
        j[2 * i][at + 2] = -sign * (2 * random.nextDouble() - 1);
        j[2 * i + 1][at + 2] = sign * (2 * random.nextDouble() - 1);
      }
    }
    double[][] a = new double[2 * n][2 * n];
    for (int r = 0; r < 2 * n; r++) {
      for (int c = 0; c < 2 * n; c++) {
        for (int k = 0; k < inverse.length; k++) {
          a[r][c] += j[r][k] * inverse[k] * j[c][k];
        }
      }
    }
    return a;
  }

  private static double[] right(int n, Random random) {
    return random.doubles(2L * n, -1, 1).toArray();
  }

  private static void write(BlockTridiagonal system, int at, double[][] a, double[] right) {
    for (int i = 0; i < right.length / 2; i++) {
      int r = 2 * i;
      double k11 = a[r][r];
      double k12 = a[r][r + 1];
      double k22 = a[r + 1][r + 1];
      if (i == 0) {
        system.factorFirst(at, k11, k12, k22);
      } else {
        system.factorNext(
            at + i, k11, k12, k22, a[r][r - 2], a[r][r - 1], a[r + 1][r - 2], a[r + 1][r - 1]);
      }
      system.write(at + i, right[r], right[r + 1]);
    }
  }

  private static void check(BlockTridiagonal system, int at, double[][] a, double[] right) {
    for (int r = 0; r < right.length; r++) {
      double sum = 0;
      double size = 1;
      for (int c = 0; c < right.length; c++) {
        double x = c % 2 == 0 ? system.x(at + c / 2) : system.y(at + c / 2);
        sum += a[r][c] * x;
        size = Math.max(size, Math.abs(a[r][c] * x));
      }
      assertEquals(right[r], sum, 1e-10 * size);
    }
  }
}
