package org.jbox2d.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * One iteration of a hinge whose limit holds, from velocities as other joints leave them, in which
 * the points part. To hold velocities in a subspace is a projection; what takes nothing but
 * impulses of the joint for it is the orthogonal one, which never adds kinetic energy.
 */
class RevoluteKernelTest {
  private static final int CASES = 2000;

  /** s; so short that paths are straight. */
  private static final float H = 1e-6f;

  private final SolverBodies bodies = new SolverBodies();
  private final JointRows rows = new JointRows();
  private final StepConfig step = new StepConfig();

  /** A body of a kilogram with a radius of gyration of 0.2 m, of another it is up to ten times. */
  private void place(Random random, boolean still) {
    bodies.ensureCapacity(2);
    bodies.count = 2;
    for (int i = 0; i < 2; i++) {
      int o = SolverBodies.STRIDE * i;
      float scale = (float) Math.pow(10, random.nextFloat() - 0.5);
      boolean moves = i == 1 || !still;
      bodies.mass[o] = moves ? scale : 0f;
      bodies.mass[o + 1] = moves ? 25f * scale : 0f;
      bodies.vel[o] = moves ? (float) random.nextGaussian() : 0f;
      bodies.vel[o + 1] = moves ? (float) random.nextGaussian() : 0f;
      bodies.vel[o + 2] = moves ? (float) random.nextGaussian() : 0f;
      bodies.pos[o] = 0f;
      bodies.pos[o + 1] = 0f;
      bodies.setAngle(i, 0f);
    }
  }

  /**
   * Pins the bodies at points as far as {@code arm} from their centres; their angle is at both
   * limits.
   */
  private void pin(Random random, float arm) {
    rows.clear();
    int row = rows.add(JointKernels.REVOLUTE, RevoluteKernel.FLOATS, 0, 1);
    int o = rows.floatAt[row];
    float x = arm * (float) random.nextGaussian();
    float y = arm * (float) random.nextGaussian();
    float share = random.nextFloat();
    Arms.write(rows.f, o, x, y, share * x, y - share * y);
    bodies.pos[SolverBodies.STRIDE] = x - share * x;
    bodies.pos[SolverBodies.STRIDE + 1] = share * y;
    RevoluteKernel.writeLimit(rows.f, o, 0f, true, 0f, 0f);
  }

  private void solve() {
    step.readSettings();
    step.dt = H;
    step.invDt = 1f / H;
    JointKernels.REVOLUTE.prepare(rows, 0, 1, bodies, step);
    JointKernels.REVOLUTE.solveVelocity(rows, 0, 1, bodies, step);
  }

  private double energy() {
    double e = 0;
    for (int i = 0; i < 2; i++) {
      int o = SolverBodies.STRIDE * i;
      if (bodies.mass[o] > 0f) {
        double vx = bodies.vel[o];
        double vy = bodies.vel[o + 1];
        double w = bodies.vel[o + 2];
        e += (vx * vx + vy * vy) / bodies.mass[o] + w * w / bodies.mass[o + 1];
      }
    }
    return 0.5 * e;
  }

  @ParameterizedTest
  @ValueSource(floats = {0f, 0.02f, 0.2f, 2f, 6f, 12f})
  void neverAddsEnergy(float arm) {
    for (int i = 0; i < CASES; i++) {
      Random random = new Random(i);
      place(random, i % 2 == 0);
      pin(random, arm);
      double before = energy();
      solve();
      double after = energy();
      assertTrue(after <= 1.001 * before, "case " + i + ": " + before + " J to " + after + " J");
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {0f, 0.02f, 0.2f, 2f, 6f})
  void solvesPointAndLimitAtOnce(float arm) {
    for (int i = 0; i < CASES; i++) {
      Random random = new Random(i);
      place(random, i % 2 == 0);
      pin(random, arm);
      solve();
      int b = SolverBodies.STRIDE;
      String which = "case " + i;
      float tolerance = 1e-2f;
      assertEquals(0f, bodies.vel[b + 2] - bodies.vel[2], tolerance, which);
      assertEquals(0f, Arms.speedX(rows.f, 0, bodies.vel, 0, b), tolerance, which);
      assertEquals(0f, Arms.speedY(rows.f, 0, bodies.vel, 0, b), tolerance, which);
    }
  }

  /** Bodies of infinite mass that turn about their centres are braked by the limit alone. */
  @Test
  void limitsBodiesThatOnlyTurn() {
    Random random = new Random(1);
    place(random, false);
    pin(random, 0f);
    bodies.mass[0] = 0f;
    bodies.mass[SolverBodies.STRIDE] = 0f;
    solve();
    assertEquals(bodies.vel[2], bodies.vel[SolverBodies.STRIDE + 2], 1e-5f);
  }
}
