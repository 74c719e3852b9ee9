package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;

/**
 * Checks of what enters a joint. Each failure is an IllegalArgumentException that names the value.
 */
final class JointChecks {
  private JointChecks() {}

  static void finite(float value, String name) {
    if (!Float.isFinite(value)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void finite(Vec2 value, String name) {
    if (value == null) {
      throw new IllegalArgumentException(name + " is null");
    }
    if (!Float.isFinite(value.x) || !Float.isFinite(value.y)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void notNegative(float value, String name) {
    if (!(value >= 0f) || Float.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be finite and not negative, is " + value);
    }
  }
}
