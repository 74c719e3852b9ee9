package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.Stream;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Glass;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A pile of splinters falls asleep and stays so. It used to be kept awake by a few: those that two
 * parts of a concave piece pushed into each other for ever, and those that are wedged between heavy
 * ones, whose velocities never calm down though they go nowhere.
 */
class PileTest {
  private static final float HZ = 60f;
  private static final float G = 9.81f;

  /** Half the width of the box, m. */
  private static final float HALF = 4f;

  private static final float HALF_PANE = 0.9f;

  static Stream<Solver> solvers() {
    return Stream.of(Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive());
  }

  private static final int PILES = 7;

  /** How long after the last fracture a pile is awake at most, and half of the piles, s. */
  private static final float LONGEST = 60f;

  private static final float MEDIAN = 12f;

  @ParameterizedTest
  @MethodSource("solvers")
  void pilesOfGlassFallAsleep(Solver solver) {
    float[] times = new float[PILES];
    for (int i = 0; i < PILES; i++) {
      times[i] = timeToSleep(solver, 0.1f * i);
    }
    Arrays.sort(times);
    assertTrue(times[PILES / 2] <= MEDIAN, Arrays.toString(times));
  }

  /** Returns how long after the last fracture the panes, turned by an angle, are all asleep, s. */
  private static float timeToSleep(Solver solver, float turn) {
    World world = new World(new Vec2(0f, -G));
    world.setSolver(solver);
    box(world);
    for (int i = 0; i < 4; i++) {
      Glass glass = new Glass();
      glass.m_rigidity = 6f;
      glass.m_shattering = 1f;
      glass.m_radius = 4f;
      Body pane = Range.body(world, BodyType.DYNAMIC, 1.2f * i - 1.1f, 5f + 4f * i);
      pane.setTransform(pane.getPosition(), 0.4f + i + turn);
      Range.fixture(pane, Range.box(HALF_PANE, HALF_PANE), 1f, glass);
    }
    double energy = energy(world);
    int fractures = 0;
    int sinceFracture = 0;
    while (awake(world) > 0 && sinceFracture < LONGEST * HZ) {
      Range.step(world, HZ, 1 / HZ);
      boolean broken = FractureSystem.of(world).getFractureCount() > fractures;
      fractures = FractureSystem.of(world).getFractureCount();
      sinceFracture = broken ? 0 : sinceFracture + 1;
      assertTrue(energy(world) <= 1.001 * energy, "energy " + energy + " -> " + energy(world));
    }
    String what = world.getBodyCount() + " bodies, " + awake(world) + " awake";
    assertTrue(world.getBodyCount() >= 60, what);
    assertEquals(0, awake(world), what);
    energy = energy(world);
    Range.step(world, HZ, 5f);
    assertEquals(0, awake(world), "woke again");
    assertEquals(energy, energy(world), 1e-6 * energy);
    return sinceFracture / HZ;
  }

  private static void box(World world) {
    Body body = Range.body(world, BodyType.STATIC, 0f, -1f);
    Range.fixture(body, Range.box(HALF + 2f, 1f), 0f, null);
    for (int side = -1; side <= 1; side += 2) {
      Body wall = Range.body(world, BodyType.STATIC, side * (HALF + 1f), 10f);
      Range.fixture(wall, Range.box(1f, 12f), 0f, null);
    }
    // A splinter of 9 g that a pane of 3 kg squeezes out has left at 44 m/s, over the walls.
    Body lid = Range.body(world, BodyType.STATIC, 0f, 23f);
    Range.fixture(lid, Range.box(HALF + 2f, 1f), 0f, null);
  }

  private static int awake(World world) {
    int awake = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      awake += b.getType() == BodyType.DYNAMIC && b.isAwake() ? 1 : 0;
    }
    return awake;
  }

  /** Kinetic energy and that of height over the floor, J. */
  private static double energy(World world) {
    double sum = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      double v = b.getLinearVelocity().length();
      double w = b.getAngularVelocity();
      sum += 0.5 * b.m_mass * v * v + 0.5 * b.m_I * w * w + b.m_mass * G * b.getWorldCenter().y;
    }
    return sum;
  }
}
