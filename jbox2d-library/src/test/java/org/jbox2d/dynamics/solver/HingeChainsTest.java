package org.jbox2d.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Once solved, the points of a chain's hinges move together, by impulses between its bodies that
 * take kinetic energy and leave momentum.
 */
class HingeChainsTest {
  private static final int CASES = 500;

  /** s; so short that paths are straight. */
  private static final float H = 1e-6f;

  private final SolverBodies bodies = new SolverBodies();
  private final JointRows rows = new JointRows();
  private final HingeChains chains = new HingeChains(bodies, rows);
  private final StepConfig step = new StepConfig();
  private int[] slots;
  private Random random;

  /** Bodies of 0.03 to 30 kg and a tenth of a metre to a metre; the first may be held. */
  private void place(int n, boolean held) {
    bodies.ensureCapacity(n);
    bodies.count = n;
    slots = new int[held ? n - 1 : n];
    for (int i = 0; i < n; i++) {
      boolean moves = i > 0 || !held;
      if (moves) {
        slots[i - (held ? 1 : 0)] = i;
      }
      int o = SolverBodies.STRIDE * i;
      float mass = (float) Math.pow(10, 3 * random.nextFloat() - 1.5);
      float radius = (float) Math.pow(10, -random.nextFloat());
      bodies.mass[o] = moves ? 1 / mass : 0f;
      bodies.mass[o + 1] = moves ? 1 / (mass * radius * radius) : 0f;
      for (int k = 0; k < 3; k++) {
        bodies.vel[o + k] = moves ? (float) random.nextGaussian() : 0f;
      }
      bodies.setAngle(i, 0f);
    }
    rows.clear();
  }

  /** Hinges two bodies, either of which may be the first, and puts the second in its place. */
  private void hinge(int a, int b) {
    boolean swapped = random.nextBoolean();
    int row =
        rows.add(JointKernels.REVOLUTE, RevoluteKernel.FLOATS, swapped ? b : a, swapped ? a : b);
    float ax = random.nextFloat() - 0.5f;
    float ay = random.nextFloat() - 0.5f;
    float bx = random.nextFloat() - 0.5f;
    float by = random.nextFloat() - 0.5f;
    int oA = SolverBodies.STRIDE * a;
    int oB = SolverBodies.STRIDE * b;
    bodies.pos[oB] = bodies.pos[oA] + ax - bx;
    bodies.pos[oB + 1] = bodies.pos[oA + 1] + ay - by;
    int o = rows.floatAt[row];
    if (swapped) {
      Arms.write(rows.f, o, bx, by, ax, ay);
    } else {
      Arms.write(rows.f, o, ax, ay, bx, by);
    }
  }

  private void find(boolean touching) {
    step.dt = H;
    step.invDt = 1 / H;
    step.linearSlop = 0.005f;
    chains.find(0, rows.count, slots, 0, slots.length, touching, step);
  }

  private void solve() {
    find(false);
    JointKernels.REVOLUTE.prepare(rows, 0, rows.count, bodies, step);
    chains.factor();
    chains.solve(step);
  }

