package org.jbox2d.testbed.simulation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureEvent;
import org.jbox2d.fracture.FractureFailure;
import org.jbox2d.fracture.FractureListener;
import org.jbox2d.fracture.FractureProposal;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.parameters.Parameter;
import org.jbox2d.testbed.parameters.Values;
import org.jbox2d.testbed.scenes.Scene;
import org.jbox2d.testbed.scenes.Script;

/**
 * A run of a scene: its world, stepped at a fixed rate, and all that is done to it. Used by one
 * thread at a time.
 */
public final class Simulation {
  private static final double NANOS_PER_MILLI = 1e6;

  private final Setup setup;
  private final World world;
  private final Script script;
  private final FractureSystem fractures;
  private final MassBalance massBalance;
  private final Map<String, Knob> knobs = new LinkedHashMap<>();
  private final Interaction interaction;
  private final List<TimedInput> inputs = new ArrayList<>();
  private FractureListener listener;
  private FractureTrace lastFracture;
  private Values values = Values.NONE;
  private int materialKind;
  private float hz;
  private int velocityIterations = Scene.VELOCITY_ITERATIONS;
  private int positionIterations = Scene.POSITION_ITERATIONS;
  private int steps;
  private boolean prepared;

  /** Time and steps when the rate last changed. */
  private double timeOfRate;

  private int stepsOfRate;
  private double stepMillis;

  /**
   * Builds a scene with the defaults of its parameters.
   *
   * @param hz steps per second, positive
   * @param seed seed of the fractures
   */
  public Simulation(Scene scene, float hz, long seed) {
    this(new Setup(scene, hz, seed, Values.NONE));
  }

  /**
   * Builds a scene.
   *
   * @throws IllegalArgumentException if there is no such parameter, or its value is not allowed
   */
  public Simulation(Setup setup) {
    this.setup = setup;
    hz = setup.hz();
    world = Scene.emptyWorld();
    fractures = FractureSystem.of(world);
    fractures.setSeed(setup.seed());
    for (Parameter parameter : setup.scene().parameters()) {
      parameter.checked(setup.values().get(parameter));
    }
    script = setup.scene().build(world, setup.values());
    massBalance = new MassBalance(world);
    fractures.setListener(new Listener());
    interaction = new Interaction(this);
    for (Knob knob : Knobs.of(this)) {
      knobs.put(knob.parameter.name(), knob);
    }
    setup.values().set().forEach(this::begin);
  }

  /** Takes a value of the setup; those of the scene have been built in. */
  private void begin(String name, double value) {
    if (isOfScene(name)) {
      values = values.with(name, value);
    } else {
      turn(name, value);
    }
  }

  /**
   * Builds a run again and does again what was done to it.
   *
   * @param inputs what was done, in order
   * @param steps how many steps to do; inputs after the last of them are done too, later ones not
   * @param afterEach hears of the run before the first step, after each, and after each input
   */
  public static Simulation repeat(
      Setup setup, List<TimedInput> inputs, int steps, Consumer<Simulation> afterEach) {
    Simulation run = new Simulation(setup);
    int next = 0;
    for (int i = 0; i <= steps; i++) {
      if (i > 0) {
        run.step();
      }
      afterEach.accept(run);
      while (next < inputs.size() && inputs.get(next).step() == i) {
        run.apply(inputs.get(next++).input());
        afterEach.accept(run);
      }
    }
    return run;
  }

  // --- What is done to it

  /** Does one step. */
  public void step() {
    long start = System.nanoTime();
    prepare();
    world.step(1f / hz, velocityIterations, positionIterations);
    stepMillis = (System.nanoTime() - start) / NANOS_PER_MILLI;
    steps++;
    prepared = false;
  }

  /** Lets the scene's script act before the next step, if it has not yet. */
  public void prepare() {
    if (!prepared) {
      prepared = true;
      script.before(steps);
    }
  }

  /**
   * Does what a user wants done, and remembers it.
   *
   * @throws IllegalArgumentException if a parameter can't be set; see {@link #isOfScene}
   */
  public void apply(Input input) {
    if (input.action() == Input.Action.SET) {
      turn(input.parameter(), input.number(0));
    } else {
      interaction.act(input);
    }
    inputs.add(new TimedInput(steps, input));
  }

  private void turn(String name, double value) {
    Knob knob = knobs.get(name);
    if (knob == null) {
      throw new IllegalArgumentException(
          isOfScene(name)
              ? name + " is of how the scene is built; it can't be changed later"
              : unknown(name));
    }
    knob.turn(this, knob.parameter.checked(value));
    values = values.with(name, value);
  }

  /** Returns whether a parameter is of how the scene is built, so that it can't be set later. */
  public boolean isOfScene(String name) {
    return setup.scene().parameters().stream().anyMatch(p -> p.name().equals(name));
  }

