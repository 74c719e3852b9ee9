package org.jbox2d.benchmarks.peers;

import org.jbox2d.benchmarks.SceneFactory;
import org.jbox2d.benchmarks.SteppedScene;
import org.jbox2d.benchmarks.scenes.Catalogue;

/** The engines that are compared. */
public enum Engine {
  /** This project's. */
  OURS("ours") {
    @Override
    SceneFactory open() {
      return new Catalogue();
    }
  },
  /** JBox2D 2.2.1.1 as released, in its own class loader. */
  JBOX2D("jbox2d-2.2.1.1") {
    @Override
    SceneFactory open() {
      ClassLoader loader = new OriginalLoader(Engine.class.getClassLoader());
      try {
        Class<?> type = Class.forName(CATALOGUE, true, loader);
        return (SceneFactory) type.getDeclaredConstructor().newInstance();
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException("the original engine does not load", e);
      }
    }
  },
  /** dyn4j, for scenes that consist of bodies alone. */
  DYN4J("dyn4j") {
    @Override
    SceneFactory open() {
      return new Dyn4jFactory();
    }
  };

  private static final String CATALOGUE = "org.jbox2d.benchmarks.scenes.Catalogue";

  /** Name, as in results. */
  public final String label;

  private SceneFactory factory;

  Engine(String label) {
    this.label = label;
  }

  abstract SceneFactory open();

  /** Builds a scene in this engine. */
  public SteppedScene build(String scene) {
    if (factory == null) {
      factory = open();
    }
    return factory.build(scene);
  }

  /**
   * The engine of a label.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Engine of(String label) {
    for (Engine engine : values()) {
      if (engine.label.equals(label)) {
        return engine;
      }
    }
    throw new IllegalArgumentException("no engine is called " + label);
  }
}
