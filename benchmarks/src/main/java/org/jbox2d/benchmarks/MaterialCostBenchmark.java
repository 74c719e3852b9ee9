package org.jbox2d.benchmarks;

import java.util.concurrent.TimeUnit;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.materials.Uniform;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What fracture costs a world in which nothing breaks: a wall of 400 boxes that falls, in a world
 * without a fracture system, with one, and with one and a material on each box.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 10, time = 1)
@Fork(2)
public class MaterialCostBenchmark {
  private static final int STEPS = 120;
  private static final int ROWS = 20;

  /** What the world has of fracture. */
  @Param({"none", "system", "materials"})
  public String fracture;

  private World world;

  /** Builds the wall. */
  @Setup(Level.Invocation)
  public void build() {
    world = new World(new Vec2(0f, -9.81f));
    if (!fracture.equals("none")) {
      FractureSystem.of(world).setListener((material, intensity, pieces) -> {});
    }
    Material hard = null;
    if (fracture.equals("materials")) {
      hard = new Uniform();
      hard.m_rigidity = Float.POSITIVE_INFINITY;
    }
    box(BodyType.STATIC, 0f, -1f, 40f, 1f, null);
    for (int i = 0; i < ROWS * ROWS; i++) {
      box(
          BodyType.DYNAMIC,
          1.02f * (i % ROWS) + 0.3f * (i / ROWS),
          0.5f + i / ROWS,
          0.5f,
          0.5f,
          hard);
    }
  }

  private void box(BodyType type, float x, float y, float width, float height, Material material) {
    BodyDef def = new BodyDef();
    def.type = type;
    def.position.set(x, y);
    FixtureDef fixture = new FixtureDef();
    PolygonShape shape = new PolygonShape();
    shape.setAsBox(width, height);
    fixture.shape = shape;
    fixture.density = 1f;
    fixture.material = material;
    world.createBody(def).createFixture(fixture);
  }

  /** One step of the wall's fall. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public World step() {
    for (int i = 0; i < STEPS; i++) {
      world.step(1f / 60f, 8, 3);
    }
    return world;
  }
}
