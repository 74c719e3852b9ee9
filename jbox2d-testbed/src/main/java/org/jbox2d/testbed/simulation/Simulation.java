package org.jbox2d.testbed.simulation;

import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.testbed.scenes.Scene;

/** A run of a scene: its world, stepped at a fixed rate. Used by one thread at a time. */
public final class Simulation {
  private static final double NANOS_PER_MILLI = 1e6;

  private final Scene scene;
  private final float hz;
  private final long seed;
  private final World world;
  private final FractureSystem fractures;
  private final MassBalance massBalance;
  private int steps;
  private double stepMillis;

  /**
   * Builds a scene.
   *
   * @param hz steps per second, positive
   * @param seed seed of the fractures
   */
  public Simulation(Scene scene, float hz, long seed) {
    if (!(hz > 0f) || Float.isInfinite(hz)) {
      throw new IllegalArgumentException("hz must be positive and finite, is " + hz);
    }
    this.scene = scene;
    this.hz = hz;
    this.seed = seed;
    world = scene.newWorld(seed);
    fractures = FractureSystem.of(world);
    massBalance = new MassBalance(world);
  }

  /** Does one step. */
  public void step() {
    long start = System.nanoTime();
    world.step(1f / hz, Scene.VELOCITY_ITERATIONS, Scene.POSITION_ITERATIONS);
    stepMillis = (System.nanoTime() - start) / NANOS_PER_MILLI;
    steps++;
  }

  /** Returns the scene. */
  public Scene scene() {
    return scene;
  }

  /** Returns the steps per second. */
  public float hz() {
    return hz;
  }

  /** Returns the seed of the fractures. */
  public long seed() {
    return seed;
  }

  /** Returns the world. */
  public World world() {
    return world;
  }

  /** Returns the number of steps done. */
  public int steps() {
    return steps;
  }

  /** Returns the simulated time, s. */
  public double time() {
    return (double) steps / hz;
  }

  /** Returns how long the last step took, fractures and all, ms. */
  public double stepMillis() {
    return stepMillis;
  }

  /** Returns the number of fractures so far. */
  public int fractureCount() {
    return fractures.getFractureCount();
  }

  /** Returns the number of fractures that were given up because a check of theirs failed. */
  public int fractureFailures() {
    return fractures.getFailureCount();
  }

  /** Returns the mass of what can break, now and at the start. */
  public MassBalance massBalance() {
    return massBalance;
  }

  /** Returns the number of fixtures. */
  public int fixtureCount() {
    int count = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      count += b.m_fixtureCount;
    }
    return count;
  }

  /** Returns a hash of the state; see {@link StateHash}. */
  public long hash() {
    return StateHash.of(world);
  }
}
