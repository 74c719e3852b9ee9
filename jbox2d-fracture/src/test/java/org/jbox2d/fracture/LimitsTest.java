package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Bricks;
import org.jbox2d.fracture.materials.Diffusion;
import org.jbox2d.fracture.materials.Glass;
import org.jbox2d.fracture.materials.Radial;
import org.jbox2d.fracture.materials.Splinters;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.api.Test;

/** What a game may limit: that it is held, what it costs, and that somebody hears of it. */
class LimitsTest {
  /** Keeps all that a listener hears. */
  private static final class Log implements FractureListener {
    final List<FractureEvent> events = new ArrayList<>();
    final List<FractureLimit> limits = new ArrayList<>();
    final List<Body> discarded = new ArrayList<>();
    final List<FractureLimit> discardLimits = new ArrayList<>();
    boolean discards = true;

    @Override
    public void action(Material material, float intensity, List<Body> fragments) {}

    @Override
    public void fractured(FractureEvent event) {
      events.add(event);
    }

    @Override
    public void limited(FractureProposal proposal, FractureLimit limit) {
      limits.add(limit);
    }

    @Override
    public boolean discard(Body debris, FractureLimit limit) {
      discarded.add(debris);
      discardLimits.add(limit);
      return discards;
    }
  }

  private static Log listen(World world) {
    Log log = new Log();
    FractureSystem.of(world).setListener(log);
    return log;
  }

  private static World target(Material material) {
    World world = new World(new Vec2());
    Body wall = Range.body(world, BodyType.DYNAMIC, 0f, 0f);
    Range.fixture(wall, Range.box(3f, 3f), 1f, material);
    return world;
  }

  private static List<Body> strike(World world) {
    Fixture fixture = world.getBodyList().getFixtureList();
    return FractureSystem.of(world).strike(fixture, new Vec2(-3f, 0.2f), new Vec2(500f, 0f));
  }

  private static Material wide(Material material) {
    material.m_rigidity = 10f;
    material.m_shattering = 1f;
    material.m_radius = 4f;
    return material;
  }

  @Test
  void piecesOfAFractureAreMerged() {
    Material[] kinds = {
      new Uniform(), new Diffusion(), new Glass(), new Radial(), new Splinters(), new Bricks()
    };
    for (Material kind : kinds) {
      int free = strike(target(wide(kind))).size();
      double brokenAway = 0;
      for (int limit : new int[] {1000, 12, 5, 2}) {
        World world = target(wide(kind));
        FractureSystem.of(world).setPiecesPerFracture(limit);
        Log log = listen(world);
        double mass = Totals.of(world).mass;
        List<Body> pieces = strike(world);
        String what = kind.getClass().getSimpleName() + " into " + limit;
        if (pieces.isEmpty()) {
          // What breaks away lies in two places, or leaves two behind.
          assertTrue(limit == 2, what);
          assertEquals(List.of(FractureLimit.PIECES_PER_FRACTURE), log.limits, what);
          continue;
        }
        assertTrue(pieces.size() >= 2 && pieces.size() <= limit, what + ": " + pieces.size());
        assertEquals(mass, Totals.of(world).mass, 1e-5 * mass, what);
        FractureLimit expected = free > limit ? FractureLimit.PIECES_PER_FRACTURE : null;
        assertSame(expected, log.events.get(0).limit(), what);
        // The same region breaks, only more coarsely.
        double splinters = massOf(log.events.get(0).splinters());
        brokenAway = brokenAway == 0 ? splinters : brokenAway;
        assertEquals(brokenAway, splinters, 1e-4 * mass, what);
      }
    }
  }

  private static double massOf(List<Body> bodies) {
    double sum = 0;
    for (Body b : bodies) {
      sum += b.getMass();
    }
    return sum;
  }

