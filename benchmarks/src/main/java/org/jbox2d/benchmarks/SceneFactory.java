package org.jbox2d.benchmarks;

/** Builds scenes by name in one engine. */
public interface SceneFactory {
  /**
   * Builds a scene.
   *
   * @param name one of {@link SceneSpec}'s names
   */
  SteppedScene build(String name);
}
