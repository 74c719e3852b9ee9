package org.jbox2d.dynamics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Dolls of eleven boxes fall on steps. With the soft step every fifth of them stayed hanging on one
 * for good, at velocities that gravity let grow to 40 m/s: the continuous phase stopped it at the
 * very start of each step for the sake of a corner that the solver left out, or of a limb that
 * turned so fast that its arms did not tell where it went.
 */
class HangingDollsTest {
  private static final float SCALE = 0.3f;
  private static final int ROWS = 5;
  private static final int DOLLS_OF_ROW = 25;

  /**
   * Steps in a row in which impacts may hold a doll, and some in which it happens to turn about.
   */
  private static final int MOST_HELD = 20;

  /** Half width, half height, x, y of each part, and the part that it hangs on. */
  private static final float[][] PARTS = {
    {0.30f, 0.25f, 0.00f, 2.00f, -1f},
    {0.28f, 0.25f, 0.00f, 2.50f, 0f},
    {0.20f, 0.20f, 0.00f, 2.95f, 1f},
    {0.12f, 0.45f, -0.15f, 1.30f, 0f},
    {0.10f, 0.45f, -0.15f, 0.40f, 3f},
    {0.12f, 0.45f, 0.15f, 1.30f, 0f},
    {0.10f, 0.45f, 0.15f, 0.40f, 5f},
    {0.25f, 0.09f, -0.53f, 2.60f, 1f},
    {0.25f, 0.08f, -1.03f, 2.60f, 7f},
    {0.25f, 0.09f, 0.53f, 2.60f, 1f},
    {0.25f, 0.08f, 1.03f, 2.60f, 9f}
  };

  static Solver[] solvers() {
    return new Solver[] {Solver.softStep(), Solver.adaptive()};
  }

  @ParameterizedTest
  @MethodSource("solvers")
  void dollsFallOffTheSteps(Solver solver) {
    World world = Make.world();
    world.setSolver(solver);
    steps(world);
    for (int row = 0; row < ROWS; row++) {
      for (int i = 0; i < DOLLS_OF_ROW; i++) {
        doll(world, -7.5f + 0.6f * i, 12f * row + 1f + 1.1f * (i % 5));
      }
    }
    for (int i = 0; i < 15; i++) {
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        b.setUserData(new Watch(b));
      }
      int held = 0;
      for (int k = 0; k < MOST_HELD; k++) {
        Make.steps(world, 1);
        for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
          ((Watch) b.getUserData()).look(b);
        }
      }
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        held += ((Watch) b.getUserData()).held == MOST_HELD ? 1 : 0;
      }
      assertTrue(held == 0, held + " bodies hang in the air by step " + MOST_HELD * (i + 1));
    }
  }

  private static void steps(World world) {
    Body ground = Make.body(world, BodyType.STATIC, 0f, 0f);
    PolygonShape step = new PolygonShape();
    for (int row = 0; row < ROWS; row++) {
      for (int i = 0; i < 6; i++) {
        float x = 3f * (i - 3) + (row % 2) * 1.5f;
        step.setAsBox(0.45f, 0.45f, new Vec2(x, 12f * row), 0f);
        ground.createFixture(step, 0f);
      }
    }
    step.setAsBox(120f, 1f, new Vec2(0f, -8f), 0f);
    ground.createFixture(step, 0f);
    Make.surface(ground, 0.6f, 0f);
  }

  private static void doll(World world, float x, float y) {
    Body[] parts = new Body[PARTS.length];
    for (int k = 0; k < parts.length; k++) {
      float[] p = PARTS[k];
      parts[k] = Make.body(world, BodyType.DYNAMIC, x + SCALE * p[2], y + SCALE * p[3]);
      FixtureDef def = new FixtureDef();
      def.shape = Make.boxShape(SCALE * p[0], SCALE * p[1]);
      def.density = 1f;
      def.friction = 0.3f;
      def.filter.groupIndex = -1;
      parts[k].createFixture(def);
      int parent = (int) p[4];
      if (parent >= 0) {
        boolean arm = k >= 7;
        float jx = arm ? p[2] - Math.signum(p[2]) * p[0] : p[2];
        float jy = arm ? p[3] : p[3] + (p[3] > PARTS[parent][3] ? -p[1] : p[1]);
        RevoluteJointDef hinge = new RevoluteJointDef();
        hinge.initialize(parts[parent], parts[k], new Vec2(x + SCALE * jx, y + SCALE * jy));
        hinge.enableLimit = true;
        hinge.lowerAngle = -0.6f;
        hinge.upperAngle = 0.6f;
        world.createJoint(hinge);
      }
    }
  }

  /** Counts the steps in which a body is fast and does not move. */
  private static final class Watch {
    private static final float FAST = 4f;
    private static final float SHARE = 0.2f;
    private final Vec2 before = new Vec2();
    int held;

    Watch(Body b) {
      before.set(b.getWorldCenter());
    }

    void look(Body b) {
      float way = b.getWorldCenter().sub(before).length();
      float speed = b.getLinearVelocity().length();
      held += speed > FAST && way < SHARE * speed * Make.STEP ? 1 : 0;
      before.set(b.getWorldCenter());
    }
  }
}