  @Test
  void piecesOfAConcaveBodyAreMerged() {
    Vec2[] comb = {
      new Vec2(-4f, -3f),
      new Vec2(4f, -3f),
      new Vec2(4f, 3f),
      new Vec2(3f, 3f),
      new Vec2(3f, -2f),
      new Vec2(1f, -2f),
      new Vec2(1f, 3f),
      new Vec2(-1f, 3f),
      new Vec2(-1f, -2f),
      new Vec2(-3f, -2f),
      new Vec2(-3f, 3f),
      new Vec2(-4f, 3f)
    };
    for (int limit = 4; limit < 20; limit += 3) {
      World world = new World(new Vec2());
      FixtureDef def = new FixtureDef();
      def.density = 1f;
      def.material = wide(new Uniform());
      Body body = Range.body(world, BodyType.DYNAMIC, 0f, 0f);
      List<Fixture> parts = body.createFixture(def, new PolygonFixture(comb));
      FractureSystem system = FractureSystem.of(world);
      system.setPiecesPerFracture(limit);
      double mass = body.getMass();
      List<Body> pieces = system.strike(parts.get(0), new Vec2(0f, -3f), new Vec2(0f, 500f));
      assertTrue(pieces.size() >= 2 && pieces.size() <= limit, limit + ": " + pieces.size());
      assertEquals(mass, massOf(pieces), 1e-5 * mass);
    }
  }

  @Test
  void whatDoesNotBreakIsTold() {
    World world = target(wide(new Uniform()));
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    system.setBodyLimit(1);
    assertTrue(strike(world).isEmpty());
    system.setBodyLimit(3);
    assertTrue(strike(world).isEmpty());
    system.setBodyLimit(Integer.MAX_VALUE);
    system.setFracturesPerStep(0);
    assertTrue(strike(world).isEmpty());
    assertEquals(
        List.of(FractureLimit.BODIES, FractureLimit.BODIES, FractureLimit.FRACTURES_PER_STEP),
        log.limits);
    assertEquals(3, system.getLimitedCount());
    assertTrue(log.events.isEmpty());
  }

  @Test
  void tooSmallToBreakIsTold() {
    World world = target(wide(new Uniform()));
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    system.setMinimumArea(3.6f);
    List<Body> pieces = strike(world);
    assertNull(log.events.get(0).limit());
    Body smallest = pieces.get(0);
    for (Body b : pieces) {
      smallest = b.getMass() < smallest.getMass() ? b : smallest;
    }
    Vec2 at = smallest.getWorldCenter().clone();
    assertTrue(system.strike(smallest.getFixtureList(), at, new Vec2(500f, 0f)).isEmpty());
    assertEquals(List.of(FractureLimit.MINIMUM_AREA), log.limits);
  }

  /** Boxes that fall on a floor and break. */
  private static World rain() {
    World world = new World(new Vec2(0f, -9.81f));
    Body floor = Range.body(world, BodyType.STATIC, 0f, -1f);
    Range.fixture(floor, Range.box(30f, 1f), 0f, null);
    for (int i = 0; i < 5; i++) {
      Body box = Range.body(world, BodyType.DYNAMIC, 6f * i - 12f, 3f + i);
      box.setLinearVelocity(new Vec2(0f, -15f));
      Range.fixture(box, Range.box(1.5f, 1.5f), 1f, Range.uniform(15f, 2f));
    }
    return world;
  }

  @Test
  void debrisBeyondTheBudgetGoes() {
    World world = rain();
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    system.setDebrisBudget(20);
    for (int i = 0; i < 120; i++) {
      world.step(1f / 60f, 8, 3);
      assertTrue(debris(log) <= 20, debris(log) + " pieces after step " + i);
    }
    assertEquals(20, debris(log));
    assertTrue(log.discarded.size() > 20, log.discarded.size() + " discarded");
    assertEquals(log.discarded.size(), system.getDiscardedCount());
    for (FractureLimit limit : log.discardLimits) {
      assertSame(FractureLimit.DEBRIS_BUDGET, limit);
    }
  }

  /** Bodies in the world that have come off others. */
  private static int debris(Log log) {
    int count = 0;
    for (FractureEvent event : log.events) {
      List<Body> pieces = new ArrayList<>(event.remainders());
      pieces.addAll(event.splinters());
      for (Body b : pieces) {
        count += b != event.body() && b.getWorld() != null ? 1 : 0;
      }
    }
    return count;
  }

