package org.jbox2d.benchmarks.scenes;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jbox2d.benchmarks.engines.Contender;
import org.jbox2d.benchmarks.engines.Setting;
import org.jbox2d.benchmarks.engines.Sim;

/** The scenes to measure, with the part of each that is measured. */
public enum SceneSpec {
  /** A pyramid of 5,050 boxes. */
  LARGE_PYRAMID("large_pyramid", 120, 200, sim -> Piles.pyramid(sim, 100)),
  /** 400 pyramids of 55 boxes. The original takes seconds a step. */
  MANY_PYRAMIDS("many_pyramids", 6, 8, Piles::manyPyramids),
  /** 2,000 random convex polygons of 4 to 7 vertices that have fallen into a box. */
  DEBRIS("debris", 240, 200, sim -> Piles.debris(sim, 2000)),
  /** 2,025 boxes in a turning drum. */
  TUMBLER("tumbler", 240, 200, Piles::tumbler),
  /** A heavy box hits 9,600 small ones, without gravity. */
  SMASH("smash", 30, 120, Piles::smash),
  /** A net of 10,000 discs and 19,800 joints. */
  JOINT_GRID("joint_grid", 60, 80, sim -> Jointed.jointGrid(sim, 100)),
  /** A motor stirs 6,075 small bodies in a ring. */
  SPINNER("spinner", 60, 60, Jointed::spinner),
  /** Dolls with limited hinges fall on steps: up to 11,000 bodies come and go. */
  RAIN("rain", 320, 80, Rain::new),
  /** 400 bullets against thin posts. */
  BULLET_HAIL("bullet_hail", 300, 400, BulletHail::new),
  /** Each frame a box is replaced by 60 small polygons, and old ones leave. */
  CREATE_DESTROY("create_destroy", 150, 200, CreateDestroy::new),
  /** 10,000 rays through 2,000 resting polygons, and no step. */
  RAYCAST("raycast", 100, 100, Rays::new),
  /** 5,000 boxes asleep. */
  SLEEPING("sleeping", 400, 400, Piles::sleeping);

  /** Name, as in results. */
  public final String label;

  /** Steps before the measurement: for the compiler, and for the scene to get under way. */
  public final int warmSteps;

  /** Steps that are measured. */
  public final int measuredSteps;

  private final Function<Sim, SteppedScene> builder;

  SceneSpec(String label, int warmSteps, int measuredSteps, Function<Sim, SteppedScene> builder) {
    this.label = label;
    this.warmSteps = warmSteps;
    this.measuredSteps = measuredSteps;
    this.builder = builder;
  }

  /** Builds the scene for a solver, with 8 velocity and 3 position iterations or 4 substeps. */
  public SteppedScene build(Contender solver) {
    return builder.apply(solver.open(Setting.STANDARD));
  }

  /**
   * The scene of a label.
   *
   * @throws IllegalArgumentException if there is none, naming those there are
   */
  public static SceneSpec of(String label) {
    List<String> labels = new ArrayList<>();
    for (SceneSpec spec : values()) {
      if (spec.label.equals(label)) {
        return spec;
      }
      labels.add(spec.label);
    }
    throw new IllegalArgumentException("no scene is called " + label + "; there are " + labels);
  }
}
