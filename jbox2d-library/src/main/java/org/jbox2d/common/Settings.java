package org.jbox2d.common;

/**
 * Tuning constants of the engine, in metres, kilograms, seconds and radians.
 *
 * <p>The non-final fields may be assigned before a world is built; the engine reads them at run
 * time, once per step. They are the only mutable statics of the library, because the API it
 * implements has them here; worlds that step on different threads share them, so do not assign them
 * while a world steps.
 */
public class Settings {

  /** Spacing of 1 and the next larger float. */
  public static final float EPSILON = 1.1920928955078125E-7f;

  public static final float PI = 3.1415927f;

  // The FAST_ switches choose between two ways to the same result in JBox2D. Here only FAST_ATAN2
  // has an effect.

  /** Kept for source compatibility, without effect. */
  public static boolean FAST_ABS = true;

  /** Kept for source compatibility, without effect. */
  public static boolean FAST_FLOOR = true;

  /** Kept for source compatibility, without effect. */
  public static boolean FAST_CEIL = true;

  /** Kept for source compatibility, without effect. */
  public static boolean FAST_ROUND = true;

  /** Whether {@link MathUtils#atan2} may be off by 0.005 rad; off by default. */
  public static boolean FAST_ATAN2 = false;

  /** Kept for source compatibility, without effect. */
  public static boolean FAST_POW = true;

  /** Initial capacity of pooled contact stacks, in contacts. */
  public static int CONTACT_STACK_INIT_SIZE = 10;

  /**
   * Whether {@link MathUtils#sin} and {@link MathUtils#cos} read a table; off by default, because
   * it costs accuracy.
   */
  public static boolean SINCOS_LUT_ENABLED = false;

  /** Spacing of the sine table in radians. */
  public static final float SINCOS_LUT_PRECISION = .00011f;

  /** Entries of the sine table. */
  public static final int SINCOS_LUT_LENGTH = lutLength();

  /** Whether the sine table interpolates linearly; otherwise the nearest entry is taken. */
  public static boolean SINCOS_LUT_LERP = true;

  /** Most contact points between two convex shapes. */
  public static int maxManifoldPoints = 2;

  /** Most vertices of a {@code PolygonShape}. */
  public static int maxPolygonVertices = 8;

  /**
   * Greatest margin of the boxes in the broad phase, in metres: a body may move this far before the
   * tree is touched. Small shapes have a smaller margin, by their size.
   */
  public static float aabbExtension = 0.1f;

  /**
   * By how many displacements of a step a box in the broad phase is stretched ahead, up to half its
   * width plus height.
   */
  public static float aabbMultiplier = 2.0f;

  /**
   * Length in metres below which positions count as equal: visible to no one, large against
   * rounding.
   */
  public static float linearSlop = 0.005f;

  /** Angle in radians below which orientations count as equal. */
  public static float angularSlop = 2.0f / 180.0f * PI;

  /** Skin of polygons and edges in metres; it keeps resting shapes in touch between steps. */
  public static float polygonRadius = 2.0f * linearSlop;

  /** Most continuous sub-steps of a contact in a step. */
  public static int maxSubSteps = 8;

  /** Most contacts solved together at a time of impact. */
  public static int maxTOIContacts = 32;

  /** Relative normal speed in m/s below which a collision does not bounce. */
  public static float velocityThreshold = 1.0f;

  /** Largest position correction of an iteration, in metres. */
  public static float maxLinearCorrection = 0.2f;

  /** Largest angle correction of an iteration, in radians. */
  public static float maxAngularCorrection = 8.0f / 180.0f * PI;

  /** Largest translation of a body in a step, in metres. */
  public static float maxTranslation = 2.0f;

  /** {@link #maxTranslation} squared; assign both. */
  public static float maxTranslationSquared = maxTranslation * maxTranslation;

  /** Largest rotation of a body in a step, in radians. */
  public static float maxRotation = 0.5f * PI;

  /** {@link #maxRotation} squared; assign both. */
  public static float maxRotationSquared = maxRotation * maxRotation;

  /** Share of an overlap that a step's position correction removes. */
  public static float baumgarte = 0.2f;

  /** Share of an overlap that a continuous sub-step removes (the spelling is JBox2D's). */
  public static float toiBaugarte = 0.75f;

  /** Time in seconds for which a body has to be still before it sleeps. */
  public static float timeToSleep = 0.5f;

  /** Speed in m/s above which a body does not fall asleep. */
  public static float linearSleepTolerance = 0.01f;

  /** Angular speed in rad/s above which a body does not fall asleep. */
  public static float angularSleepTolerance = 2.0f / 180.0f * PI;

  /** Marks the absence of a particle. */
  public static final int invalidParticleIndex = -1;

  /** Spacing of particles in a group, in particle diameters. */
  public static final float particleStride = 0.75f;

  /** Least weight of a particle that pressure acts on. */
  public static final float minParticleWeight = 1.0f;

  /** Weight at which pressure is cut off. */
  public static final float maxParticleWeight = 5.0f;

  /** Longest edge of an elastic triad, in particle diameters. */
  public static final int maxTriadDistance = 2;

  /** {@link #maxTriadDistance} squared. */
  public static final int maxTriadDistanceSquared = maxTriadDistance * maxTriadDistance;

  /** Initial capacity of particle buffers, in particles. */
  public static final int minParticleBufferCapacity = 256;

  public Settings() {}

  /**
   * Friction of two fixtures in touch: the geometric mean, so that one frictionless fixture slides
   * on anything.
   */
  public static float mixFriction(float friction1, float friction2) {
    return (float) Math.sqrt((double) friction1 * friction2);
  }

  /** Restitution of two fixtures in touch: the larger one, so that a ball bounces off anything. */
  public static float mixRestitution(float restitution1, float restitution2) {
    return restitution1 > restitution2 ? restitution1 : restitution2;
  }

  private static int lutLength() {
    return (int) Math.ceil(2.0 * Math.PI / SINCOS_LUT_PRECISION);
  }
}
