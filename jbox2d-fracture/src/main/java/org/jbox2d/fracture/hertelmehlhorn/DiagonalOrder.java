package org.jbox2d.fracture.hertelmehlhorn;

/**
 * Order in which Hertel and Mehlhorn's algorithm looks at the diagonals of a triangulation. Which
 * of them remain depends on it. Of orders that give equally few parts the first here is preferred.
 */
public enum DiagonalOrder {
  /** Shortest first. */
  SHORTEST_FIRST,
  /** As the triangulation gave them. */
  AS_FOUND,
  /** Longest first. */
  LONGEST_FIRST
}
