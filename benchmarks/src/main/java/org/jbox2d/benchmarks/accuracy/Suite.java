package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;

/** All scenes. */
public final class Suite {
  private Suite() {}

  /** The scenes that every engine can run. */
  public static List<Scene> common() {
    List<Scene> scenes = new ArrayList<>();
    scenes.addAll(FlightScenes.all());
    scenes.addAll(ImpactScenes.all());
    scenes.addAll(SlidingScenes.all());
    scenes.addAll(JointScenes.all());
    scenes.addAll(ChainScenes.all());
    scenes.addAll(StackScenes.all());
    scenes.addAll(ExtremeScenes.all());
    return scenes;
  }

  /**
   * The scene of a name.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Scene of(String name) {
    for (Scene scene : common()) {
      if (scene.name().equals(name)) {
        return scene;
      }
    }
    throw new IllegalArgumentException("no scene is called " + name);
  }
}
