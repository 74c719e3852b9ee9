package org.jbox2d.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SolverBodiesTest {
  /**
   * Symptom: a sliver of a centimetre, squeezed between larger bodies, got the angle NaN in the
   * first steps after a fracture. Cause: the position correction turned it by several radians at
   * once, for which the step back to unit length diverges, the more the more often it is done.
   */
  @ParameterizedTest
  @ValueSource(floats = {1e-4f, 0.01f, 0.1f, 0.14f, 0.2f, 1f, -2f, 5f, -30f})
  void rotationStaysOfUnitLengthHoweverFarABodyIsTurned(float turn) {
    SolverBodies bodies = new SolverBodies();
    bodies.ensureCapacity(1);
    bodies.setAngle(0, 0.3f);
    for (int i = 0; i < 20; i++) {
      bodies.turn(0, turn);
    }
    double angle = bodies.angle[0];
    // Twenty times the cube of the largest turn without trigonometry, a third of it each.
    double tolerance = 0.02;
    assertEquals(Math.sin(angle), bodies.pos[2], tolerance);
    assertEquals(Math.cos(angle), bodies.pos[3], tolerance);
    assertEquals(1, Math.hypot(bodies.pos[2], bodies.pos[3]), 1e-3);
  }
}
