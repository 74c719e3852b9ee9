package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
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
    float before = energy();
    float gap = 0f;
    for (int i = 0; i < 1200; i++) {
      world.step(Make.STEP, 8, 3);
      gap = Math.max(gap, largestGap());
      assertTrue(weight.effort <= most, weight.effort + " in step " + i);
    }
    float scale = Make.G * LINKS * LENGTH * weight.getMass();
    assertEquals(0f, (energy() - before) / scale, 0.001f);
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
      gap = Math.max(gap, largestGap());
    }
    assertTrue(gap < 0.001f, "gap " + gap);
  }

  @Test
  void soDoesWhatTouches() {
    build(0f, 1000f);
    weight.createFixture(Make.boxShape(0.5f, 0.5f), 0f);
    weight.setMassData(mass(50f));
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
    join(plank, top, new Vec2());
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
    Vec2 along = new Vec2((float) StrictMath.sin(angle), -(float) StrictMath.cos(angle));
    Body last = Make.body(world, BodyType.STATIC, 0f, 0f);
    for (int i = 0; i < LINKS; i++) {
      Vec2 centre = along.mul((i + 0.5f) * LENGTH);
      Body link = Make.body(world, BodyType.DYNAMIC, centre.x, centre.y);
      link.setTransform(centre, angle);
      link.createFixture(Make.boxShape(0.05f, 0.5f * LENGTH), 1f).setSensor(true);
      join(last, link, along.mul(i * LENGTH));
      last = link;
    }
    Vec2 end = along.mul(LINKS * LENGTH);
    weight = Make.body(world, BodyType.DYNAMIC, end.x, end.y);
    weight.setMassData(mass(ratio * last.getMass()));
    join(last, weight, end);
  }

  /** That of a box of a metre. */
  private static MassData mass(float mass) {
    MassData data = new MassData();
    data.mass = mass;
    data.I = mass / 6f;
    return data;
  }

  private void join(Body a, Body b, Vec2 anchor) {
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, anchor);
    world.createJoint(def);
  }

  private float energy() {
    float sum = 0f;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      float spin = b.getAngularVelocity();
      sum += 0.5f * b.getMass() * b.getLinearVelocity().lengthSquared();
      sum += 0.5f * b.getInertia() * spin * spin;
      sum += b.getMass() * Make.G * b.getWorldCenter().y;
    }
    return sum;
  }

  private float largestGap() {
    float gap = 0f;
    Vec2 a = new Vec2();
    Vec2 b = new Vec2();
    for (Joint joint = world.getJointList(); joint != null; joint = joint.getNext()) {
      joint.getAnchorA(a);
      joint.getAnchorB(b);
      gap = Math.max(gap, a.sub(b).length());
    }
    return gap;
  }
}
