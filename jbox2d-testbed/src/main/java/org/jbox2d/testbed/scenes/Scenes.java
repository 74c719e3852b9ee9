package org.jbox2d.testbed.scenes;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;

/** All scenes, in the order of lists: those of the thesis, those that break, the classics. */
public final class Scenes {
  /** Inner half-width of the static box that is around each scene, m; its middle is at x = 0. */
  public static final float BOX_HALF_WIDTH = 39f;

  /** Height of the box's walls over its floor at y = 0, m; there is its lid. */
  public static final float BOX_HEIGHT = 70f;

  private static final List<Scene> ALL = collect();

  private Scenes() {}

  private static List<Scene> collect() {
    List<Scene> scenes = new ArrayList<>(ThesisScenes.all());
    scenes.addAll(BreakingScenes.all());
    scenes.addAll(DisasterScenes.all());
    scenes.addAll(ClassicScenes.all());
    scenes.addAll(MachineScenes.all());
    return Collections.unmodifiableList(scenes);
  }

  /** Returns all scenes. */
  public static List<Scene> all() {
    return ALL;
  }

  /** Returns the scene that a run starts with if none is asked for. */
  public static Scene first() {
    return ALL.get(0);
  }

  /**
   * Returns the scene of a name.
   *
   * @throws IllegalArgumentException if there is none; the message names it, and those there are
   */
  public static Scene named(String name) {
    for (Scene scene : ALL) {
      if (scene.name().equals(name)) {
        return scene;
      }
    }
    throw new IllegalArgumentException("unknown scene '" + name + "'; there are: " + names());
  }

  /** Returns the names of all scenes, in order, with commas between. */
  public static String names() {
    return ALL.stream().map(Scene::name).collect(Collectors.joining(", "));
  }
}
