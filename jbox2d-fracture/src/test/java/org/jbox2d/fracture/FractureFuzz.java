package org.jbox2d.fracture;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;

/**
 * Runs random scenes and checks that nothing is lost, nothing overlaps when it is born, and the
 * world goes on. {@code main} runs as many as it is told, from a first seed on; a case is a pure
 * function of its seed.
 */
final class FractureFuzz {
  /** Mass is kept to this, relative: floats, summed over some hundred pieces. */
  private static final double MASS_TOLERANCE = 1e-4;

  /**
   * Cores of pieces may overlap by this share of the extent of what broke, or by what the engine
   * leaves between any two bodies in contact.
   */
  private static final double OVERLAP_TOLERANCE = 1e-3;

  private static final int STEPS = 30;
  private static final int STEPS_AFTER = 30;

  /** Fractures stop at so many bodies: some scenes would grind for minutes otherwise. */
  private static final int BODIES = 100;

  /** Cases between two lines of {@code main}. */
  private static final int REPORT_EVERY = 100;

  int cases;
  long fractures;
  long bodies;
  double deepestOverlap;

  /** Reasons of failures, and how often, with the first seed. */
  final Map<String, String> failures = new TreeMap<>();

  /** What must not be: one line each, with its seed. */
  final List<String> violations = new ArrayList<>();

  private int failureCount;

  /** Runs as many cases as the first argument says, with seeds from the second on. */
  public static void main(String[] arguments) {
    int cases = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 10_000;
    long first = arguments.length > 1 ? Long.parseLong(arguments[1]) : 0;
    FractureFuzz fuzz = new FractureFuzz();
    long start = System.nanoTime();
    int told = 0;
    for (int done = 0; done < cases; done += REPORT_EVERY) {
      fuzz.run(first + done, Math.min(REPORT_EVERY, cases - done));
      System.out.println(fuzz);
      fuzz.violations.subList(told, fuzz.violations.size()).forEach(System.out::println);
      told = fuzz.violations.size();
    }
    System.out.printf("%s in %.0f s%n", fuzz, (System.nanoTime() - start) * 1e-9);
    fuzz.failures.forEach(
        (reason, where) -> System.out.println("failure " + where + ": " + reason));
    if (!fuzz.violations.isEmpty()) {
      System.exit(1);
    }
  }

  /** Runs the cases of the seeds from {@code first} on. */
  void run(long first, int count) {
    for (long seed = first; seed < first + count; seed++) {
      cases++;
      try {
        runCase(seed);
      } catch (RuntimeException | AssertionError e) {
        StackTraceElement[] at = e.getStackTrace();
        violations.add("seed " + seed + ": " + e + (at.length > 0 ? " at " + at[0] : ""));
      }
    }
  }

  int failureCount() {
    return failureCount;
  }

  private void runCase(long seed) {
    FuzzScene scene = new FuzzScene(seed);
    World world = scene.world;
    FractureSystem system = FractureSystem.of(world);
    system.setSeed(seed);
    system.setBodyLimit(BODIES);
    system.setListener(new Witness(seed));
    double material = Totals.of(world).material;
    for (int i = 0; i < STEPS + STEPS_AFTER; i++) {
      if (i < STEPS) {
        scene.disturb(i);
      }
      world.step(scene.dt, 8, 3);
      checkFinite(world, seed, i);
    }
    double left = Totals.of(world).material;
    if (!(Math.abs(left - material) <= MASS_TOLERANCE * material)) {
      violations.add("seed " + seed + ": mass " + material + " became " + left);
    }
    bodies += world.getBodyCount();
    checkUsable(world, seed);
    fractures += system.getFractureCount();
    failureCount += system.getFailureCount();
  }

  private void checkFinite(World world, long seed, int step) {
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      float sum =
          b.getPosition().x
              + b.getPosition().y
              + b.getAngle()
              + b.getLinearVelocity().x
              + b.getLinearVelocity().y
              + b.getAngularVelocity()
              + b.getMass();
      if (!Float.isFinite(sum)) {
        throw new AssertionError("a body is not finite after step " + step);
      }
      if (b.getType() == BodyType.DYNAMIC && b.getFixtureList() != null && !(b.getMass() > 0f)) {
        throw new AssertionError("a dynamic body has mass " + b.getMass() + " after step " + step);
      }
    }
  }

  /** A new body falls, everything can be destroyed, and the step still runs. */
  private void checkUsable(World world, long seed) {
    Body added = Range.disc(world, 0f, 500f, 0.5f, 1f, 0f, -1f);
    world.step(1f / 60f, 8, 3);
    if (!(added.getPosition().y < 500f)) {
      violations.add("seed " + seed + ": a new body does not move");
    }
    while (world.getBodyList() != null) {
      world.destroyBody(world.getBodyList());
    }
    world.step(1f / 60f, 8, 3);
    if (world.getBodyCount() != 0 || world.getContactCount() != 0 || world.getJointCount() != 0) {
      violations.add("seed " + seed + ": the emptied world is not empty");
    }
  }

  @Override
  public String toString() {
    return String.format(
        "%d cases, %d fractures, %d bodies at the end, %d failures, %d violations, deepest overlap"
            + " %.1e m",
        cases, fractures, bodies, failureCount, violations.size(), deepestOverlap);
  }

  /** Looks at pieces when they are born, and notes failures. */
  private final class Witness implements FractureListener {
    private final long seed;

    Witness(long seed) {
      this.seed = seed;
    }

    @Override
    public void action(Material material, float intensity, List<Body> fragments) {
      double overlap = Overlap.deepest(fragments);
      double extent = extentOf(fragments);
      deepestOverlap = Math.max(deepestOverlap, overlap);
      if (overlap > Math.max(OVERLAP_TOLERANCE * extent, Settings.linearSlop)) {
        violations.add("seed " + seed + ": pieces of " + extent + " m overlap by " + overlap);
      }
    }

    @Override
    public void failed(FractureFailure failure) {
      String reason = failure.reason().replaceAll("[-0-9.E]{3,}", "#");
      failures.merge(reason, "seed " + seed, (a, b) -> a.length() > 200 ? a : a + ", " + seed);
    }

    private double extentOf(List<Body> fragments) {
      double minX = Double.POSITIVE_INFINITY;
      double maxX = Double.NEGATIVE_INFINITY;
      double minY = Double.POSITIVE_INFINITY;
      double maxY = Double.NEGATIVE_INFINITY;
      for (Body b : fragments) {
        for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
          Vec2 lower = f.getAABB(0).lowerBound;
          Vec2 upper = f.getAABB(0).upperBound;
          minX = Math.min(minX, lower.x);
          maxX = Math.max(maxX, upper.x);
          minY = Math.min(minY, lower.y);
          maxY = Math.max(maxY, upper.y);
        }
      }
      return Math.max(maxX - minX, maxY - minY);
    }
  }
}
