package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

/** What each fracture of a world keeps. */
final class Conservation {
  /** Of masses and momenta: what float coordinates leave after some tens of pieces are summed. */
  private static final double TOLERANCE = 1e-5;

  private Conservation() {}

  /**
   * Each fracture keeps mass, momentum and angular momentum, and leaves no more kinetic energy than
   * there was before the collision. What is compared is the world just before the fractures of a
   * step, and just after: the step's own position correction, which has other laws, lies before.
   */
  static void assertConserves(World world, float hz, float seconds) {
    assertConserves(world, hz, seconds, "");
  }

  /** As the other, with a word on the world for messages. */
  static void assertConserves(World world, float hz, float seconds, String what) {
    FractureSystem system = FractureSystem.of(world);
    Totals[] unbroken = new Totals[1];
    BeforeFracture.listen(world, () -> unbroken[0] = Totals.of(world));
    Totals start = Totals.of(world);
    boolean isolated = world.getGravity().length() == 0f && allMove(world);
    for (int i = 0; i < Math.round(hz * seconds); i++) {
      unbroken[0] = null;
      int fractures = system.getFractureCount();
      double before = Totals.of(world).kinetic + gravityWork(world, 1f / hz);
      world.step(1f / hz, 8, 3);
      if (system.getFractureCount() > fractures) {
        String at = what + "step " + i + ", fracture " + system.getFractureCount();
        assertKept(unbroken[0], Totals.of(world), before, isolated, at);
      }
    }
    Totals end = Totals.of(world);
    assertEquals(start.material, end.material, 1e-4 * start.material);
    assertEquals(0, system.getFailureCount());
  }

  private static void assertKept(
      Totals t0, Totals t, double kineticBefore, boolean isolated, String at) {
    assertEquals(t0.material, t.material, TOLERANCE * t0.material, at);
    if (isolated) {
      assertEquals(t0.px, t.px, TOLERANCE * t0.momentumScale, at);
      assertEquals(t0.py, t.py, TOLERANCE * t0.momentumScale, at);
      assertEquals(t0.spin, t.spin, TOLERANCE * t0.spinScale, at);
    }
    double bound = Math.max(kineticBefore, t0.kinetic);
    assertTrue(t.kinetic <= bound * (1 + TOLERANCE), at + ": " + bound + " J to " + t.kinetic);
  }

  /** Upper bound of the kinetic energy that gravity adds in a step before contacts are solved. */
  private static double gravityWork(World world, float dt) {
    double work = 0;
    double g = world.getGravity().length();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      work += b.m_mass * g * dt * (b.m_linearVelocity.length() + 0.5 * g * dt);
    }
    return work;
  }

  /** Whether nothing takes momentum out of the world. */
  private static boolean allMove(World world) {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      if (b.getType() != BodyType.DYNAMIC) {
        return false;
      }
    }
    return true;
  }
}
