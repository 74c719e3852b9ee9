package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.Solver;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.api.Test;

/** Repeated blows below the rigidity add up, if the material has a toughness. */
class ToughnessTest {
  private static final float[] RATES = {30f, 60f, 120f, 240f};

  private static final Solver[] SOLVERS = {
    Solver.sequentialImpulses(), Solver.softStep(), Solver.adaptive()
  };

  private static Uniform tough(float rigidity, float toughness) {
    Uniform m = Range.uniform(rigidity, 1f);
    m.m_toughness = toughness;
    return m;
  }

  /**
   * A disc flies against a wall until it breaks, each time from the same place and at the same
   * speed.
   *
   * @return how many blows it takes; 0 if it holds for good
   */
  private static int blowsToBreak(Material material, float speed, float hz, Body wall) {
    World world = wall.getWorld();
    FractureSystem system = FractureSystem.of(world);
    for (int blow = 1; blow <= 30; blow++) {
      Body disc = Range.disc(world, -4f, 0.1f, 0.5f, 4f, speed, 0f);
      disc.getFixtureList().setRestitution(0.3f);
      Range.step(world, hz, 1f);
      if (system.getFractureCount() > 0) {
        return blow;
      }
      world.destroyBody(disc);
      // What remains is still made of it.
      assertEquals(material, wall.getFixtureList().getMaterial());
    }
    return 0;
  }

  private static Body staticWall(Vec2 gravity, Material material) {
    World world = new World(gravity);
    Body wall = Range.body(world, BodyType.STATIC, 0f, 0f);
    Range.fixture(wall, Range.box(1f, 3f), 1f, material);
    return wall;
  }

  @Test
  void sameNumberOfBlowsAtEachRate() {
    float mass = (float) (Math.PI * 0.25 * 4);
    for (float restitutedSpeed : new float[] {6f, 10f, 14f}) {
      float intensity = 1.3f * mass * restitutedSpeed;
      Material material = tough(2.4f * intensity, 0.6f * intensity);
      // D after n blows is 0.4 n; the blow that exceeds what is left is the first n + 1 with 1 >
      // 2.4 - 0.4 n.
      for (Solver solver : SOLVERS) {
        for (float hz : RATES) {
          Body wall = staticWall(new Vec2(), material);
          wall.getWorld().setSolver(solver);
          int blows = blowsToBreak(material, restitutedSpeed, hz, wall);
          assertEquals(5, blows, solver + " at " + hz + " Hz");
        }
      }
    }
  }

  @Test
  void concaveWallsAndFallingDiscsTheSame() {
    int[] blows = new int[RATES.length];
    for (int i = 0; i < RATES.length; i++) {
      World world = new World(new Vec2(0f, -9.81f));
      Body wall = Range.body(world, BodyType.STATIC, 0f, 0f);
      FixtureDef def = new FixtureDef();
      def.material = tough(50f, 10f);
      Vec2[] angle = {
        new Vec2(-1f, -3f),
        new Vec2(3f, -3f),
        new Vec2(3f, -2f),
        new Vec2(1f, -2f),
        new Vec2(1f, 3f),
        new Vec2(-1f, 3f)
      };
      wall.createFixture(def, new PolygonFixture(angle));
      blows[i] = blowsToBreak((Material) def.material, 8f, RATES[i], wall);
      assertTrue(blows[i] > 1, blows[i] + " blows at " + RATES[i] + " Hz");
      assertEquals(blows[0], blows[i], RATES[i] + " Hz");
    }
  }

  @Test
  void blowsUpToTheToughnessNeverBreak() {
    float mass = (float) (Math.PI * 0.25 * 4);
    Material material = tough(100f, 1.05f * 1.3f * mass * 10f);
    assertEquals(0, blowsToBreak(material, 10f, 60f, staticWall(new Vec2(), material)));
  }

