package org.jbox2d.dynamics.solver;

/**
 * What the rows of {@link PrismaticKernel} and {@link WheelKernel} have in common: a block of six
 * floats, the axis a (x, y), {@code s1, s2} and {@code a1, a2}, as of when the row was prepared.
 * With substeps bodies have moved since then, so that the gap d is taken from there and not from
 * their places.
 */
final class Rail {
  private static final int AX = 0;
  private static final int AY = 1;
  private static final int S1 = 2;
  private static final int A1 = 4;

  private Rail() {}

  /**
   * Returns {@code a . d = s1 - rA . a}, m.
   *
   * @param o place of the row, which begins with the {@link Arms}
   * @param at place of the block
   */
  static float gapAlong(float[] f, int o, int at) {
    return f[at + S1] - f[o + Arms.RAX] * f[at + AX] - f[o + Arms.RAY] * f[at + AY];
  }

  /** Returns {@code n . d = -a1 - rA . n}, {@code n = (-ay, ax)}, m; see {@link #gapAlong}. */
  static float gapAcross(float[] f, int o, int at) {
    return f[o + Arms.RAX] * f[at + AY] - f[o + Arms.RAY] * f[at + AX] - f[at + A1];
  }

  /** Returns {@link Arms#bendAlong} of the normal n. */
  static float bendAcross(float[] f, int o, int at, float[] v, int a, int b, StepConfig step) {
    float along = gapAlong(f, o, at);
    float across = gapAcross(f, o, at);
    return Arms.bendAlong(f, o, v, a, b, -f[at + AY], f[at + AX], across, -along, step);
  }

  /** Returns {@link Arms#bendAlong} of the axis. */
  static float bendAlong(float[] f, int o, int at, float[] v, int a, int b, StepConfig step) {
    float along = gapAlong(f, o, at);
    float across = gapAcross(f, o, at);
    return Arms.bendAlong(f, o, v, a, b, f[at + AX], f[at + AY], along, across, step);
  }
}
