package org.jbox2d.fracture;

import java.util.List;
import org.jbox2d.dynamics.Body;

/** Hears of fractures, after the step in which they happened; the world is not locked then. */
@FunctionalInterface
public interface FractureListener {
  /**
   * A body has broken.
   *
   * @param material material of the fixture that broke
   * @param intensity impulse of the blow, N s
   * @param fragments the bodies it broke into: remainders first, then splinters. A remainder may be
   *     the old body itself
   */
  void action(Material material, float intensity, List<Body> fragments);

  /** A fracture was called off and its body stayed whole. */
  default void failed(FractureFailure failure) {}
}
