package org.jbox2d.fracture;

/**
 * A small random generator for sites: SplitMix64 (Steele, Lea and Flood, "Fast splittable
 * pseudorandom number generators", OOPSLA 2014). The same seed gives the same numbers everywhere.
 */
public final class SiteRandom {
  private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

  /** 2^-24: the spacing of the floats that are returned. */
  private static final float UNIT = 0x1p-24f;

  private long state;

  /** A generator that starts from the given seed. */
  public SiteRandom(long seed) {
    state = seed;
  }

  /** Returns a seed that depends on all bits of the two values. */
  public static long mix(long a, long b) {
    return finish(finish(a + GOLDEN_GAMMA) ^ (b + GOLDEN_GAMMA));
  }

  private static long finish(long z) {
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** Returns the next 64 random bits. */
  public long nextLong() {
    state += GOLDEN_GAMMA;
    return finish(state);
  }

  /** Returns a number that is uniform in [0, 1). */
  public float unit() {
    return (nextLong() >>> 40) * UNIT;
  }

  /** Returns a number that is uniform in (0, 1]; its logarithm is finite. */
  public float positiveUnit() {
    return ((nextLong() >>> 40) + 1) * UNIT;
  }

  /** Returns a number that is uniform in [-1/2, 1/2), the thesis' p(). */
  public float centred() {
    return unit() - 0.5f;
  }
}
