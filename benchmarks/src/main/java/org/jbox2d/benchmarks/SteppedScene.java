package org.jbox2d.benchmarks;

/** A scene in some engine. Shared by all engines' class loaders, so it names no engine's types. */
public interface SteppedScene {
  /** Runs one frame: what the scene does by itself each frame, and a step of 1/60 s at 8/3. */
  void step();

  /** Number of bodies, to tell that engines have built the same scene. */
  int bodyCount();
}