  @Test
  void smallDebrisGoesFirst() {
    World world = target(wide(new Uniform()));
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    system.setDebrisBudget(1000);
    strike(world);
    List<Body> splinters = new ArrayList<>(log.events.get(0).remainders());
    splinters.remove(log.events.get(0).body());
    splinters.addAll(log.events.get(0).splinters());
    int half = (splinters.size() + 1) / 2;
    system.setDebrisBudget(splinters.size() - 3);
    double[] area = new double[half];
    for (int i = 0; i < half; i++) {
      area[i] = splinters.get(i).getMass();
    }
    Arrays.sort(area);
    world.step(1f / 60f, 8, 3);
    assertEquals(3, log.discarded.size());
    for (int i = 0; i < 3; i++) {
      Body b = log.discarded.get(i);
      int place = splinters.indexOf(b);
      assertTrue(place < half, "piece " + place + " of " + splinters.size());
      // The density of a piece makes up for rounding, by some millionths.
      assertEquals(area[i], b.getMass(), 1e-4 * area[i]);
    }
    assertNull(log.discarded.get(0).getWorld());
    for (int i = half; i < splinters.size(); i++) {
      assertSame(world, splinters.get(i).getWorld());
    }
  }

  @Test
  void whatTheGameKeepsIsNoDebris() {
    World world = target(wide(new Uniform()));
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    log.discards = false;
    system.setDebrisBudget(2);
    int bodies = strike(world).size();
    Range.step(world, 60f, 0.2f);
    assertEquals(bodies, world.getBodyCount());
    assertEquals(0, system.getDiscardedCount());
    assertEquals(debris(log) - 2, log.discarded.size());
  }

  @Test
  void sleepingDebrisGoesAfterItsTime() {
    for (float hz : new float[] {30f, 120f}) {
      World world = rain();
      FractureSystem system = FractureSystem.of(world);
      Log log = listen(world);
      system.setDebrisLifetime(1.5f);
      Map<Body, Integer> asleep = new IdentityHashMap<>();
      for (int step = 0; log.discarded.isEmpty() && step < 40 * hz; step++) {
        world.step(1f / hz, 8, 3);
        for (FractureEvent event : log.events) {
          for (Body b : event.splinters()) {
            if (b.getWorld() == world) {
              asleep.merge(b, 1, (n, one) -> b.isAwake() ? 0 : n + one);
            }
          }
        }
      }
      assertFalse(log.discarded.isEmpty(), "nothing went");
      double slept = asleep.get(log.discarded.get(0)) / hz;
      assertEquals(1.5, slept, 2 / hz, "lifetime at " + hz + " Hz");
      assertSame(FractureLimit.DEBRIS_LIFETIME, log.discardLimits.get(0));
      assertTrue(world.getBodyCount() > 1, "what is awake stays");
    }
  }

  @Test
  void defaultsLimitNothing() {
    World world = rain();
    FractureSystem system = FractureSystem.of(world);
    Log log = listen(world);
    assertEquals(Integer.MAX_VALUE, system.getPiecesPerFracture());
    assertEquals(Integer.MAX_VALUE, system.getDebrisBudget());
    assertEquals(Float.POSITIVE_INFINITY, system.getDebrisLifetime());
    double mass = Totals.of(world).material;
    Range.step(world, 60f, 5f);
    assertEquals(mass, Totals.of(world).material, 1e-4 * mass);
    assertTrue(log.discarded.isEmpty());
  }

  @Test
  void limitsThatMakeNoSenseAreRefused() {
    FractureSystem system = FractureSystem.of(new World(new Vec2()));
    assertThrows(IllegalArgumentException.class, () -> system.setPiecesPerFracture(1));
    assertThrows(IllegalArgumentException.class, () -> system.setDebrisBudget(-1));
    assertThrows(IllegalArgumentException.class, () -> system.setDebrisLifetime(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> system.setDebrisLifetime(-1f));
  }

  @Test
  void limitedWorldsAreRepeatable() {
    long first = limitedRun();
    for (int i = 0; i < 3; i++) {
      assertEquals(first, limitedRun());
    }
  }

  private static long limitedRun() {
    World world = rain();
    FractureSystem system = FractureSystem.of(world);
    system.setPiecesPerFracture(9);
    system.setDebrisBudget(15);
    system.setDebrisLifetime(0.5f);
    long hash = 0;
    for (int i = 0; i < 240; i++) {
      world.step(1f / 60f, 8, 3);
      hash = hash * 31 + FractureScenes.hash(world);
    }
    return hash;
  }
}
