package org.jbox2d.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.benchmarks.engines.Contender;

/** All scenes. */
public final class Suite {
  private Suite() {}

  /** The scenes that every engine can run: those that engines are compared by. */
  public static List<Scene> common() {
    List<Scene> scenes = new ArrayList<>();
    scenes.addAll(FlightScenes.all());
    scenes.addAll(ImpactScenes.all());
    scenes.addAll(SlidingScenes.all());
    scenes.addAll(JointScenes.all());
    scenes.addAll(ChainScenes.all());
    scenes.addAll(StackScenes.all());
    scenes.addAll(ExtremeScenes.all());
    scenes.addAll(HarderScenes.all());
    return scenes;
  }

  /** The scenes with bodies that break, for this project's solvers. */
  public static List<Scene> fracture() {
    return FractureScenes.all();
  }

  /** Whether a solver can run a scene: peers do not break bodies. */
  static boolean canRun(Contender solver, Scene scene) {
    return solver.ours || !scene.name().startsWith("fracture_");
  }

  /**
   * The scene of a name.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Scene named(String name) {
    List<Scene> scenes = common();
    scenes.addAll(fracture());
    for (Scene scene : scenes) {
      if (scene.name().equals(name)) {
        return scene;
      }
    }
    throw new IllegalArgumentException("no scene is called " + name);
  }
}