  @Test
  void offByDefault() {
    Material material = Range.uniform(60f, 1f);
    Body wall = staticWall(new Vec2(), material);
    assertEquals(0, blowsToBreak(material, 14f, 60f, wall));
    assertEquals(0f, FractureSystem.damageOf(wall.getFixtureList()));
  }

  /**
   * A stack at rest, set down without a drop. Under a tenfold weight the adaptive solver, which
   * sees only after its first step how heavy it is, lets the stack give way and then stops it at
   * once; that is a blow.
   */
  @Test
  void restingLoadsDoNoDamage() {
    for (Solver solver : SOLVERS) {
      for (float hz : RATES) {
        restsUndamaged(solver, hz, solver.isAdaptive() ? 2f : 10f);
      }
    }
  }

  private static void restsUndamaged(Solver solver, float hz, float topWeight) {
    World world = new World(new Vec2(0f, -9.81f));
    world.setSolver(solver);
    Body floor = Range.body(world, BodyType.STATIC, 0f, -1f);
    Range.fixture(floor, Range.box(20f, 1f), 0f, tough(100f, 0.5f));
    List<Fixture> struck = new ArrayList<>();
    struck.add(floor.getFixtureList());
    for (int i = 0; i < 4; i++) {
      Body box = Range.body(world, BodyType.DYNAMIC, 0f, 1f + 2.005f * i);
      struck.add(Range.fixture(box, Range.box(1f, 1f), i == 3 ? topWeight : 1f, tough(100f, 0.5f)));
    }
    Range.step(world, hz, 5f);
    for (Fixture f : struck) {
      assertEquals(0f, FractureSystem.damageOf(f), "damage by " + solver + " at " + hz + " Hz");
    }
  }

  @Test
  void remaindersInheritDamageSplintersDoNot() {
    World world = new World(new Vec2());
    Body body = Range.body(world, BodyType.DYNAMIC, 0f, 0f);
    Range.fixture(body, Range.box(4f, 4f), 1f, tough(40f, 10f));
    Fixture handle = Range.fixture(body, Range.box(4.5f, 0.2f), 1f, tough(1000f, 1f));
    Fixture struck = body.getFixtureList() == handle ? handle.getNext() : body.getFixtureList();
    FractureSystem system = FractureSystem.of(world);
    List<Float> heard = new ArrayList<>();
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(
        new FractureListener() {
          @Override
          public void action(Material material, float intensity, List<Body> fragments) {}

          @Override
          public void damaged(Fixture fixture, float intensity, float damage) {
            heard.add(damage);
          }

          @Override
          public void fractured(FractureEvent event) {
            events.add(event);
          }
        });
    Vec2 left = new Vec2(-4f, 0.3f);
    system.strike(struck, left, new Vec2(18f, 0f));
    system.strike(handle, left, new Vec2(5f, 0f));
    assertEquals(List.of(8f, 4f), heard);
    assertTrue(events.isEmpty());
    // 33 exceeds 40 - 8, not 40.
    system.strike(struck, left, new Vec2(33f, 0f));
    assertEquals(1, events.size());
    for (Body b : events.get(0).remainders()) {
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        boolean ofHandle = ((Material) f.getMaterial()).m_rigidity == 1000f;
        assertEquals(ofHandle ? 4f : 8f, FractureSystem.damageOf(f));
      }
    }
    for (Body b : events.get(0).splinters()) {
      assertEquals(0f, FractureSystem.damageOf(b.getFixtureList()));
    }
    Fixture mended = events.get(0).remainders().get(0).getFixtureList();
    FractureSystem.mend(mended);
    assertEquals(0f, FractureSystem.damageOf(mended));
  }

  @Test
  void notANumberIsRefused() {
    Material material = tough(10f, Float.NaN);
    Body wall = staticWall(new Vec2(), material);
    FractureSystem system = FractureSystem.of(wall.getWorld());
    assertThrows(
        IllegalStateException.class,
        () -> system.strike(wall.getFixtureList(), new Vec2(), new Vec2(1f, 0f)));
  }
}
