package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * While no body wakes or falls asleep and no joint comes or goes, a step takes over from the last
 * one what joints tie together. A world that looks anew in each step goes the same way, bit by bit.
 */
class KeptJointSetsTest {
  private static final int BODIES = 40;
  private static final int STEPS = 400;

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6})
  void looksAnewWhereSomethingChanged(int seed) {
    Scene kept = new Scene(seed);
    Scene anew = new Scene(seed);
    for (int i = 0; i < STEPS; i++) {
      kept.disturb();
      anew.disturb();
      anew.world.awake.changes++;
      Make.steps(kept.world, 1);
      Make.steps(anew.world, 1);
      assertEquals(StateHash.of(anew.world), StateHash.of(kept.world), "step " + i);
    }
  }

  /** Hinged and welded bodies above ground, to which now and then something is done. */
  private static final class Scene {
    final World world = Make.world();
    private final Random random;
    private final Body ground = Make.ground(world);
    private final List<Body> bodies = new ArrayList<>();
    private final List<Joint> joints = new ArrayList<>();

    Scene(int seed) {
      random = new Random(seed);
      world.setSolver(seed % 2 == 0 ? Solver.sequentialImpulses() : Solver.softStep());
      for (int i = 0; i < BODIES; i++) {
        bodies.add(box());
      }
      for (int i = 0; i < BODIES; i++) {
        tie();
      }
    }

    private Body box() {
      float x = 10f * random.nextFloat();
      return Make.box(world, BodyType.DYNAMIC, x, 1f + 4f * random.nextFloat(), 0.3f, 0.2f);
    }

    private Body any() {
      return bodies.get(random.nextInt(bodies.size()));
    }

    private void tie() {
      Body a = random.nextInt(4) == 0 ? ground : any();
      Body b = any();
      if (a == b) {
        return;
      }
      if (random.nextBoolean()) {
        RevoluteJointDef def = new RevoluteJointDef();
        def.initialize(a, b, new Vec2(b.getPosition()));
        joints.add(world.createJoint(def));
      } else {
        WeldJointDef def = new WeldJointDef();
        def.initialize(a, b, new Vec2(b.getPosition()));
        joints.add(world.createJoint(def));
      }
    }

    void disturb() {
      switch (random.nextInt(60)) {
        case 0 -> tie();
        case 1 -> {
          if (!joints.isEmpty()) {
            world.destroyJoint(joints.remove(random.nextInt(joints.size())));
          }
        }
        case 2 -> any().setAwake(false);
        case 3 -> any().setActive(false);
        case 4 -> any().setActive(true);
        case 5 -> any().setType(BodyType.values()[random.nextInt(3)]);
        case 6 -> any().applyLinearImpulse(new Vec2(0f, 2f), any().getPosition());
        case 7 -> replace();
        case 8 -> ground.setActive(!ground.isActive());
        default -> {}
      }
    }

    private void replace() {
      Body old = any();
      bodies.remove(old);
      joints.removeIf(j -> j.getBodyA() == old || j.getBodyB() == old);
      world.destroyBody(old);
      bodies.add(box());
    }
  }
}
