package org.jbox2d.benchmarks.engines;

/** How a body moves. */
public enum Kind {
  /** Never. */
  STATIC,
  /** With its velocity, whatever it meets. */
  KINEMATIC,
  /** By forces. */
  DYNAMIC
}
