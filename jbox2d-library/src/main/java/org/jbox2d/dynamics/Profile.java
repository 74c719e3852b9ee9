package org.jbox2d.dynamics;

import java.util.List;

/**
 * How long the phases of the last steps took, in milliseconds, and what they ran into. Programs
 * compiled against 2.2.1.1 find the plain numbers of the last step in the superclass.
 */
public class Profile extends ProfileTimes {
  private static final float NANOS_PER_MILLI = 1e6f;

  /** The whole step. */
  public final ProfileEntry step = new ProfileEntry();

  /** Taking in new fixtures and pairs. */
  public final ProfileEntry stepInit = new ProfileEntry();

  /** Narrow phase and contact events. */
  public final ProfileEntry collide = new ProfileEntry();

  /** Particles. */
  public final ProfileEntry solveParticleSystem = new ProfileEntry();

  /** Everything that solves. */
  public final ProfileEntry solve = new ProfileEntry();

  /** Building islands and constraints. */
  public final ProfileEntry solveInit = new ProfileEntry();

  /** Velocity iterations. */
  public final ProfileEntry solveVelocity = new ProfileEntry();

  /** Position iterations. */
  public final ProfileEntry solvePosition = new ProfileEntry();

  /** Broad phase. */
  public final ProfileEntry broadphase = new ProfileEntry();

  /** Continuous collision. */
  public final ProfileEntry solveTOI = new ProfileEntry();

  /**
   * How many velocities of the last step reached {@link org.jbox2d.common.Settings#maxTranslation}
   * or {@link org.jbox2d.common.Settings#maxRotation} and were scaled down.
   */
  public int cappedVelocities;

  /** How many impacts the continuous phase of the last step handled. */
  public int impacts;

  /** Whether somebody has asked for times. */
  private boolean wanted;

  /** Nothing measured yet. */
  public Profile() {}

  /** Appends a line for each entry. */
  public void toDebugStrings(List<String> strings) {
    strings.add("Profile:");
    strings.add(" step: " + step);
    strings.add("  init: " + stepInit);
    strings.add("  collide: " + collide);
    strings.add("  particles: " + solveParticleSystem);
    strings.add("  solve: " + solve);
    strings.add("   solveInit: " + solveInit);
    strings.add("   solveVelocity: " + solveVelocity);
    strings.add("   solvePosition: " + solvePosition);
    strings.add("   broadphase: " + broadphase);
    strings.add("  solveTOI: " + solveTOI);
  }

  /** Measures times from the next step on. */
  void measure() {
    wanted = true;
  }

  private ProfileEntry[] all() {
    return new ProfileEntry[] {
      step,
      stepInit,
      collide,
      solveParticleSystem,
      solve,
      solveInit,
      solveVelocity,
      solvePosition,
      broadphase,
      solveTOI
    };
  }

  /** Starts a step: entries that are summed up over it begin at 0. */
  void begin() {
    cappedVelocities = 0;
    impacts = 0;
    if (wanted && !step.measures) {
      for (ProfileEntry entry : all()) {
        entry.measures = true;
      }
    }
    step.start();
  }

  /** Ends a step, and fills in the plain numbers. */
  void end() {
    if (!step.measures) {
      return;
    }
    step.stop();
    super.step = step.last;
    super.collide = collide.last;
    super.solve = solve.last;
    super.solveInit = solveInit.last;
    super.solveVelocity = solveVelocity.last;
    super.solvePosition = solvePosition.last;
    super.broadphase = broadphase.last;
    super.solveTOI = solveTOI.last;
  }

  /** One measured phase. */
  public static class ProfileEntry {
    /** Weight of the newest value in the moving average: about the last 20 steps. */
    private static final float NEWEST = 0.05f;

    private float last;
    private float average;
    private float least = Float.MAX_VALUE;
    private float most;
    private float sum;
    private long started;

    /** Whether the clock is read; values can be recorded at any time. */
    private boolean measures;

    /** Nothing measured yet. */
    public ProfileEntry() {}

    /** Takes a value, ms. */
    public void record(float value) {
      last = value;
      average =
          most == 0f && least == Float.MAX_VALUE ? value : average + NEWEST * (value - average);
      least = Math.min(least, value);
      most = Math.max(most, value);
    }

    /** Begins a sum. */
    public void startAccum() {
      sum = 0f;
      start();
    }

    /** Adds to the sum, ms. */
    public void accum(float value) {
      sum += value;
    }

    /** Takes the sum as a value. */
    public void endAccum() {
      record(sum);
    }

    /** Returns the last value, ms. */
    public float getLast() {
      return last;
    }

    /** Returns the moving average, ms. */
    public float getAverage() {
      return average;
    }

    void start() {
      if (measures) {
        started = System.nanoTime();
      }
    }

    void stop() {
      if (measures) {
        record((System.nanoTime() - started) / NANOS_PER_MILLI);
      }
    }

    void accumElapsed() {
      if (measures) {
        accum((System.nanoTime() - started) / NANOS_PER_MILLI);
        endAccum();
      }
    }

    @Override
    public String toString() {
      return last + " ms, average " + average + ", least " + least + ", most " + most;
    }
  }
}
