package org.jbox2d.benchmarks.scenes;

import java.util.Random;
import org.jbox2d.benchmarks.SteppedScene;
import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;

/** Rays through a settled pile, each to its nearest hit; a step is 10,000 rays. */
final class RayScene implements SteppedScene, RayCastCallback {
  private static final int RAYS = 10_000;
  private static final int SETTLING_STEPS = 240;

  private final WorldScene pile;
  private final Vec2[] starts = new Vec2[RAYS];
  private final Vec2[] ends = new Vec2[RAYS];
  private float nearest;

  RayScene(WorldScene pile) {
    this.pile = pile;
    for (int i = 0; i < SETTLING_STEPS; i++) {
      pile.step();
    }
    Random random = new Random(3);
    for (int i = 0; i < RAYS; i++) {
      starts[i] = point(random);
      ends[i] = point(random);
    }
  }

  private static Vec2 point(Random random) {
    return new Vec2(20f * random.nextFloat() - 10f, 20f * random.nextFloat());
  }

  @Override
  public void step() {
    for (int i = 0; i < RAYS; i++) {
      nearest = 1f;
      pile.world.raycast(this, starts[i], ends[i]);
    }
  }

  @Override
  public float reportFixture(Fixture fixture, Vec2 point, Vec2 normal, float fraction) {
    nearest = fraction;
    return fraction;
  }

  @Override
  public int bodyCount() {
    return pile.bodyCount();
  }
}
