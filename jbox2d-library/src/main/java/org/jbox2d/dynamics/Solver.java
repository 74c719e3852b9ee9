package org.jbox2d.dynamics;

/**
 * How a world solves its contacts and joints; see {@link World#setSolver}. An instance is a choice
 * with its settings, and never changes.
 *
 * <ul>
 *   <li>{@link #sequentialImpulses()}: JBox2D's way, and the default: velocity and position
 *       iterations over the whole step.
 *   <li>{@link #softStep(int)}: substeps with soft contacts.
 *   <li>{@link #adaptive(int, int)}: the soft step, each island with as many substeps as it needs.
 * </ul>
 */
public final class Solver {
  /** Substeps of {@link #softStep()}. */
  public static final int DEFAULT_SUBSTEPS = 4;

  /** Least and most substeps of {@link #adaptive()}. */
  private static final int ADAPTIVE_LEAST = 2;

  private static final int ADAPTIVE_MOST = 32;

  private static final Solver SEQUENTIAL_IMPULSES = new Solver(0, 0);
  private static final Solver SOFT_STEP = new Solver(DEFAULT_SUBSTEPS, DEFAULT_SUBSTEPS);
  private static final Solver ADAPTIVE = new Solver(ADAPTIVE_LEAST, ADAPTIVE_MOST);

  private final int leastSubsteps;
  private final int mostSubsteps;

  private Solver(int leastSubsteps, int mostSubsteps) {
    this.leastSubsteps = leastSubsteps;
    this.mostSubsteps = mostSubsteps;
  }

  /** Sequential impulses, with the iterations that are given to {@link World#step}. */
  public static Solver sequentialImpulses() {
    return SEQUENTIAL_IMPULSES;
  }

  /** The soft step with {@link #DEFAULT_SUBSTEPS} substeps. */
  public static Solver softStep() {
    return SOFT_STEP;
  }

  /**
   * The soft step. The iterations that are given to {@link World#step} are of no meaning to it.
   *
   * @param substeps 1 or more
   * @throws IllegalArgumentException if there are less
   */
  public static Solver softStep(int substeps) {
    if (substeps < 1) {
      throw new IllegalArgumentException("substeps must be 1 or more, are " + substeps);
    }
    return new Solver(substeps, substeps);
  }

  /** The adaptive solver with its usual limits. */
  public static Solver adaptive() {
    return ADAPTIVE;
  }

  /**
   * The adaptive solver.
   *
   * @param leastSubsteps for an island that is calm and light, 1 or more
   * @param mostSubsteps for one that is as hard as can be, more than the least
   * @throws IllegalArgumentException if they are not
   */
  public static Solver adaptive(int leastSubsteps, int mostSubsteps) {
    if (leastSubsteps < 1 || mostSubsteps <= leastSubsteps) {
      throw new IllegalArgumentException(
          "substeps must be 1 or more and rising, are " + leastSubsteps + ", " + mostSubsteps);
    }
    return new Solver(leastSubsteps, mostSubsteps);
  }

  /** Whether this is {@link #sequentialImpulses()}. */
  public boolean isSequentialImpulses() {
    return mostSubsteps == 0;
  }

  /** Whether this is an {@link #adaptive()} solver. */
  public boolean isAdaptive() {
    return leastSubsteps < mostSubsteps;
  }

  /** Returns the least number of substeps; 0 for sequential impulses. */
  public int getLeastSubsteps() {
    return leastSubsteps;
  }

  /** Returns the greatest number of substeps; 0 for sequential impulses. */
  public int getMostSubsteps() {
    return mostSubsteps;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Solver
        && ((Solver) other).leastSubsteps == leastSubsteps
        && ((Solver) other).mostSubsteps == mostSubsteps;
  }

  @Override
  public int hashCode() {
    return 31 * leastSubsteps + mostSubsteps;
  }

  @Override
  public String toString() {
    if (isSequentialImpulses()) {
      return "sequential impulses";
    }
    return isAdaptive()
        ? "adaptive, " + leastSubsteps + " to " + mostSubsteps + " substeps"
        : "soft step, " + leastSubsteps + " substeps";
  }
}
