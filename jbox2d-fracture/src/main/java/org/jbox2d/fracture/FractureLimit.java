package org.jbox2d.fracture;

/** What kept a body from breaking, or from breaking as finely as its material would have it. */
public enum FractureLimit {
  /** {@link FractureSystem#setPiecesPerFracture}. */
  PIECES_PER_FRACTURE,
  /** {@link FractureSystem#setBodyLimit}. */
  BODIES,
  /** {@link FractureSystem#setFracturesPerStep}. */
  FRACTURES_PER_STEP,
  /** {@link FractureSystem#setMinimumArea}. */
  MINIMUM_AREA,
  /** {@link FractureSystem#setDebrisBudget}. */
  DEBRIS_BUDGET,
  /** {@link FractureSystem#setDebrisLifetime}. */
  DEBRIS_LIFETIME
}
