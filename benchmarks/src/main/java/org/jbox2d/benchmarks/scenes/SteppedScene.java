package org.jbox2d.benchmarks.scenes;

import org.jbox2d.benchmarks.engines.Kind;
import org.jbox2d.benchmarks.engines.Matter;
import org.jbox2d.benchmarks.engines.Sim;
import org.jbox2d.benchmarks.engines.SimBody;

/** A scene under way. */
public class SteppedScene implements AutoCloseable {
  static final Matter WOOD = Matter.rough(1, 0.6);
  private static final double DT = 1.0 / 60;

  final Sim sim;

  /** A scene that does nothing but step. */
  SteppedScene(Sim sim) {
    this.sim = sim;
  }

  /** Runs one frame: what the scene does by itself each frame, and a step of 1/60 s. */
  public void step() {
    sim.step(DT);
  }

  /** Number of bodies. */
  public final int bodyCount() {
    return sim.bodies();
  }

  @Override
  public void close() {
    sim.close();
  }

  static SimBody floor(Sim sim, double halfWidth) {
    return sim.body(Kind.STATIC, 0, -1, 0).box(halfWidth, 1, WOOD);
  }

  /** Floor with its top at y = 0 and two walls, open above. */
  static void container(Sim sim, double halfWidth, double height) {
    sim.ground()
        .box(halfWidth + 1, 0.5, 0, -0.5, WOOD)
        .box(0.5, 0.5 * height, -halfWidth - 0.5, 0.5 * height, WOOD)
        .box(0.5, 0.5 * height, halfWidth + 0.5, 0.5 * height, WOOD);
  }
}
