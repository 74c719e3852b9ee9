package org.jbox2d.fracture.materials;

/** Checks of what materials are given. */
final class Limits {
  private static final float MOST_SLENDER = 100f;

  private Limits() {}

  static float angle(float angle) {
    if (!Float.isFinite(angle)) {
      throw new IllegalArgumentException("angle must be finite, is " + angle);
    }
    return angle;
  }

  static float slenderness(float slenderness) {
    if (!(slenderness >= 1f && slenderness <= MOST_SLENDER)) {
      throw new IllegalArgumentException(
          "slenderness must be 1 to " + MOST_SLENDER + ", is " + slenderness);
    }
    return slenderness;
  }
}