  private double largestSpeed() {
    double most = 0;
    for (int r = 0; r < rows.count; r++) {
      int o = rows.floatAt[r];
      int a = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r]];
      int b = SolverBodies.STRIDE * rows.bodies[rows.bodyAt[r] + 1];
      float x = Arms.speedX(rows.f, o, bodies.vel, a, b);
      float y = Arms.speedY(rows.f, o, bodies.vel, a, b);
      most = Math.max(most, Math.hypot(x, y));
    }
    return most;
  }

  private double energy() {
    double twice = 0;
    for (int slot : slots) {
      int o = SolverBodies.STRIDE * slot;
      double square = square(bodies.vel[o]) + square(bodies.vel[o + 1]);
      twice += square / bodies.mass[o] + square(bodies.vel[o + 2]) / bodies.mass[o + 1];
    }
    return 0.5 * twice;
  }

  private static double square(double x) {
    return x * x;
  }

  private double momentum(int axis) {
    double sum = 0;
    for (int slot : slots) {
      sum +=
          bodies.vel[SolverBodies.STRIDE * slot + axis] / bodies.mass[SolverBodies.STRIDE * slot];
    }
    return sum;
  }

  @Test
  void pointsMoveTogether() {
    for (int seed = 0; seed < CASES; seed++) {
      random = new Random(seed);
      boolean held = random.nextBoolean();
      int n = 4 + random.nextInt(12);
      place(n, held);
      // Unequal enough, whatever else they are.
      bodies.mass[SolverBodies.STRIDE] = 0.03f;
      bodies.mass[2 * SolverBodies.STRIDE] = 30f;
      for (int i = 1; i < n; i++) {
        hinge(i - 1, i);
      }
      double energy = energy();
      double x = momentum(0);
      double y = momentum(1);
      solve();
      assertTrue(chains.areThere(), "seed " + seed);
      assertEquals(0, largestSpeed(), 2e-3, "seed " + seed);
      assertTrue(energy() <= energy * (1 + 1e-5), "seed " + seed);
      if (!held) {
        assertEquals(x, momentum(0), 2e-3, "seed " + seed);
        assertEquals(y, momentum(1), 2e-3, "seed " + seed);
      }
    }
  }

  /** Three chains meet in a body; each is solved for itself, the last one last. */
  @Test
  void chainsThatMeetAreSolvedOneByOne() {
    for (int seed = 0; seed < CASES; seed++) {
      random = new Random(seed);
      place(10, false);
      bodies.mass[SolverBodies.STRIDE] = 0.03f;
      bodies.mass[2 * SolverBodies.STRIDE] = 30f;
      for (int branch = 0; branch < 3; branch++) {
        for (int i = 0; i < 3; i++) {
          hinge(i == 0 ? 0 : 3 * branch + i, 3 * branch + i + 1);
        }
      }
      double energy = energy();
      for (int i = 0; i < 200; i++) {
        solve();
      }
      assertEquals(0, largestSpeed(), 2e-3, "seed " + seed);
      assertTrue(energy() <= energy * (1 + 1e-4), "seed " + seed);
    }
  }

  /** A bridge, a ring, equal masses, and an end that something else holds are left alone. */
  @Test
  void leavesWhatMayContradictItself() {
    random = new Random(1);
    place(6, true);
    bodies.mass[SolverBodies.STRIDE] = 0.03f;
    bodies.mass[2 * SolverBodies.STRIDE] = 30f;
    for (int i = 1; i < 6; i++) {
      hinge(i - 1, i);
    }
    find(false);
    assertTrue(chains.areThere());
    hinge(5, 0);
    find(false);
    assertFalse(chains.areThere(), "ring");

    rows.count--;
    rows.add(JointKernels.DISTANCE, DistanceKernel.FLOATS, 5, 0);
    find(false);
    assertFalse(chains.areThere(), "held by a rod");

    rows.count--;
    for (int slot : slots) {
      bodies.mass[SolverBodies.STRIDE * slot] = 1f;
    }
    find(false);
    assertFalse(chains.areThere(), "equal masses");
  }

  /** Of like masses, chains are looked for that turn by more than 0.015 rad and touch nothing. */
  @Test
  void findsEvenChainsThatTurnFast() {
    random = new Random(1);
    place(8, true);
    for (int slot : slots) {
      bodies.mass[SolverBodies.STRIDE * slot] = 1f;
    }
    // Two chains of an island; the first of them turns.
    for (int i = 1; i < 4; i++) {
      hinge(i - 1, i);
    }
    hinge(0, 4);
    for (int i = 5; i < 8; i++) {
      hinge(i - 1, i);
    }
    bodies.vel[SolverBodies.STRIDE * 2 + 2] = 0.014f / H;
    find(false);
    assertFalse(chains.areThere(), "slow");
    bodies.vel[SolverBodies.STRIDE * 2 + 2] = -0.016f / H;
    find(false);
    assertTrue(chains.areThere(), "fast");
    assertEquals(3, chains.linkCount());
    find(true);
    assertFalse(chains.areThere(), "touching");
  }

  /** A hinge alone, from a body that has two more, is no chain. */
  @Test
  void knowsItsRows() {
    random = new Random(1);
    place(6, true);
    bodies.mass[SolverBodies.STRIDE] = 0.03f;
    bodies.mass[2 * SolverBodies.STRIDE] = 30f;
    hinge(0, 1);
    hinge(1, 2);
    hinge(1, 3);
    hinge(3, 4);
    hinge(4, 5);
    find(false);
    assertEquals(3, chains.linkCount());
    for (int r = 0; r < rows.count; r++) {
      assertEquals(r >= 2, chains.has(r), "row " + r);
    }
  }
}
