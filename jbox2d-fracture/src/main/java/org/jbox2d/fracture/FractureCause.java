package org.jbox2d.fracture;

/** What made a body break. */
public enum FractureCause {
  /** A blow in a collision. */
  COLLISION,
  /** {@link FractureSystem#strike}. */
  STRIKE,
  /** {@link FractureSystem#explode}. */
  EXPLOSION,
  /** {@link FractureSystem#cut}. */
  CUT
}
