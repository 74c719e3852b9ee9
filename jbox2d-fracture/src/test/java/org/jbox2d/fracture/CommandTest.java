package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.junit.jupiter.api.Test;

/**
 * What a game can do besides letting things collide: strike, cut, explode; and listen, veto and
 * limit.
 */
class CommandTest {
  private final World world = new World(new Vec2());
  private final FractureSystem system = FractureSystem.of(world);

  private Body box(float rigidity) {
    return Range.wall(world, BodyType.DYNAMIC, 5f, Range.uniform(rigidity, 3f));
  }

  // --- Strike ---

  @Test
  void weakStrikeOnlyPushes() {
    Body box = box(50f);
    List<Body> pieces = system.strike(box.getFixtureList(), new Vec2(-5, 0), new Vec2(40, 0));
    assertTrue(pieces.isEmpty());
    assertEquals(0.4f, box.getLinearVelocity().x, 1e-5f);
    assertEquals(1, world.getBodyCount());
  }

  @Test
  void hardStrikeBreaksAndGivesTheRigidityAsMomentum() {
    Body box = box(50f);
    List<Body> pieces = system.strike(box.getFixtureList(), new Vec2(-5, 1), new Vec2(400, 0));
    assertTrue(pieces.size() > 5, pieces.size() + " pieces");
    Totals t = Totals.of(world);
    assertEquals(100, t.mass, 1e-3);
    assertEquals(50, t.px, 1e-3);
    assertEquals(0, t.py, 1e-3);
    // The impulse acts 1 m above the centre: L = -y px.
    assertEquals(-50, t.spin, 2e-3);
  }

  @Test
  void strikeWithoutMaterialPushes() {
    Body box = Range.wall(world, BodyType.DYNAMIC, 1f, null);
    assertTrue(system.strike(box.getFixtureList(), new Vec2(), new Vec2(0, 8)).isEmpty());
    assertEquals(2f, box.getLinearVelocity().y, 1e-6f);
  }

  // --- Cut ---

  @Test
  void cutThroughMakesTwo() {
    Body box = box(50f);
    box.setLinearVelocity(new Vec2(3, 1));
    box.setAngularVelocity(2f);
    Totals before = Totals.of(world);
    List<Body> pieces = system.cut(box, new Vec2(-9, 1), new Vec2(9, 1));
    assertEquals(2, pieces.size());
    assertSame(box, pieces.get(0));
    assertEquals(60f, pieces.get(0).getMass(), 1e-3f);
    assertEquals(40f, pieces.get(1).getMass(), 1e-3f);
    Totals after = Totals.of(world);
    assertEquals(before.px, after.px, 1e-3);
    assertEquals(before.spin, after.spin, 1e-4 * before.spinScale);
    assertSame(
        pieces.get(0).getFixtureList().m_material, pieces.get(1).getFixtureList().m_material);
  }

  @Test
  void cutOfATurnedBodyIsWhereItIs() {
    Body box = box(50f);
    box.setTransform(new Vec2(7, 3), (float) (Math.PI / 4));
    List<Body> pieces = system.cut(box, new Vec2(7, -20), new Vec2(7, 20));
    assertEquals(2, pieces.size());
    for (Body b : pieces) {
      assertEquals(50f, b.getMass(), 1e-2f);
      assertEquals(3f, b.getWorldCenter().y, 1e-3f);
      // Centroid of half a square of side 10 cut along its diagonal: 10 / sqrt(2) / 3 from it.
      assertEquals(10 / Math.sqrt(2) / 3, Math.abs(b.getWorldCenter().x - 7), 1e-2);
    }
  }

  @Test
  void cutThatEndsInsideCutsNothing() {
    Body box = box(50f);
    assertTrue(system.cut(box, new Vec2(-9, 1), new Vec2(0, 1)).isEmpty());
    assertEquals(1, world.getBodyCount());
    assertEquals(100f, box.getMass(), 1e-3f);
  }

  @Test
  void cutOfStaticBodyLetsTheSmallerPartFall() {
    Body wall = Range.wall(world, BodyType.STATIC, 5f, Range.uniform(50f, 3f));
    List<Body> pieces = system.cut(wall, new Vec2(-9, 2), new Vec2(9, 2));
    assertSame(BodyType.STATIC, pieces.get(0).getType());
    assertSame(BodyType.DYNAMIC, pieces.get(1).getType());
    assertEquals(30f, pieces.get(1).getMass(), 1e-2f);
  }

