package org.jbox2d.dynamics.solver;

import org.jbox2d.common.Settings;

/**
 * What one step needs to know: its length, its iterations, and the tuning constants as they stood
 * when it began.
 */
public final class StepConfig {
  /** Step length, s; may be 0. */
  public float dt;

  /** 1 / dt, or 0 if dt is 0. */
  public float invDt;

  /** 1 / length of the whole step, of which this may be a substep; 0 if that is 0. */
  public float invStep;

  /** This step's length over the last one's, by which stored impulses are scaled. */
  public float dtRatio;

  /**
   * When in the step the bodies' velocities hold, as a share of it: 1/2 where all of the step's
   * gain from forces goes into its way, 1 where a body's way is that of its mean velocity.
   */
  public float velocityTime;

  public int velocityIterations;
  public int positionIterations;
  public boolean warmStarting;

  public float gravityX;
  public float gravityY;

  /** Penetration that is left alone, m. */
  public float linearSlop;

  public float angularSlop;

  /**
   * Share of the skins around polygons and edges that overlap at rest, besides the slop. With 1/2
   * and the usual sizes two polygons rest one slop apart, where the continuous phase stops bodies,
   * too; all beyond lets solvers with substeps see a contact before it closes.
   */
  public float skinShare;

  /** Share of a position error that one correction removes. */
  public float baumgarte;

  public float maxLinearCorrection;
  public float maxAngularCorrection;

  /** Approach speed below which a contact does not bounce, m/s. */
  public float velocityThreshold;

  /** Largest way in a step, m, and largest turn, rad. */
  public float maxTranslation;

  public float maxRotation;

  /** Becomes the first of {@code n} substeps of a step: kept impulses are those of a whole step. */
  void divide(StepConfig whole, int n) {
    dt = whole.dt / n;
    invDt = n * whole.invDt;
    invStep = whole.invDt;
    dtRatio = whole.dtRatio / n;
    warmStarting = whole.warmStarting;
    linearSlop = whole.linearSlop;
    angularSlop = whole.angularSlop;
    baumgarte = whole.baumgarte;
    maxLinearCorrection = whole.maxLinearCorrection;
    maxAngularCorrection = whole.maxAngularCorrection;
    velocityThreshold = whole.velocityThreshold;
  }

  /** Becomes the next substep: kept impulses are those of the one before. */
  void next() {
    dtRatio = 1f;
    warmStarting = true;
  }

  /**
   * Reads the tuning constants; they are looked up once a step, so that a change takes effect in
   * the next one.
   */
  public void readSettings() {
    linearSlop = Settings.linearSlop;
    angularSlop = Settings.angularSlop;
    baumgarte = Settings.baumgarte;
    maxLinearCorrection = Settings.maxLinearCorrection;
    maxAngularCorrection = Settings.maxAngularCorrection;
    velocityThreshold = Settings.velocityThreshold;
    maxTranslation = Settings.maxTranslation;
    maxRotation = Settings.maxRotation;
  }
}
