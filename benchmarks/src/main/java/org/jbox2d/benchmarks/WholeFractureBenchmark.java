package org.jbox2d.benchmarks;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.testbed.scenes.Scenes;
import org.jbox2d.testbed.simulation.Simulation;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** A whole fracture, from the impact to the new bodies, and the steps that follow one. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class WholeFractureBenchmark {
  private static final int STEPS = 60;
  private static final int STEPS_TO_IMPACT = 600;
  private static final long SEED = 1;

  /** A box of uniform material in a world of its own. */
  @State(Scope.Thread)
  public static class Box {
    private final Vec2 place = new Vec2(-2f, 0f);
    private final Vec2 impulse = new Vec2(10_000f, 0f);
    private FractureSystem fractures;
    private Body body;

    /** Makes the box anew. */
    @Setup(Level.Invocation)
    public void build() {
      World world = new World(new Vec2(0f, -10f));
      fractures = FractureSystem.of(world);
      fractures.setSeed(SEED);
      BodyDef def = new BodyDef();
      def.type = BodyType.DYNAMIC;
      body = world.createBody(def);
      PolygonShape shape = new PolygonShape();
      shape.setAsBox(2f, 2f);
      FixtureDef fixture = new FixtureDef();
      fixture.shape = shape;
      fixture.density = 1f;
      fixture.material = Material.UNIFORM;
      body.createFixture(fixture);
    }
  }

  /** The main scene, just after its first fracture. */
  @State(Scope.Thread)
  public static class MainScene {
    private Simulation simulation;

    /** Runs a new scene up to the impact. */
    @Setup(Level.Invocation)
    public void build() {
      simulation = new Simulation(Scenes.named("main"), 60f, SEED);
      while (simulation.fractureCount() == 0) {
        if (simulation.steps() == STEPS_TO_IMPACT) {
          throw new IllegalStateException("nothing broke in " + STEPS_TO_IMPACT + " steps");
        }
        simulation.step();
      }
    }
  }

  /** Strikes the box, which breaks. */
  @Benchmark
  public List<Body> fracture(Box box) {
    List<Body> pieces = box.fractures.strike(box.body.getFixtureList(), box.place, box.impulse);
    if (pieces.isEmpty()) {
      throw new IllegalStateException("the box held");
    }
    return pieces;
  }

  /** A step of the main scene in the second after the impact. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public int stepOfMainSceneAfterImpact(MainScene scene) {
    for (int i = 0; i < STEPS; i++) {
      scene.simulation.step();
    }
    return scene.simulation.steps();
  }
}
