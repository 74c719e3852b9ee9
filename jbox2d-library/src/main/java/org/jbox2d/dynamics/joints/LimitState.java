package org.jbox2d.dynamics.joints;

/** Where a joint stands between its limits. */
public enum LimitState {
  INACTIVE,
  AT_LOWER,
  AT_UPPER,
  EQUAL
}
