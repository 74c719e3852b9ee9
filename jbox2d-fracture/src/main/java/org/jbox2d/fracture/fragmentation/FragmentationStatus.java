package org.jbox2d.fracture.fragmentation;

/** How a fragmentation ended. */
public enum FragmentationStatus {
  /** There are fragments. */
  BROKEN,
  /** No piece breaks away: the body stays as it is. */
  NOTHING_BREAKS,
  /** The outline is not a simple polygon with separate holes. */
  INVALID_OUTLINE,
  /** Cuts and outline could not be split at each other. */
  NOT_NODED,
  /** Inside and outside of the outline contradict each other after splitting. */
  NO_CONSISTENT_PIECES,
  /** The areas of fragments and remainders do not add up to that of the outline. */
  AREA_LOST;

  /** Whether this is a failure; the body then stays as it is. */
  public boolean isFailure() {
    return this != BROKEN && this != NOTHING_BREAKS;
  }
}
