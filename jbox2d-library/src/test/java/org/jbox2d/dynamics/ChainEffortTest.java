package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.Joint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Ten links of half a metre with a weight at their end are solved at once. The adaptive solver asks
 * for as many substeps as the sway of the links needs, not for those that iterations would: the 24
 * of a weight of a thousand links, or the 8 of one of a hundred.
 */
class ChainEffortTest {
  private static final int LINKS = 10;
  private static final float LENGTH = 0.5f;

  private World world;
  private Body weight;

  @ParameterizedTest
  @CsvSource({"100, 0, 3", "100, 0.5, 3", "1000, 0, 9", "1000, 0.5, 9"})
  void hangsAndSwingsWithFew(float ratio, float angle, int most) {
    build(angle, ratio);
    float before = Chains.energy(world, Make.G);
    float gap = 0f;
    for (int i = 0; i < 1200; i++) {
      world.step(Make.STEP, 8, 3);
      gap = Math.max(gap, Chains.largestGap(world));
      assertTrue(weight.effort <= most, weight.effort + " in step " + i);
    }
    float scale = Make.G * LINKS * LENGTH * weight.getMass();
    assertEquals(0f, (Chains.energy(world, Make.G) - before) / scale, 0.001f);
    assertTrue(gap < 0.0005f, "gap " + gap);
  }

  /** At the ends of such a swing links are slack, and then jerked taut. */
  @Test
  void whatIsLetGoLevelGetsAllThatIterationsAskFor() {
    build(0.5f * (float) Math.PI, 1000f);
    Make.steps(world, 2);
    assertTrue(weight.effort >= 24, "only " + weight.effort);
  }

  /** With 9 substeps in the step of the blow the links came apart by 3.6 cm. */
  @Test
  void soDoesWhatIsStruck() {
    build(0f, 1000f);
    Make.steps(world, 60);
    assertTrue(weight.effort <= 9, "already " + weight.effort);
    weight.setLinearVelocity(new Vec2(30f, 0f));
    Make.steps(world, 1);
    assertTrue(weight.effort >= 24, "only " + weight.effort);
    float gap = 0f;
    for (int i = 0; i < 300; i++) {
      world.step(Make.STEP, 8, 3);
      gap = Math.max(gap, Chains.largestGap(world));
    }
    assertTrue(gap < 0.001f, "gap " + gap);
  }

  @Test
  void soDoesWhatTouches() {
    build(0f, 1000f);
    weight.createFixture(Make.boxShape(0.5f, 0.5f), 0f);
    Chains.setMass(weight, 50f);
    Make.steps(world, 60);
    assertTrue(weight.effort <= 9, "already " + weight.effort);
    Make.disc(world, 0.3f, weight.getPosition().y + 0.6f, 0.1f);
    Make.steps(world, 30);
    assertTrue(weight.effort >= 24, "only " + weight.effort);
  }

  /** A plank on two rods bears the weight, too. */
  @Test
  void soDoesWhatHangsFromOtherJoints() {
    build(0f, 1000f);
    Joint upper = world.getJointList();
    while (upper.getNext() != null) {
      upper = upper.getNext();
    }
    Body top = upper.getBodyB();
    Body ground = upper.getBodyA();
    world.destroyJoint(upper);
    Body plank = Make.body(world, BodyType.DYNAMIC, 0f, 0f);
    plank.createFixture(Make.boxShape(0.5f, 0.05f), 0.5f).setSensor(true);
    Chains.hinge(world, plank, top, new Vec2());
    for (int side = -1; side <= 1; side += 2) {
      DistanceJointDef rod = new DistanceJointDef();
      rod.initialize(ground, plank, new Vec2(side, 1f), new Vec2(0.5f * side, 0f));
      world.createJoint(rod);
    }
    Make.steps(world, 1);
    assertTrue(weight.effort >= 24, "only " + weight.effort);
  }

  private void build(float angle, float ratio) {
    world = Make.world();
    world.setSolver(Solver.adaptive());
    world.setAllowSleep(false);
    weight = Chains.hangWeight(world, LINKS, LENGTH, angle, ratio);
  }
}
