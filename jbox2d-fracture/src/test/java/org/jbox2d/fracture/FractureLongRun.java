package org.jbox2d.fracture;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.World;

/**
 * Rain on breakable boxes for as many steps as the first argument says, 100,000 if none: prints,
 * ten times, the heap in use after a collection and the mean processor time of a step. Both must
 * stay flat. The fracture system keeps a budget of debris; of what rains, the oldest go.
 */
final class FractureLongRun {
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final int LINES = 10;
  private static final int BUDGET = 150;
  private static final int RAIN = 60;
  private static final float DT = 1f / 60f;

  private final World world = new World(new Vec2(0f, -9.81f));
  private final SiteRandom random = new SiteRandom(1);
  private final Deque<Body> rain = new ArrayDeque<>();

  private FractureLongRun() {
    Body floor = Range.body(world, BodyType.STATIC, 0f, -1f);
    Range.fixture(floor, Range.box(30f, 1f), 0f, null);
    FractureSystem.of(world).setDebrisBudget(BUDGET);
  }

  /** Runs. */
  public static void main(String[] arguments) {
    int steps = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 100_000;
    FractureLongRun run = new FractureLongRun();
    System.out.println("steps, fractures, failures, bodies, heap kB, CPU ms a step");
    for (int line = 1; line <= LINES; line++) {
      long start = THREADS.getCurrentThreadCpuTime();
      for (int i = 0; i < steps / LINES; i++) {
        run.step((line - 1) * (steps / LINES) + i);
      }
      double ms = (THREADS.getCurrentThreadCpuTime() - start) * 1e-6 / (steps / LINES);
      run.report(line * (steps / LINES), ms);
    }
  }

  private void step(int number) {
    if (number % 20 == 0) {
      Body drop = Range.disc(world, 40f * random.centred(), 25f, 0.4f, 4f, 0f, -30f);
      rain.add(drop);
    }
    if (number % 120 == 0) {
      Body box = Range.body(world, BodyType.DYNAMIC, 36f * random.centred(), 6f);
      Range.fixture(box, Range.box(1.5f, 1.5f), 1f, Range.uniform(15f, 2f));
      rain.add(box);
    }
    while (rain.size() > RAIN) {
      Body oldest = rain.remove();
      if (oldest.getWorld() == world) {
        world.destroyBody(oldest);
      }
    }
    world.step(DT, 8, 3);
  }

  private void report(int steps, double ms) {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    FractureSystem system = FractureSystem.of(world);
    System.out.printf(
        "%d, %d, %d, %d, %d, %.3f%n",
        steps,
        system.getFractureCount(),
        system.getFailureCount(),
        world.getBodyCount(),
        (runtime.totalMemory() - runtime.freeMemory()) / 1024,
        ms);
  }
}