  @Test
  void cutGoesThroughAllFixtures() {
    Body body = Range.body(world, BodyType.DYNAMIC, 0, 0);
    PolygonShape upper = new PolygonShape();
    upper.setAsBox(2f, 1f, new Vec2(0, 1), 0f);
    PolygonShape lower = new PolygonShape();
    lower.setAsBox(2f, 1f, new Vec2(0, -1), 0f);
    Range.fixture(body, upper, 1f, null);
    Range.fixture(body, lower, 1f, null);
    List<Body> pieces = system.cut(body, new Vec2(0.5f, -9), new Vec2(0.5f, 9));
    double mass = 0;
    for (Body b : pieces) {
      mass += b.getMass();
      for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
        PolygonShape p = (PolygonShape) f.getShape();
        boolean left = p.m_centroid.x < 0.5f;
        for (int i = 0; i < p.m_count; i++) {
          assertTrue(left ? p.m_vertices[i].x <= 0.5f : p.m_vertices[i].x >= 0.5f);
        }
      }
    }
    assertEquals(16, mass, 1e-3);
    assertTrue(pieces.size() >= 2);
  }

  // --- Explosion ---

  @Test
  void explosionPushesAwayAndIsShadowed() {
    Body near = Range.body(world, BodyType.DYNAMIC, 4, 0);
    Range.fixture(near, Range.box(0.5f, 2f), 1f, null);
    Body behind = Range.body(world, BodyType.DYNAMIC, 7, 0);
    Range.fixture(behind, Range.box(0.5f, 1f), 1f, null);
    Body other = Range.body(world, BodyType.DYNAMIC, -4, 0);
    Range.fixture(other, Range.box(0.5f, 2f), 1f, null);
    assertEquals(2, system.explode(new Vec2(), 10f, 100f));
    assertTrue(near.getLinearVelocity().x > 1f);
    assertEquals(-near.getLinearVelocity().x, other.getLinearVelocity().x, 1e-3f);
    assertEquals(0f, behind.getLinearVelocity().length());
  }

  @Test
  void explosionImpulseIsThatOfTheAngleTakenUp() {
    // A wall from -h to h at distance d takes up the angle 2 atan(h / d); along x each ray gives
    // its cosine: I 2 sin(atan(h / d)).
    Body wall = Range.body(world, BodyType.DYNAMIC, 4.5f, 0);
    Range.fixture(wall, Range.box(0.5f, 3f), 1f, null);
    float radius = 1e6f;
    system.explode(new Vec2(), radius, 10f);
    double expected = 10 * 2 * Math.sin(Math.atan(3.0 / 4.0));
    assertEquals(expected, wall.getMass() * wall.getLinearVelocity().x, 0.02 * expected);
  }

  @Test
  void explosionBreaksWhatItExceeds() {
    Body weak = Range.body(world, BodyType.DYNAMIC, 6, 0);
    Range.fixture(weak, Range.box(2f, 2f), 1f, Range.uniform(20f, 2f));
    Body strong = Range.body(world, BodyType.DYNAMIC, -6, 0);
    Range.fixture(strong, Range.box(2f, 2f), 1f, Range.uniform(2000f, 2f));
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    system.explode(new Vec2(), 20f, 200f);
    assertFalse(events.isEmpty());
    for (FractureEvent e : events) {
      assertSame(FractureCause.EXPLOSION, e.cause());
      assertEquals(20f, e.material().m_rigidity);
    }
    assertEquals(16f, strong.getMass(), 1e-3f);
  }

  @Test
  void explosionInsideABodyBreaksIt() {
    box(50f);
    system.explode(new Vec2(0.5f, 0.2f), 10f, 100f);
    assertTrue(world.getBodyCount() > 5);
    Totals t = Totals.of(world);
    assertEquals(100, t.mass, 1e-3);
  }

  // --- Listener and limits ---

  private static FractureListener collect(List<FractureEvent> events) {
    return new FractureListener() {
      @Override
      public void action(Material material, float intensity, List<Body> fragments) {}

      @Override
      public void fractured(FractureEvent event) {
        events.add(event);
      }
    };
  }

  @Test
  void vetoLeavesAnOrdinaryBlow() {
    World plain = new World(new Vec2());
    for (World w : List.of(world, plain)) {
      Range.wall(w, BodyType.DYNAMIC, 5f, w == plain ? null : Range.uniform(40f, 3f));
      Range.disc(w, -9f, 0f, 1f, 5f, 60f, 0f);
    }
    int[] asked = {0};
    system.setListener(
        new FractureListener() {
          @Override
          public void action(Material material, float intensity, List<Body> fragments) {
            throw new AssertionError("it was called off");
          }

          @Override
          public boolean allow(FractureProposal proposal) {
            asked[0]++;
            assertSame(FractureCause.COLLISION, proposal.cause());
            assertTrue(proposal.intensity() > 40f);
            return false;
          }
        });
    Range.step(world, 60f, 0.5f);
    Range.step(plain, 60f, 0.5f);
    assertTrue(asked[0] > 0);
    assertEquals(plain.getBodyList().getLinearVelocity(), world.getBodyList().getLinearVelocity());
  }

  @Test
  void listenerMayChangeTheMaterial() {
    Body box = box(50f);
    Material dust = Range.uniform(1f, 1f);
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(
        new FractureListener() {
          @Override
          public void action(Material material, float intensity, List<Body> fragments) {}

          @Override
          public boolean allow(FractureProposal proposal) {
            proposal.setMaterial(dust);
            return true;
          }

          @Override
          public void fractured(FractureEvent event) {
            events.add(event);
          }
        });
    system.strike(box.getFixtureList(), new Vec2(-5, 0), new Vec2(100, 0));
    assertSame(dust, events.get(0).material());
    assertSame(dust, events.get(0).splinters().get(0).getFixtureList().m_material);
  }

  /** A box struck on its left side, 2 m off the axis, by a blow straight to the right. */
  @Test
  void eventTellsSitesAndRegionOfEffect() {
    Body box = box(50f);
    Material material = (Material) box.getFixtureList().m_material;
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    system.strike(box.getFixtureList(), new Vec2(-5, 2), new Vec2(300, 0));
    FractureEvent e = events.get(0);
    assertTrue(e.sites().size() > 3, "sites " + e.sites().size());
    assertEquals(1, e.regions().size());
    // A commanded strike reaches as far ahead as behind: the region is a disc about the point.
    for (Vec2 v : e.regions().get(0)) {
      assertEquals(material.m_radius, v.sub(e.point()).length(), 1e-4f);
    }
  }

  /** Ahead it reaches as far as the disc goes in two steps, here farther than the radius of 2 m. */
  @Test
  void regionOfEffectReachesAheadOfAFastDisc() {
    box(40f);
    Range.disc(world, -7f, 0f, 1f, 5f, 120f, 0f);
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    Range.step(world, 60f, 0.1f);
    FractureEvent e = events.get(0);
    float ahead = 0f;
    float behind = 0f;
    for (Vec2 v : e.regions().get(0)) {
      ahead = Math.max(ahead, v.x - e.point().x);
      behind = Math.max(behind, e.point().x - v.x);
    }
    assertEquals(2f * 120f / 60f, ahead, 0.05f);
    assertEquals(2f, behind, 0.01f);
  }

  @Test
  void cutHasNeitherSitesNorRegion() {
    Body box = box(50f);
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    system.cut(box, new Vec2(-20, 0), new Vec2(20, 1));
    assertEquals(List.of(), events.get(0).sites());
    assertEquals(List.of(), events.get(0).regions());
  }

  @Test
  void eventTellsOutlinesInTheOldFrame() {
    Body box = box(50f);
    box.setTransform(new Vec2(100, 50), 1f);
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    system.strike(box.getFixtureList(), box.getWorldPoint(new Vec2(-5, 0)), new Vec2(300, 0));
    FractureEvent e = events.get(0);
    assertEquals(-5f, e.point().x, 1e-4f);
    double area = 0;
    List<Body> all = new ArrayList<>(e.remainders());
    all.addAll(e.splinters());
    for (Body b : all) {
      for (List<Vec2[]> rings : FractureEvent.outlinesOf(b)) {
        for (Vec2[] ring : rings) {
          area += signedArea(ring);
          for (Vec2 v : ring) {
            assertTrue(Math.abs(v.x) <= 5.001f && Math.abs(v.y) <= 5.001f, "outside: " + v);
          }
        }
      }
    }
    assertEquals(100, area, 1e-3);
  }

  private static double signedArea(Vec2[] ring) {
    double twice = 0;
    for (int i = 0, j = ring.length - 1; i < ring.length; j = i++) {
      twice += (double) ring[j].x * ring[i].y - (double) ring[j].y * ring[i].x;
    }
    return twice / 2;
  }

  @Test
  void severalBlowsInOneStepAreOneFracture() {
    box(40f);
    Range.disc(world, -7f, 0f, 1f, 5f, 90f, 0f);
    Range.disc(world, 7f, 2f, 1f, 5f, -90f, 0f);
    List<FractureEvent> events = new ArrayList<>();
    system.setListener(collect(events));
    for (int i = 0; i < 30 && events.isEmpty(); i++) {
      world.step(1f / 60f, 8, 3);
    }
    assertEquals(1, events.size());
    double left = 0;
    double right = 0;
    for (Body b : events.get(0).splinters()) {
      left = Math.min(left, b.getLocalCenter().x);
      right = Math.max(right, b.getLocalCenter().x);
    }
    assertTrue(left < -2 && right > 2, "splinters from " + left + " to " + right);
  }

  /**
   * A piece's density makes up for what rounding takes of its area. When pieces of pieces took over
   * the factor of their parent, mass grew by millionths with each generation.
   */
  @Test
  void piecesOfPiecesOfPiecesKeepTheMass() {
    Body box = box(1f);
    system.setMinimumArea(0.01f);
    system.strike(box.getFixtureList(), new Vec2(-5, 0), new Vec2(300, 0));
    for (int generation = 0; generation < 4; generation++) {
      List<Body> bodies = new ArrayList<>();
      for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
        bodies.add(b);
      }
      for (Body b : bodies) {
        system.strike(b.getFixtureList(), b.getWorldCenter().clone(), new Vec2(30, 0));
      }
    }
    assertTrue(world.getBodyCount() > 30, world.getBodyCount() + " bodies");
    // Each of some hundred masses is a float.
    assertEquals(100, Totals.of(world).mass, 2e-5);
  }

  @Test
  void bodyLimitKeepsTheWorldSmall() {
    system.setBodyLimit(30);
    box(40f);
    Range.disc(world, -9f, 0f, 1f, 5f, 100f, 0f);
    for (int i = 0; i < 90; i++) {
      world.step(1f / 60f, 8, 3);
      assertTrue(world.getBodyCount() <= 30 + 2, world.getBodyCount() + " bodies");
    }
    assertEquals(100, Totals.of(world).mass - 5 * Math.PI, 1e-2);
  }

  // --- Bad input ---

  @Test
  void badInputIsNamed() {
    Body box = box(50f);
    Fixture f = box.getFixtureList();
    World elsewhere = new World(new Vec2());
    Body stranger = Range.wall(elsewhere, BodyType.DYNAMIC, 1f, null);
    assertBad(() -> system.strike(null, new Vec2(), new Vec2()));
    assertBad(() -> system.strike(stranger.getFixtureList(), new Vec2(), new Vec2()));
    assertBad(() -> system.strike(f, new Vec2(Float.NaN, 0), new Vec2()));
    assertBad(() -> system.strike(f, new Vec2(), new Vec2(0, Float.POSITIVE_INFINITY)));
    assertBad(() -> system.cut(stranger, new Vec2(), new Vec2(1, 0)));
    assertBad(() -> system.cut(box, new Vec2()));
    assertBad(() -> system.cut(box, new Vec2(), new Vec2(Float.NaN, 0)));
    assertBad(() -> system.explode(new Vec2(), 0f, 1f));
    assertBad(() -> system.explode(new Vec2(), 1f, -1f));
    assertBad(() -> system.setMinimumArea(Float.NaN));
    assertBad(() -> FractureSystem.of(null));
    assertEquals(1, world.getBodyCount());
  }

  private static void assertBad(Runnable call) {
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run);
    assertNotNull(e.getMessage());
  }

  @Test
  void commandsInALockedWorldAreRefused() {
    Body box = box(50f);
    FixtureDef def = new FixtureDef();
    def.shape = Range.box(1f, 1f);
    def.density = 1f;
    int[] refused = {0};
    def.material =
        (fixture, solved) -> {
          try {
            system.cut(box, new Vec2(-9, 0), new Vec2(9, 0));
          } catch (IllegalStateException e) {
            refused[0]++;
          }
        };
    Body hits = Range.body(world, BodyType.DYNAMIC, -7f, 0f);
    hits.createFixture(def);
    hits.setLinearVelocity(new Vec2(20, 0));
    Range.step(world, 60f, 0.3f);
    assertTrue(refused[0] > 0);
    assertFalse(world.isLocked());
  }

  @Test
  void warmingUpLeavesNothingBehind() {
    long before = FractureScenes.run(2, 40);
    FractureSystem.warmUp();
    assertEquals(before, FractureScenes.run(2, 40));
  }
}
