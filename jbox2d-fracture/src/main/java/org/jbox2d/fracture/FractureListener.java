package org.jbox2d.fracture;

import java.util.List;
import org.jbox2d.dynamics.Body;

/** Hears of fractures, after the step in which they happened; the world is not locked then. */
@FunctionalInterface
public interface FractureListener {
  /**
   * A body has broken.
   *
   * @param material material by which it broke; {@code null} for a cut of a body without one
   * @param intensity impulse of the blow, N s; 0 for a cut
   * @param fragments the bodies it broke into: remainders first, then splinters. A remainder may be
   *     the old body itself
   */
  void action(Material material, float intensity, List<Body> fragments);

  /**
   * A body is about to break. May call the fracture off, or change its material.
   *
   * @return whether to go on; if not, the blow stays an ordinary blow
   */
  default boolean allow(FractureProposal proposal) {
    return true;
  }

  /** A body has broken; called after {@link #action}, with more to tell. */
  default void fractured(FractureEvent event) {}

  /** A fracture was called off because something went wrong, and its body stayed whole. */
  default void failed(FractureFailure failure) {}
}
