package org.jbox2d.benchmarks.scenes;

import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/**
 * 400 bullets at 200 m/s against 40 thin posts. Each frame 20 of them start anew, so that each
 * flies for a third of a second.
 */
final class BulletHail extends SteppedScene {
  private static final int BULLETS = 400;
  private static final int POSTS = 40;
  private static final int SALVO = 20;
  private static final double SPEED = 200;

  private final SimBody[] bullets = new SimBody[BULLETS];
  private int next;

  BulletHail(Sim sim) {
    super(sim);
    sim.body(Kind.STATIC, 0, -10, 0).box(100, 1, WOOD);
    for (int i = 0; i < POSTS; i++) {
      sim.body(Kind.STATIC, 20 + i % 4, 0.25 * i, 0).box(0.05, 0.3, WOOD);
    }
    for (int i = 0; i < BULLETS; i++) {
      bullets[i] = sim.dynamic(-100 + 0.3 * i, -5).disc(0.05, Matter.rough(4, 0.6)).bullet();
    }
  }

  @Override
  public void step() {
    for (int i = 0; i < SALVO; i++) {
      bullets[next].place(0.5 * i, 0.025 * next).move(SPEED, 0, 0);
      next = (next + 1) % BULLETS;
    }
    super.step();
  }
}
