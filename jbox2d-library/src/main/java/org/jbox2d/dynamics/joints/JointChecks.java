package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * Checks of what enters a joint. Each failure is an IllegalArgumentException that names the value.
 */
final class JointChecks {
  private JointChecks() {}

  static void notNull(Object value, String name) {
    if (value == null) {
      throw new IllegalArgumentException(name + " is null");
    }
  }

  static void finite(float value, String name) {
    if (!Float.isFinite(value)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void finite(Vec2 value, String name) {
    notNull(value, name);
    if (!Float.isFinite(value.x) || !Float.isFinite(value.y)) {
      throw new IllegalArgumentException(name + " must be finite, is " + value);
    }
  }

  static void notNegative(float value, String name) {
    if (!(value >= 0f) || Float.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be finite and not negative, is " + value);
    }
  }

  static void positive(float value, String name) {
    if (!(value > 0f) || Float.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be finite and positive, is " + value);
    }
  }

  static void notZero(float value, String name) {
    finite(value, name);
    if (value == 0f) {
      throw new IllegalArgumentException(name + " must not be 0");
    }
  }

  /** A share lies in [0, 1]. */
  static void share(float value, String name) {
    if (!(value >= 0f && value <= 1f)) {
      throw new IllegalArgumentException(name + " must be in [0, 1], is " + value);
    }
  }

  /** Limits are finite and in order; equal ones are allowed. */
  static void limits(float lower, float upper, String lowerName, String upperName) {
    finite(lower, lowerName);
    finite(upper, upperName);
    if (lower > upper) {
      throw new IllegalArgumentException(
          lowerName + " must not be above " + upperName + ", are " + lower + ", " + upper);
    }
  }

  /** A joint needs two bodies. */
  static void differentBodies(JointDef def) {
    notNull(def.bodyA, "JointDef.bodyA");
    notNull(def.bodyB, "JointDef.bodyB");
    if (def.bodyA == def.bodyB) {
      throw new IllegalArgumentException("JointDef.bodyA and JointDef.bodyB are the same body");
    }
  }

  /** Returns the unit vector along an axis, which must have a direction. */
  static Vec2 unit(Vec2 axis, String name) {
    finite(axis, name);
    double length = Math.sqrt((double) axis.x * axis.x + (double) axis.y * axis.y);
    if (!(length > Settings.EPSILON)) {
      throw new IllegalArgumentException(name + " must not be zero, is " + axis);
    }
    return new Vec2((float) (axis.x / length), (float) (axis.y / length));
  }
}
