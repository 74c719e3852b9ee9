package org.jbox2d.dynamics;

import org.jbox2d.dynamics.solver.Effort;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * How many substeps the adaptive solver gives an island: as many as it needs now, and for a while
 * after as many as it has needed. Bodies keep these figures from step to step, as islands do not
 * last.
 *
 * <p>Velocities belong to the middle of a substep, so each change of its length costs some energy,
 * and one with the phase of a swing would go on taking or giving it: what swings freely keeps its
 * substeps for long. What touches something loses more than that anyway.
 */
final class IslandEffort {
  /**
   * For how many steps an island of joints alone keeps its substeps when it needs fewer; then they
   * fall each {@link #PILE_HELD} steps.
   */
  private static final int SWING_HELD = 240;

  /**
   * For how many steps an island with contacts does: a pile settles by some tenths of a millimetre,
   * and limbs turn fast for no longer than a blow lasts.
   */
  private static final int PILE_HELD = 30;

  /**
   * The same for what speed asked for: turned by a blow, limbs are slow again when it is over.
   * Dolls that fall down steps took half as many substeps again for half a second.
   */
  private static final int BLOW_HELD = 4;

  /** Share to which substeps then fall, if not by one. */
  private static final float FALL = 0.7f;

  /** By what factor contacts can raise the substeps from step to step, see {@link #needed}. */
  private static final int CONTACT_RISE = 2;

  /**
   * Up to how many substeps an island gets one more after each step that its joints ended out of
   * tolerance.
   */
  private static final int RESIDUAL_SUBSTEPS = 4;

  /**
   * For how many links in a row that bound is one higher. What a step leaves in a hanging row is
   * {@code 1.8 N g h^2 / n^2} at its upper end, N the links and n the substeps: measured on chains
   * of 30 to 300, with 4 to 32 substeps. A swing bears three times its weight and cracks like a
   * whip; with four substeps 200 links stretch by more than half.
   */
  private static final int LINKS_A_SUBSTEP = 32;

  /** Contacts and joints of an island times its substeps, above the usual number of those. */
  private static final int MOST_EFFORT = 1024;

  /** The same for links in a row, which need the more substeps the more they are. */
  private static final int MOST_ROW_EFFORT = 4096;

  private final AwakeSet awake;
  private final Islands islands;
  private final Effort effort;

  /**
   * Substeps of the island, for how many steps it has needed less, whether a blow asked for them.
   */
  private int held;

  private int age;
  private boolean fast;

  IslandEffort(AwakeSet awake, Islands islands, Effort effort) {
    this.awake = awake;
    this.islands = islands;
    this.effort = effort;
  }

  /** Returns and notes the substeps of an island in this step. */
  int substeps(int island, StepConfig step, Solver solver) {
    recall(island);
    int least = solver.getLeastSubsteps();
    int most = most(island, solver);
    float needed = needed(island, step, Math.max(held, least), most);
    float now = Math.min(most, Math.max(least, needed));
    boolean touches = islands.hasContacts(island);
    boolean rises = now > held || held > most;
    boolean lasts = now >= FALL * held;
    if (rises || lasts) {
      // What swings freely is fast for long; it is a blow that makes it fast for a while.
      fast = needed > least && effort.fast >= needed && (touches || fast);
    }
    int lasting = islands.hasJoints(island) ? SWING_HELD : PILE_HELD;
    int pause = fast ? BLOW_HELD : PILE_HELD;
    int young = touches || fast ? lasting - pause : 0;
    if (rises) {
      held = (int) Math.ceil(now);
      age = young;
    } else if (lasts) {
      age = young;
    } else if (++age > lasting) {
      held = (int) Math.ceil(Math.max(now, Math.min(FALL * held, held - 1f)));
      age = lasting - pause;
    }
    note(island, held, age, fast);
    return held;
  }

  /**
   * Reads what the bodies of an island have kept: most substeps, and of those whether for speed.
   */
  private void recall(int island) {
    held = 0;
    age = Integer.MAX_VALUE;
    fast = true;
    for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
      Body b = awake.bodies[islands.bodies[i]];
      if (b.effort >= held) {
        fast = b.effortOfSpeed && (fast || b.effort > held);
        held = b.effort;
      }
      age = Math.min(age, b.effortAge);
    }
  }

  /**
   * Returns what an island needs now. What contacts ask for goes by the impulses of the last step,
   * in which a load is as it will be in the next, while a blow is over. So it rises by steps: a
   * load lasts. A column buckles slowly, so for that one more a step will do; pieces that fall on
   * each other look like one for a step or two.
   */
  private float needed(int island, StepConfig step, int held, int most) {
    int c0 = islands.contactStart[island];
    int c1 = islands.contactStart[island + 1];
    int b0 = islands.bodyStart[island];
    int b1 = islands.bodyStart[island + 1];
    float loaded = effort.ofContacts(c0, c1, b1 - b0, step);
    effort.fast = Math.min(effort.fast, CONTACT_RISE * held);
    float needed = Math.min(loaded, CONTACT_RISE * held);
    needed = Math.max(needed, Math.min(effort.tall, held + 1));
    if (islands.hasJoints(island)) {
      int j0 = islands.jointStart[island];
      int j1 = islands.jointStart[island + 1];
      float ofJoints = effort.ofJoints(j0, j1, islands.bodies, b0, b1, c0 < c1, most, step);
      needed = Math.max(needed, ofJoints);
    }
    return Math.max(needed, effort.fast);
  }

  /** Notes that the joints of an island ended a step of so many substeps out of tolerance. */
  void noteStretched(int island, int substeps, Solver solver) {
    int links = islands.jointStart[island + 1] - islands.jointStart[island];
    int bound = RESIDUAL_SUBSTEPS + (isRow(island) ? links / LINKS_A_SUBSTEP : 0);
    if (substeps < bound) {
      note(island, Math.min(substeps + 1, most(island, solver)), 0, false);
    }
  }

  /**
   * The bound of the substeps of an island: that of the solver, and for a large one what keeps its
   * cost in bounds. In a pile of thousands it is no matter if some small body gives way to its
   * load.
   */
  private int most(int island, Solver solver) {
    int rows =
        islands.contactStart[island + 1]
            - islands.contactStart[island]
            + islands.jointStart[island + 1]
            - islands.jointStart[island];
    int bound = isRow(island) ? MOST_ROW_EFFORT : MOST_EFFORT;
    int affordable = Math.max(Solver.DEFAULT_SUBSTEPS, bound / rows);
    return Math.max(solver.getLeastSubsteps(), Math.min(solver.getMostSubsteps(), affordable));
  }

  /**
   * Whether an island touches nothing and has hardly more joints than bodies: a chain, a bridge, a
   * tree. In a net the ways are short; and against contacts joints may be out of tolerance however
   * many substeps there are.
   */
  private boolean isRow(int island) {
    int joints = islands.jointStart[island + 1] - islands.jointStart[island];
    int bodies = islands.bodyStart[island + 1] - islands.bodyStart[island];
    return !islands.hasContacts(island) && joints <= bodies + 1;
  }

  /**
   * Notes how many substeps an island has, for how long it has needed less, and whether it was for
   * its speed that it has got them.
   */
  private void note(int island, int substeps, int age, boolean fast) {
    for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
      Body b = awake.bodies[islands.bodies[i]];
      b.effort = substeps;
      b.effortAge = age;
      b.effortOfSpeed = fast;
    }
  }
}
