package org.jbox2d.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the books give back, of random bodies whose angular momentum has been disturbed. */
class SpinBooksTest {
  private static final int BODIES = 6;
  private static final int[] SLOTS = {7, 2, 5, 0, 3, 9};
  private static final double ROUNDING = 1e-6;

  private final SolverBodies bodies = new SolverBodies();
  private final SpinBooks books = new SpinBooks(bodies);

  private void fill(Random random) {
    bodies.count = 10;
    bodies.ensureCapacity(bodies.count);
    for (int slot : SLOTS) {
      int o = SolverBodies.STRIDE * slot;
      bodies.mass[o] = 0.2f + random.nextFloat();
      bodies.mass[o + 1] = 0.5f + 5f * random.nextFloat();
      for (int j = 0; j < 3; j++) {
        bodies.vel[o + j] = 10f * random.nextFloat() - 3f;
      }
      bodies.pos[o] = 100f + 6f * random.nextFloat();
      bodies.pos[o + 1] = -50f + 6f * random.nextFloat();
    }
  }

  /** As arms that are a little wrong would. */
  private void disturb(Random random) {
    for (int slot : SLOTS) {
      bodies.vel[SolverBodies.STRIDE * slot + 2] += 0.2f * random.nextFloat();
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void keepsMomentumAndEnergy(boolean bounces) {
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      fill(random);
      double[] before = totals();
      books.open(SLOTS, 0, BODIES);
      disturb(random);
      double[] disturbed = totals();
      books.close(SLOTS, 0, BODIES, bounces, SpinBooks.SMALL);
      double[] after = totals();
      String what = "seed " + seed;
      assertTrue(Math.abs(disturbed[2] - before[2]) > 0.01, what);
      double scale = Math.sqrt(before[3] * 100);
      assertEquals(before[0], after[0], ROUNDING * scale, what);
      assertEquals(before[1], after[1], ROUNDING * scale, what);
      assertEquals(before[2], after[2], ROUNDING * scale * 10, what);
      if (bounces) {
        assertEquals(disturbed[3], after[3], ROUNDING * 10 * before[3], what);
      } else {
        assertTrue(after[3] <= Math.max(before[3], disturbed[3]) * (1 + ROUNDING), what);
      }
    }
  }

  /** Points of two bodies that stand still against each other do so afterwards. */
  @Test
  void leavesRestAtRest() {
    Random random = new Random(1);
    fill(random);
    for (int slot : SLOTS) {
      int o = SolverBodies.STRIDE * slot;
      bodies.vel[o] = 1f - 0.5f * (bodies.pos[o + 1] + 47f);
      bodies.vel[o + 1] = 2f + 0.5f * (bodies.pos[o] - 103f);
      bodies.vel[o + 2] = 0.51f;
    }
    books.open(SLOTS, 0, BODIES);
    for (int slot : SLOTS) {
      bodies.vel[SolverBodies.STRIDE * slot + 2] = 0.5f;
    }
    books.close(SLOTS, 0, BODIES, false, SpinBooks.SMALL);
    int first = SolverBodies.STRIDE * SLOTS[0];
    float w = bodies.vel[first + 2];
    assertTrue(w > 0.5f && w < 0.51f, "turns at " + w);
    for (int slot : SLOTS) {
      int o = SolverBodies.STRIDE * slot;
      double x = bodies.pos[o] - bodies.pos[first];
      double y = bodies.pos[o + 1] - bodies.pos[first + 1];
      assertEquals(w, bodies.vel[o + 2], 1e-6);
      assertEquals(bodies.vel[first] - w * y, bodies.vel[o], 1e-5);
      assertEquals(bodies.vel[first + 1] + w * x, bodies.vel[o + 1], 1e-5);
    }
  }

  /** Bodies put elsewhere, and their centre of mass with them, keep it about a fixed point. */
  @Test
  void movedBodiesKeepItAboutAFixedPoint() {
    double most = 0;
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      fill(random);
      double before = about(100, -50);
      books.open(SLOTS, 0, BODIES);
      for (int slot : SLOTS) {
        bodies.pos[SolverBodies.STRIDE * slot] += 0.02f * random.nextFloat();
        bodies.pos[SolverBodies.STRIDE * slot + 1] += 0.02f * random.nextFloat();
      }
      most = Math.max(most, Math.abs(about(100, -50) - before));
      books.closeMoved(SLOTS, 0, BODIES, SpinBooks.SMALL);
      assertEquals(before, about(100, -50), 1e-4, "seed " + seed);
    }
    assertTrue(most > 0.1);
  }

  /** A third of it is no error of arms. */
  @Test
  void leavesWhatIsNoErrorOfArms() {
    fill(new Random(3));
    books.open(SLOTS, 0, BODIES);
    for (int slot : SLOTS) {
      bodies.vel[SolverBodies.STRIDE * slot + 2] += 30f;
    }
    float[] before = bodies.vel.clone();
    books.close(SLOTS, 0, BODIES, false, SpinBooks.SMALL);
    assertArrayEquals(before, bodies.vel);
  }

  /** Momentum x, y, angular momentum about the centre of mass, energy against its velocity. */
  private double[] totals() {
    double mass = 0;
    double x = 0;
    double y = 0;
    double px = 0;
    double py = 0;
    double energy = 0;
    for (int slot : SLOTS) {
      int o = SolverBodies.STRIDE * slot;
      double m = 1.0 / bodies.mass[o];
      double vx = bodies.vel[o];
      double vy = bodies.vel[o + 1];
      double w = bodies.vel[o + 2];
      mass += m;
      x += m * bodies.pos[o];
      y += m * bodies.pos[o + 1];
      px += m * vx;
      py += m * vy;
      energy += 0.5 * (m * (vx * vx + vy * vy) + w * w / bodies.mass[o + 1]);
    }
    double[] totals = {px, py, about(x / mass, y / mass), 0};
    totals[3] = energy - 0.5 * (px * px + py * py) / mass;
    return totals;
  }

  private double about(double x, double y) {
    double spin = 0;
    for (int slot : SLOTS) {
      int o = SolverBodies.STRIDE * slot;
      double rx = bodies.pos[o] - x;
      double ry = bodies.pos[o + 1] - y;
      spin += (rx * bodies.vel[o + 1] - ry * bodies.vel[o]) / bodies.mass[o];
      spin += bodies.vel[o + 2] / bodies.mass[o + 1];
    }
    return spin;
  }
}
