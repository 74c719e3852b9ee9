package org.jbox2d.fracture.triangulation;

import org.jbox2d.fracture.geometry.Outline;

/**
 * Cuts an outline into triangles. Implementations own workspaces and reuse them; use one per
 * thread.
 */
public interface Triangulator {
  /**
   * Triangulates an outline without adding vertices.
   *
   * @param outline a simple, normal outline, holes allowed; rings may touch in common vertices
   * @param mesh takes the triangles; its old content is lost
   * @return whether it succeeded; if not, the mesh is undefined
   */
  boolean triangulate(Outline outline, TriangleMesh mesh);

  /**
   * Whether {@link #triangulate} also takes any outline and fails if and only if edges meet others
   * than their neighbours, or the outline is not normal: then no one needs to look for crossings
   * before.
   */
  default boolean refusesCrossings() {
    return false;
  }
}
