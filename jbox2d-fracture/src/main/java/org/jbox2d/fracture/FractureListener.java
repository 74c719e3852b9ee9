package org.jbox2d.fracture;

import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;

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

  /** A limit kept a body from breaking; its blow stays an ordinary blow. */
  default void limited(FractureProposal proposal, FractureLimit limit) {}

  /**
   * A blow too weak to break a fixture has damaged it.
   *
   * @param fixture what was struck; of a compound, the part
   * @param intensity impulse of the blow, N s
   * @param damage of this blow and those before, N s; what is left of the rigidity is less by this
   */
  default void damaged(Fixture fixture, float intensity, float damage) {}

  /**
   * A piece of a broken body is about to be destroyed because of a limit.
   *
   * @return whether it may go; if not, it is no longer counted as debris
   */
  default boolean discard(Body debris, FractureLimit limit) {
    return true;
  }

  /** A fracture was called off because something went wrong, and its body stayed whole. */
  default void failed(FractureFailure failure) {}
}
