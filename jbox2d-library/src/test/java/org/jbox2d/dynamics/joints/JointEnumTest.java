package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.jbox2d.dynamics.BodyType;
import org.junit.jupiter.api.Test;

/** Programs switch on ordinals: the order is that of JBox2D 2.2.1.1, with MOTOR of 2.3 behind. */
class JointEnumTest {
  @Test
  void theOrderIsPartOfTheApi() {
    assertEquals(
        "[UNKNOWN, REVOLUTE, PRISMATIC, DISTANCE, PULLEY, MOUSE, GEAR, WHEEL, WELD, FRICTION, ROPE,"
            + " CONSTANT_VOLUME, MOTOR]",
        Arrays.toString(JointType.values()));
    assertEquals("[INACTIVE, AT_LOWER, AT_UPPER, EQUAL]", Arrays.toString(LimitState.values()));
    assertEquals("[STATIC, KINEMATIC, DYNAMIC]", Arrays.toString(BodyType.values()));
  }
}
