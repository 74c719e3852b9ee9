package org.jbox2d.dynamics.solver;

import java.util.Arrays;

/**
 * Solves symmetric, positive definite systems that are tridiagonal in blocks of 2 x 2, in a time
 * that grows as they do (Golub and Van Loan, Matrix Computations, 4.5.1):
 *
 * <pre>
 *   A = L D L^T,   L(i) = A(i, i - 1) D(i - 1)^-1,   D(i) = A(i, i) - L(i) A(i, i - 1)^T
 * </pre>
 *
 * Several systems may lie behind each other. Doubles, since the condition grows as the ratio of the
 * masses and the square of the length.
 */
final class BlockTridiagonal {
  /** Of a block row: three of D^-1, four of L, two of the right side or the solution. */
  private static final int STRIDE = 9;

  private static final int D11 = 0;
  private static final int D12 = 1;
  private static final int D22 = 2;
  private static final int L11 = 3;
  private static final int L12 = 4;
  private static final int L21 = 5;
  private static final int L22 = 6;
  private static final int X = 7;
  private static final int Y = 8;

  private double[] a = new double[16 * STRIDE];

  /** Makes room for so many block rows; keeps what is there. */
  void ensureCapacity(int rows) {
    if (rows * STRIDE > a.length) {
      a = Arrays.copyOf(a, 2 * rows * STRIDE);
    }
  }

  /** Factors the first block row of a system: {@code A(i, i) = (k11, k12; k12, k22)}. */
  void factorFirst(int i, double k11, double k12, double k22) {
    writeInverse(i, k11, k12, k22);
  }

  private void writeInverse(int i, double k11, double k12, double k22) {
    double inv = 1 / (k11 * k22 - k12 * k12);
    int at = STRIDE * i;
    a[at + D11] = inv * k22;
    a[at + D12] = -inv * k12;
    a[at + D22] = inv * k11;
  }

  /** Factors a further one, with {@code A(i, i - 1) = (c11, c12; c21, c22)}. */
  void factorNext(
      int i, double k11, double k12, double k22, double c11, double c12, double c21, double c22) {
    int at = STRIDE * i;
    int b = at - STRIDE;
    double l11 = a[at + L11] = c11 * a[b + D11] + c12 * a[b + D12];
    double l12 = a[at + L12] = c11 * a[b + D12] + c12 * a[b + D22];
    double l21 = a[at + L21] = c21 * a[b + D11] + c22 * a[b + D12];
    double l22 = a[at + L22] = c21 * a[b + D12] + c22 * a[b + D22];
    double d11 = k11 - (l11 * c11 + l12 * c12);
    double d12 = k12 - (l11 * c21 + l12 * c22);
    double d22 = k22 - (l21 * c21 + l22 * c22);
    writeInverse(i, d11, d12, d22);
  }

  /** Writes the right side of a block row. */
  void write(int i, double x, double y) {
    a[STRIDE * i + X] = x;
    a[STRIDE * i + Y] = y;
  }

  /** Replaces the right sides of the system {@code [from, to)} by its solution. */
  void solve(int from, int to) {
    for (int at = STRIDE * (from + 1); at < STRIDE * to; at += STRIDE) {
      double x = a[at - STRIDE + X];
      double y = a[at - STRIDE + Y];
      a[at + X] -= a[at + L11] * x + a[at + L12] * y;
      a[at + Y] -= a[at + L21] * x + a[at + L22] * y;
    }
    for (int at = STRIDE * (to - 1); at >= STRIDE * from; at -= STRIDE) {
      double x = a[at + D11] * a[at + X] + a[at + D12] * a[at + Y];
      double y = a[at + D12] * a[at + X] + a[at + D22] * a[at + Y];
      int next = at + STRIDE;
      if (next < STRIDE * to) {
        x -= a[next + L11] * a[next + X] + a[next + L21] * a[next + Y];
        y -= a[next + L12] * a[next + X] + a[next + L22] * a[next + Y];
      }
      a[at + X] = x;
      a[at + Y] = y;
    }
  }

  double x(int i) {
    return a[STRIDE * i + X];
  }

  double y(int i) {
    return a[STRIDE * i + Y];
  }
}
