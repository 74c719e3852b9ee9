package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

/** Asserts that a definition is refused, says why, and leaves the world as it was. */
final class BadInput {
  private BadInput() {}

  static void rejected(JointScene scene, JointDef def, String name) {
    int before = scene.world.getJointCount();
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> scene.world.createJoint(def));
    assertTrue(e.getMessage().contains(name), e.getMessage());
    assertEquals(before, scene.world.getJointCount());
  }
}
