package org.jbox2d.dynamics.joints;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * A small box that hangs on two hinges far outside of it, one with a limit and a motor, the other
 * on a lift that turns slowly: it can go on turning no way that both allow.
 *
 * <p>Symptom: within a step it got velocities of 10^18 m/s and the step then threw. Cause: limit
 * and motor did not look at how the point of their hinge moved, which the other hinge had pushed in
 * between, and each made up for ten times what the other had done.
 */
class FarHingesTest {
  private static final int SCENES = 60;
  private static final int STEPS = 180;

  /** m/s and rad/s; what the lift asks for is below 3, what a motor or a fall brings below 30. */
  private static final float MOST_SPEED = 100f;

  enum Way {
    SEQUENTIAL,
    SOFT,
    ADAPTIVE;

    Solver solver() {
      return switch (this) {
        case SEQUENTIAL -> Solver.sequentialImpulses();
        case SOFT -> Solver.softStep();
        case ADAPTIVE -> Solver.adaptive();
      };
    }
  }

  @ParameterizedTest
  @EnumSource(Way.class)
  void doNotDriveEachOtherUp(Way way) {
    for (int seed = 0; seed < SCENES; seed++) {
      Random random = new Random(seed);
      JointScene scene = new JointScene(JointScene.G);
      scene.world.setSolver(way.solver());
      Body lift = scene.body(BodyType.KINEMATIC, between(random, 3f), between(random, 3f));
      lift.setAngularVelocity(0.3f);
      Body box = scene.box(0f, 0f, 0.3f, 0.2f);
      limited(scene, box, random);
      RevoluteJointDef hinge = new RevoluteJointDef();
      hinge.initialize(lift, box, lift.getPosition().add(new Vec2(0.2f, 0.1f)));
      scene.world.createJoint(hinge);
      for (int i = 0; i < STEPS; i++) {
        scene.step(1);
        float speed = box.getLinearVelocity().length() + Math.abs(box.getAngularVelocity());
        assertTrue(speed < MOST_SPEED, "seed " + seed + " step " + i + ": " + speed);
      }
    }
  }

  private static void limited(JointScene scene, Body box, Random random) {
    float angle = between(random, 3f);
    float arm = 8f + 6f * random.nextFloat();
    RevoluteJointDef hinge = new RevoluteJointDef();
    Vec2 far = new Vec2(arm * (float) StrictMath.cos(angle), arm * (float) StrictMath.sin(angle));
    hinge.initialize(scene.ground, box, far);
    hinge.enableLimit = true;
    hinge.lowerAngle = -0.02f;
    hinge.upperAngle = 0.02f;
    hinge.enableMotor = random.nextBoolean();
    hinge.motorSpeed = between(random, 2f);
    hinge.maxMotorTorque = 1f;
    scene.world.createJoint(hinge);
  }

  private static float between(Random random, float most) {
    return most * (2 * random.nextFloat() - 1);
  }
}