  private String unknown(String name) {
    StringBuilder known = new StringBuilder();
    for (Parameter parameter : parameters()) {
      known.append(known.length() == 0 ? "" : ", ").append(parameter.name());
    }
    return "unknown parameter '" + name + "'; " + setup.scene().name() + " has: " + known;
  }

  void setHz(float stepsPerSecond) {
    timeOfRate = time();
    stepsOfRate = steps;
    hz = stepsPerSecond;
  }

  void setVelocityIterations(int iterations) {
    velocityIterations = iterations;
  }

  void setPositionIterations(int iterations) {
    positionIterations = iterations;
  }

  void setMaterialKind(double kind) {
    materialKind = (int) kind;
  }

  /** Sets who else hears of fractures; may be {@code null}. */
  public void setFractureListener(FractureListener listener) {
    this.listener = listener;
  }

  // --- What it is made of

  /** Returns what it began with. */
  public Setup setup() {
    return setup;
  }

  /** Returns a setup to begin anew with the rate and the values of now. */
  public Setup setupNow() {
    return new Setup(setup.scene(), hz, setup.seed(), values);
  }

  /** Returns all that has been done to it, in order; not to be changed. */
  public List<TimedInput> inputs() {
    return Collections.unmodifiableList(inputs);
  }

  /** Returns the parameters, those of the scene first. */
  public List<Parameter> parameters() {
    List<Parameter> all = new ArrayList<>(setup.scene().parameters());
    for (Knob knob : knobs.values()) {
      all.add(knob.parameter);
    }
    return all;
  }

  /**
   * Returns the parameter of a name.
   *
   * @throws IllegalArgumentException if there is none, naming those there are
   */
  public Parameter parameter(String name) {
    for (Parameter parameter : parameters()) {
      if (parameter.name().equals(name)) {
        return parameter;
      }
    }
    throw new IllegalArgumentException(unknown(name));
  }

  /** Returns the value of a parameter now. */
  public double value(Parameter parameter) {
    return values.get(parameter);
  }

  /** Returns the scene. */
  public Scene scene() {
    return setup.scene();
  }

  /** Returns the steps per second now. */
  public float hz() {
    return hz;
  }

  /** Returns the seed of the fractures. */
  public long seed() {
    return setup.seed();
  }

  /** Returns the world. */
  public World world() {
    return world;
  }

  /** Returns the number of steps done. */
  public int steps() {
    return steps;
  }

  /** Returns the simulated time, s. */
  public double time() {
    return timeOfRate + (double) (steps - stepsOfRate) / hz;
  }

  /** Returns how long the last step took, fractures and all, ms. */
  public double stepMillis() {
    return stepMillis;
  }

  /** Returns how long the last step took, phase by phase. */
  public Phases phases() {
    return Phases.of(world.getProfile(), stepMillis);
  }

  /** Returns the numbers of now. */
  public Snapshot.Counts counts() {
    return new Snapshot.Counts(
        scene().name(),
        steps,
        time(),
        world.getBodyCount(),
        fixtureCount(),
        world.getContactCount(),
        0,
        fractureCount(),
        Totals.of(world),
        phases());
  }

  /** Returns the number of fractures so far. */
  public int fractureCount() {
    return fractures.getFractureCount();
  }

  /** Returns the number of fractures that were given up because a check of theirs failed. */
  public int fractureFailures() {
    return fractures.getFailureCount();
  }

  /** Returns the mass of what can break, now and at the start. */
  public MassBalance massBalance() {
    return massBalance;
  }

  /** Returns the number of fixtures. */
  public int fixtureCount() {
    int count = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      count += b.m_fixtureCount;
    }
    return count;
  }

  /** Returns a hash of the state; see {@link StateHash}. */
  public long hash() {
    return StateHash.of(world);
  }

  /** Returns what the last fracture was made by; {@code null} before there is one. */
  public FractureTrace lastFracture() {
    return lastFracture;
  }

  /** Breaks things by the material that the user has chosen, and remembers the last fracture. */
  private final class Listener implements FractureListener {
    @Override
    public boolean allow(FractureProposal proposal) {
      if (proposal.material() != null && materialKind > 0) {
        proposal.setMaterial(MaterialKind.of(materialKind, proposal.material()));
      }
      return listener == null || listener.allow(proposal);
    }

    @Override
    public void action(Material material, float intensity, List<Body> fragments) {
      if (listener != null) {
        listener.action(material, intensity, fragments);
      }
    }

    @Override
    public void fractured(FractureEvent event) {
      FractureTrace trace = FractureTrace.of(event);
      lastFracture = trace == null ? lastFracture : trace;
      if (listener != null) {
        listener.fractured(event);
      }
    }

    @Override
    public void failed(FractureFailure failure) {
      if (listener != null) {
        listener.failed(failure);
      }
    }
  }
}
