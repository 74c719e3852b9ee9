package org.jbox2d.testbed.scenes;

import java.util.List;
import java.util.function.Consumer;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;

/**
 * A scene: a name, what it shows, and how to build it. A scene holds no state of a run: the same
 * scene may be built into any number of worlds, and each build gives the same world.
 */
public final class Scene {
  /** Gravity of every scene, m/s^2, downwards. */
  public static final float GRAVITY = 9.81f;

  /** Steps per second of a scene that does not say otherwise. */
  public static final float DEFAULT_HZ = 60f;

  /** Iterations of the velocity solver in a step. */
  public static final int VELOCITY_ITERATIONS = 8;

  /** Iterations of the position solver in a step. */
  public static final int POSITION_ITERATIONS = 8;

  private final String name;
  private final String title;
  private final String shows;
  private final Builder builder;
  private final List<Parameter> parameters;
  private final float hz;
  private final Framing framing;

  private Scene(
      String name,
      String title,
      String shows,
      Builder builder,
      List<Parameter> parameters,
      float hz,
      Framing framing) {
    this.name = name;
    this.title = title;
    this.shows = shows;
    this.builder = builder;
    this.parameters = parameters;
    this.hz = hz;
    this.framing = framing;
  }

  /**
   * A scene at {@link #DEFAULT_HZ} that frames the whole box.
   *
   * @param name lower case, words joined by a hyphen
   * @param title a few words, for a list
   * @param shows one sentence on what is to be seen
   * @param builder fills an empty world, the same way each time
   */
  static Scene of(String name, String title, String shows, Consumer<World> builder) {
    Builder still =
        (world, values) -> {
          builder.accept(world);
          return Script.NONE;
        };
    return of(name, title, shows, still);
  }

  /** A scene that has parameters or a script; see {@link #of(String, String, String, Consumer)}. */
  static Scene of(
      String name, String title, String shows, Builder builder, Parameter... parameters) {
    return new Scene(name, title, shows, builder, List.of(parameters), DEFAULT_HZ, Framing.BOX);
  }

  /** Returns this scene with another number of steps per second. */
  Scene at(float stepsPerSecond) {
    return new Scene(name, title, shows, builder, parameters, stepsPerSecond, framing);
  }

  /** Returns this scene seen otherwise: centre and extent, m. */
  Scene seen(float centreX, float centreY, float width, float height) {
    Framing seen = new Framing(centreX, centreY, width, height);
    return new Scene(name, title, shows, builder, parameters, hz, seen);
  }

  /** Returns an empty world for a scene. */
  public static World emptyWorld() {
    return new World(new Vec2(0f, -GRAVITY));
  }

  /**
   * Builds the scene into a new world, without its script.
   *
   * @param seed seed of the world's fractures
   */
  public World newWorld(long seed) {
    World world = emptyWorld();
    FractureSystem.of(world).setSeed(seed);
    build(world, Values.NONE);
    return world;
  }

  /** Fills an empty world. Returns what is to act on it. */
  public Script build(World world, Values values) {
    return builder.build(world, values);
  }

  /** Returns the parameters by which it is built; those that all scenes have are not among them. */
  public List<Parameter> parameters() {
    return parameters;
  }

  /** Returns the name by which the scene is looked up. */
  public String name() {
    return name;
  }

  /** Returns a few words for a list. */
  public String title() {
    return title;
  }

  /** Returns a sentence on what is to be seen. */
  public String shows() {
    return shows;
  }

  /** Returns the steps per second that the scene is meant for. */
  public float hz() {
    return hz;
  }

  /** Returns the part of the world to look at. */
  public Framing framing() {
    return framing;
  }

  @Override
  public String toString() {
    return title;
  }

  /** Fills an empty world, the same way each time for the same values. */
  @FunctionalInterface
  interface Builder {
    /** Fills it. Returns what is to act on it. */
    Script build(World world, Values values);
  }

  /**
   * A part of the world to look at.
   *
   * @param centreX world coordinate of the middle, m
   * @param centreY see {@code centreX}
   * @param width extent that must be visible, m
   * @param height see {@code width}
   */
  public record Framing(float centreX, float centreY, float width, float height) {
    /** The lower half of the static box, where things happen. */
    static final Framing BOX = new Framing(0f, 17f, 84f, 46f);
  }
}
