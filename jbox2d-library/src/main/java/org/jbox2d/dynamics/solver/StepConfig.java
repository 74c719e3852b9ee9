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

  /** This step's length over the last one's, by which stored impulses are scaled. */
  public float dtRatio;

  public int velocityIterations;
  public int positionIterations;
  public boolean warmStarting;

  public float gravityX;
  public float gravityY;

  /** Penetration that is left alone, m. */
  public float linearSlop;

  public float angularSlop;

  /** Share of a position error that one correction removes. */
  public float baumgarte;

  public float maxLinearCorrection;
  public float maxAngularCorrection;

  /** Approach speed below which a contact does not bounce, m/s. */
  public float velocityThreshold;

  /** Largest way in a step, m, and largest turn, rad. */
  public float maxTranslation;

  public float maxRotation;

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
