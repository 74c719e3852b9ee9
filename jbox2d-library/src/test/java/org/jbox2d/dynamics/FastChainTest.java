package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.common.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Chains of equal links that turn fast keep their energy for ten seconds, with substeps. */
class FastChainTest {
  private static final int STEPS = 600;

  private World world;
  private final List<Body> links = new ArrayList<>();
  private float largestGap;

  /**
   * Hinged to the ground or flying freely, all turning as one. By iterations three links on the
   * ground lost a hundredth at 5 rad/s, an eighth at 10, six tenths at 20 and nine tenths at 40;
   * with adaptive substeps 2 %, an eighth, half and six tenths. Ten lost half at 10 rad/s and came
   * apart by 5 cm, flying freely a quarter.
   */
  @ParameterizedTest
  @CsvSource({
    "3, 5, true",
    "3, 10, true",
    "3, 20, true",
    "3, 40, true",
    "10, 5, true",
    "10, 10, true",
    "10, 20, true",
    "3, 20, false",
    "10, 10, false",
    "10, 20, false",
    "10, 40, false"
  })
  void turnsOn(int count, float spin, boolean anchored) {
    for (Solver solver : new Solver[] {Solver.softStep(), Solver.adaptive()}) {
      chain(count, 0.4f, anchored, 0f, solver);
      spin(spin, anchored ? 0f : 0.2f * count);
      assertEquals(1f, shareAfter(0f), 0.01f);
      assertTrue(largestGap < 0.0005f, "gap " + largestGap);
    }
  }

  /**
   * Each link with another spin. By iterations three of them lost four tenths with spins up to 40
   * rad/s, and five nearly half with spins up to 20.
   */
  @ParameterizedTest
  @CsvSource({"2, 40", "3, 20", "3, 40", "5, 20"})
  void crumplesOn(int count, float most) {
    chain(count, 0.4f, true, 0f, Solver.softStep());
    Random random = new Random(7);
    float v = 0f;
    for (Body link : links) {
      float spin = most * (2f * random.nextFloat() - 1f);
      link.setAngularVelocity(spin);
      link.setLinearVelocity(new Vec2(0f, v + 0.2f * spin));
      v += 0.4f * spin;
    }
    assertEquals(1f, shareAfter(0f), 0.02f);
    assertTrue(largestGap < 0.0005f, "gap " + largestGap);
  }

  /**
   * A rope of ten links of 0.2 m, let go level, swings and cracks at its end. With adaptive
   * substeps it lost a quarter of the energy of its fall, and came apart by 5 mm.
   */
  @Test
  void aRopeSwingsOn() {
    chain(10, 0.2f, true, Make.G, Solver.adaptive());
    float fall = 10 * links.get(0).getMass() * Make.G * 2f;
    float before = Chains.energy(world, Make.G);
    shareAfter(Make.G);
    assertEquals(0f, (Chains.energy(world, Make.G) - before) / fall, 0.02f);
    assertTrue(largestGap < 0.002f, "gap " + largestGap);
  }

  private void chain(int count, float length, boolean anchored, float gravity, Solver solver) {
    world = new World(new Vec2(0f, -gravity));
    world.setSolver(solver);
    world.setAllowSleep(false);
    links.clear();
    Body last = anchored ? Make.body(world, BodyType.STATIC, 0f, 0f) : null;
    for (int i = 0; i < count; i++) {
      Body link = Make.body(world, BodyType.DYNAMIC, (i + 0.5f) * length, 0f);
      link.createFixture(Make.boxShape(0.5f * length, 0.125f * length), 1f).setSensor(true);
      if (last != null) {
        Chains.hinge(world, last, link, new Vec2(i * length, 0f));
      }
      links.add(link);
      last = link;
    }
  }

  private void spin(float spin, float centre) {
    for (Body link : links) {
      link.setAngularVelocity(spin);
      link.setLinearVelocity(new Vec2(0f, spin * (link.getWorldCenter().x - centre)));
    }
  }

  /** Returns the share of the energy that is left at the end; notes the largest gap. */
  private float shareAfter(float gravity) {
    float before = Chains.energy(world, gravity);
    largestGap = 0f;
    for (int i = 0; i < STEPS; i++) {
      world.step(Make.STEP, 8, 3);
      largestGap = Math.max(largestGap, Chains.largestGap(world));
    }
    return Chains.energy(world, gravity) / before;
  }
}
