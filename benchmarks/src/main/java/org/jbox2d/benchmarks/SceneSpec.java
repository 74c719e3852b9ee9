package org.jbox2d.benchmarks;

import java.util.ArrayList;
import java.util.List;

/**
 * The scenes to measure, with the part of each that is measured. Those with a name of the Box2D 3
 * benchmark program have its layout and numbers of bodies.
 */
public enum SceneSpec {
  /** A pyramid of 5,050 boxes. */
  LARGE_PYRAMID("large_pyramid", 120, 200, true),
  /** 400 pyramids of 55 boxes. The original takes seconds a step. */
  MANY_PYRAMIDS("many_pyramids", 6, 8, true),
  /** 2,000 random convex polygons of 4 to 7 vertices that have fallen into a box. */
  DEBRIS("debris", 240, 200, true),
  /** 2,025 boxes in a turning drum. */
  TUMBLER("tumbler", 240, 200, true),
  /** A heavy box hits 9,600 small ones, without gravity. */
  SMASH("smash", 30, 120, true),
  /** A net of 10,000 discs and 19,800 joints. */
  JOINT_GRID("joint_grid", 60, 80, false),
  /** A motor stirs 6,075 small bodies in a ring. */
  SPINNER("spinner", 60, 60, false),
  /** 400 bullets against thin posts. */
  BULLET_HAIL("bullet_hail", 300, 400, false),
  /** Each frame a box is replaced by 60 small polygons, and old ones leave. */
  CREATE_DESTROY("create_destroy", 150, 200, false),
  /** 10,000 rays through 2,000 resting polygons, and no step. */
  RAYCAST("raycast", 100, 100, false),
  /** 5,000 boxes asleep. */
  SLEEPING("sleeping", 400, 400, true);

  /** Name, as in results. */
  public final String label;

  /** Steps before the measurement: for the compiler, and for the scene to get under way. */
  public final int warmSteps;

  /** Steps that are measured. */
  public final int measuredSteps;

  /** Whether the scene is polygons in a world and nothing else, so that any engine can copy it. */
  public final boolean bodiesAlone;

  SceneSpec(String label, int warmSteps, int measuredSteps, boolean bodiesAlone) {
    this.label = label;
    this.warmSteps = warmSteps;
    this.measuredSteps = measuredSteps;
    this.bodiesAlone = bodiesAlone;
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
