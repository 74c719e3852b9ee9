package org.jbox2d.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.materials.Uniform;
import org.junit.jupiter.api.Test;

/**
 * How the implementation that came with the thesis fails, a test for each failure; the numbers are
 * those of the list of its defects. What concerns geometry alone is tested in the packages of
 * geometry, materials in {@link MaterialTest}, pairs of breakable bodies in {@link
 * ConservationTest}.
 */
class ReferenceDefectsTest {
  private static final float HZ = 60f;

  /** A box of half-size 5 that is hit by a heavy disc. */
  private static World shot(Material material, float hz) {
    World world = new World(new Vec2());
    Range.wall(world, BodyType.DYNAMIC, 5f, material);
    Range.disc(world, -12f, 1.3f, 1f, 5f, 100f, 3f);
    return world;
  }

  @Test
  void defect01PiecesAreOneBodyEach() {
    World world = new World(new Vec2());
    Body body = Range.body(world, BodyType.DYNAMIC, 0, 0);
    FixtureDef def = new FixtureDef();
    def.density = 1f;
    def.material = Range.uniform(10f, 6f);
    Vec2[] l = {
      new Vec2(-4, 4),
      new Vec2(-4, -4),
      new Vec2(4, -4),
      new Vec2(4, -3),
      new Vec2(-3, -3),
      new Vec2(-3, 4)
    };
    body.createFixture(def, new PolygonFixture(l));
    Range.disc(world, -10f, -3.6f, 0.5f, 10f, 80f, 0f);
    int[] heard = {0};
    FractureSystem.of(world)
        .setListener(
            (m, i, pieces) -> {
              heard[0]++;
              for (Body piece : pieces) {
                assertTrue(hangsTogether(piece), "a piece is in several parts");
              }
            });
    Range.step(world, HZ, 1f);
    assertTrue(heard[0] > 0);
  }

  private static boolean hangsTogether(Body body) {
    List<Fixture> open = new ArrayList<>();
    List<Fixture> rest = new ArrayList<>();
    for (Fixture f = body.getFixtureList(); f != null; f = f.getNext()) {
      rest.add(f);
    }
    open.add(rest.remove(0));
    while (!open.isEmpty()) {
      Fixture f = open.remove(0);
      for (int i = rest.size() - 1; i >= 0; i--) {
        if (shareTwoVertices((PolygonShape) f.getShape(), (PolygonShape) rest.get(i).getShape())) {
          open.add(rest.remove(i));
        }
      }
    }
    return rest.isEmpty();
  }

  private static boolean shareTwoVertices(PolygonShape a, PolygonShape b) {
    int shared = 0;
    for (int i = 0; i < a.m_count; i++) {
      for (int j = 0; j < b.m_count; j++) {
        if (a.m_vertices[i].equals(b.m_vertices[j])) {
          shared++;
        }
      }
    }
    return shared >= 2;
  }

  @Test
  void defect02RemaindersKeepTheMaterialSplintersTakeTheirs() {
    Uniform stone = Range.uniform(40f, 3f);
    stone.m_fragments = null;
    World world = shot(stone, HZ);
    List<List<Body>> heard = new ArrayList<>();
    FractureSystem.of(world).setListener((m, i, pieces) -> heard.add(pieces));
    Range.step(world, HZ, 0.4f);
    assertFalse(heard.isEmpty());
    assertSame(stone, heard.get(0).get(0).getFixtureList().m_material);
    int withoutMaterial = 0;
    for (Body b : heard.get(0)) {
      withoutMaterial += b.getFixtureList().m_material == null ? 1 : 0;
    }
    assertTrue(withoutMaterial > 5, withoutMaterial + " splinters");
    for (List<Body> later : heard.subList(1, heard.size())) {
      assertNotNull(later.get(0).getFixtureList(), "only remainders break again");
    }
  }

  @Test
  void defect03WeakerSplintersDoNotBreakTheWhole() {
    Uniform hard = Range.uniform(1e6f, 3f);
    hard.m_fragments = Range.uniform(1f, 3f);
    World world = shot(hard, HZ);
    Range.step(world, HZ, 1f);
    assertEquals(0, FractureSystem.of(world).getFractureCount());
    assertEquals(2, world.getBodyCount());
  }

  @Test
  void defect05NothingBreaksNothingChanges() {
    World plain = shot(null, HZ);
    World material = shot(Range.uniform(40f, 3f), HZ);
    FractureSystem.of(material).setMinimumArea(1e9f);
    Body small = material.getBodyList().getNext();
    assertEquals(100f, small.getMass(), 1e-3f);
    // A tenth of its own area is the limit for what never broke; so let there be no room for a cell
    // to break away instead.
    Uniform whole =
        new Uniform() {
          @Override
          public Vec2[] focee(Vec2 point, Vec2 vector, SiteRandom random) {
            return new Vec2[] {new Vec2()};
          }
        };
    whole.m_rigidity = 40f;
    small.getFixtureList().m_material = whole;
    whole.m_radius = 0.01f;
    Range.step(plain, HZ, 1f);
    Range.step(material, HZ, 1f);
    assertEquals(0, FractureSystem.of(material).getFractureCount());
    Body a = plain.getBodyList();
    Body b = material.getBodyList();
    for (; a != null; a = a.getNext(), b = b.getNext()) {
      assertEquals(a.getLinearVelocity(), b.getLinearVelocity());
      assertEquals(a.getPosition(), b.getPosition());
    }
  }

  @Test
  void defect07RestingLoadsBreakNothing() {
    for (float hz : new float[] {30f, 60f, 240f}) {
      World world = new World(new Vec2(0, -9.81f));
      Body floor = Range.body(world, BodyType.STATIC, 0, -1f);
      Range.fixture(floor, Range.box(20f, 1f), 0f, null);
      Body box = Range.body(world, BodyType.DYNAMIC, 0, 5.015f);
      Range.fixture(box, Range.box(5f, 5f), 10f, Range.uniform(5f, 3f));
      Body onTop = Range.body(world, BodyType.DYNAMIC, 0, 11.03f);
      Range.fixture(onTop, Range.box(1f, 1f), 10f, Range.uniform(5f, 3f));
      Range.step(world, hz, 3f);
      assertEquals(0, FractureSystem.of(world).getFractureCount(), "at " + hz + " Hz");
    }
  }

  @Test
  void defect07TheSameBlowIsTheSameAtAnyRate() {
    // A disc of mass m at 20 m/s stops dead against a wall: i = m v, with or without gravity along
    // it.
    float mass = (float) (Math.PI * 0.25 * 4);
    for (float g : new float[] {0f, 30f}) {
      for (float hz : new float[] {30f, 60f, 120f, 240f}) {
        World world = new World(new Vec2(g, 0));
        Body wall = Range.body(world, BodyType.STATIC, 3f, 0);
        Range.fixture(wall, Range.box(2f, 2f), 1f, Range.uniform(1f, 1f));
        // It arrives with 20 m/s from wherever it starts.
        float start = -1.5f;
        float way = 1f - 0.5f - start;
        float v0 = (float) Math.sqrt(400 - 2 * g * way);
        Range.disc(world, start, 0f, 0.5f, 4f, v0, 0f);
        float[] intensity = {0};
        FractureSystem.of(world)
            .setListener((m, i, pieces) -> intensity[0] = intensity[0] == 0 ? i : intensity[0]);
        Range.step(world, hz, 0.5f);
        assertEquals(mass * 20f, intensity[0], 0.05f * mass * 20f, hz + " Hz, g = " + g);
      }
    }
  }

  @Test
  void defect08SmallBodiesLoseNoMass() {
    for (float half : new float[] {0.15f, 0.2f, 0.3f}) {
      World world = new World(new Vec2());
      Uniform m = Range.uniform(0.05f, 2 * half);
      m.m_radius = half;
      Body box = Range.wall(world, BodyType.DYNAMIC, half, m);
      double mass = box.getMass();
      Body disc = Range.disc(world, -4 * half, 0f, half / 4, 5f, 6f, 0f);
      Range.step(world, HZ, 1f);
      assertTrue(FractureSystem.of(world).getFractureCount() > 0, "half-size " + half);
      assertEquals(0, FractureSystem.of(world).getFailureCount());
      assertEquals(mass, Totals.of(world).mass - disc.getMass(), 1e-4 * mass);
    }
  }

  @Test
  void defect08SmallStaticBodiesStayStaticUntilStruckHard() {
    World world = new World(new Vec2());
    Body small = Range.body(world, BodyType.STATIC, 0, 0);
    Range.fixture(small, Range.box(0.3f, 0.3f), 1f, Range.uniform(30f, 1f));
    Range.disc(world, -2f, 0f, 0.2f, 1f, 10f, 0f);
    Range.step(world, HZ, 1f);
    assertSame(BodyType.STATIC, small.getType());
  }

  @Test
  void defect14TheSameSeedGivesTheSamePieces() throws InterruptedException {
    long first = run(5);
    for (int i = 0; i < 10; i++) {
      assertEquals(first, run(5));
    }
    assertTrue(first != run(6), "another seed gives other pieces");
    long[] hashes = new long[2];
    Thread[] threads = new Thread[2];
    for (int t = 0; t < 2; t++) {
      int mine = t;
      threads[t] = new Thread(() -> hashes[mine] = run(5));
      threads[t].start();
    }
    for (Thread t : threads) {
      t.join();
    }
    assertEquals(first, hashes[0]);
    assertEquals(first, hashes[1]);
  }

  private static long run(long seed) {
    World world = shot(Range.uniform(40f, 3f), HZ);
    FractureSystem.of(world).setSeed(seed);
    Range.step(world, HZ, 0.5f);
    long hash = 17;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      hash = 31 * hash + Float.floatToRawIntBits(b.m_sweep.c.x);
      hash = 31 * hash + Float.floatToRawIntBits(b.m_sweep.c.y);
      hash = 31 * hash + Float.floatToRawIntBits(b.m_sweep.a);
      hash = 31 * hash + Float.floatToRawIntBits(b.m_angularVelocity);
    }
    return hash;
  }

  @Test
  void defect15OrientationDoesNotMatter() {
    Vec2[] clockwise = {
      new Vec2(0, 0), new Vec2(0, 2), new Vec2(1, 1), new Vec2(2, 2), new Vec2(2, 0)
    };
    Vec2[] counter = {clockwise[4], clockwise[3], clockwise[2], clockwise[1], clockwise[0]};
    World world = new World(new Vec2());
    for (Vec2[] v : List.of(clockwise, counter)) {
      Body b = Range.body(world, BodyType.DYNAMIC, 0, 0);
      FixtureDef def = new FixtureDef();
      def.density = 1f;
      b.createFixture(def, new PolygonFixture(v));
      assertEquals(3f, b.getMass(), 1e-5f);
    }
  }

  @Test
  void defect15InvalidPolygonsAreRefusedWhenMade() {
    Vec2 o = new Vec2(0, 0);
    Vec2[][] bad = {
      {o, new Vec2(1, 0)},
      {o, new Vec2(1, 0), new Vec2(1, 0), new Vec2(0, 1)},
      {o, new Vec2(1, 1), new Vec2(1, 0), new Vec2(0, 1)},
      {o, new Vec2(1, 0), new Vec2(2, 0)},
      {o, new Vec2(Float.NaN, 0), new Vec2(0, 1)},
      {o, new Vec2(Float.POSITIVE_INFINITY, 0), new Vec2(0, 1)},
      {o, null, new Vec2(0, 1)}
    };
    for (Vec2[] v : bad) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> new PolygonFixture(v));
      assertFalse(e.getMessage().isEmpty());
    }
  }

  @Test
  void defect16PiecesInheritEverything() {
    World world = new World(new Vec2());
    BodyDef def = new BodyDef();
    def.type = BodyType.DYNAMIC;
    def.linearDamping = 0.01f;
    def.angularDamping = 0.02f;
    def.gravityScale = 0.5f;
    def.bullet = true;
    def.allowSleep = false;
    def.userData = "vase";
    Body body = world.createBody(def);
    FixtureDef fd = new FixtureDef();
    fd.shape = Range.box(5f, 5f);
    fd.density = 1f;
    fd.friction = 0.7f;
    fd.restitution = 0.05f;
    fd.userData = "glaze";
    fd.filter.categoryBits = 4;
    fd.filter.groupIndex = 3;
    fd.material = Range.uniform(40f, 3f);
    body.createFixture(fd);
    Range.disc(world, -12f, 0f, 1f, 5f, 100f, 0f);
    int[] pieces = {0};
    FractureSystem.of(world)
        .setListener(
            (m, i, made) -> {
              for (Body b : made) {
                pieces[0]++;
                assertEquals(0.01f, b.getLinearDamping());
                assertEquals(0.02f, b.getAngularDamping());
                assertEquals(0.5f, b.getGravityScale());
                assertTrue(b.isBullet());
                assertFalse(b.isSleepingAllowed());
                assertEquals("vase", b.getUserData());
                Fixture f = b.getFixtureList();
                assertEquals(0.7f, f.getFriction());
                assertEquals(0.05f, f.getRestitution());
                assertEquals("glaze", f.getUserData());
                assertEquals(4, f.getFilterData().categoryBits);
                assertEquals(3, f.getFilterData().groupIndex);
              }
            });
    Range.step(world, HZ, 0.3f);
    assertTrue(pieces[0] > 5);
  }

  @Test
  void defect17CompoundStaysTogether() {
    World world = new World(new Vec2());
    Body body = Range.body(world, BodyType.DYNAMIC, 0, 0);
    Range.fixture(body, Range.box(5f, 5f), 1f, Range.uniform(40f, 3f));
    PolygonShape handle = new PolygonShape();
    handle.setAsBox(2f, 0.5f, new Vec2(7f, 0f), 0f);
    Fixture kept = Range.fixture(body, handle, 1f, null);
    Range.disc(world, -9f, 0f, 1f, 5f, 60f, 0f);
    boolean[] heard = {false};
    FractureSystem.of(world)
        .setListener(
            (m, i, pieces) -> {
              if (!heard[0]) {
                heard[0] = true;
                Body remainder = pieces.get(0);
                assertSame(body, remainder);
                assertSame(body, kept.getBody());
                assertTrue(remainder.m_fixtureCount > 1, "remainder and handle are one body");
              }
            });
    Range.step(world, HZ, 0.3f);
    assertTrue(heard[0]);
  }

  @Test
  void defect20FailureChangesNothingAndIsReported() {
    Uniform broken =
        new Uniform() {
          @Override
          public Vec2[] focee(Vec2 point, Vec2 vector, SiteRandom random) {
            return new Vec2[] {new Vec2(), new Vec2(Float.NaN, 1f)};
          }
        };
    broken.m_rigidity = 10f;
    World world = shot(broken, HZ);
    World plain = shot(null, HZ);
    List<FractureFailure> failures = new ArrayList<>();
    FractureSystem.of(world)
        .setListener(
            new FractureListener() {
              @Override
              public void action(Material material, float intensity, List<Body> fragments) {
                throw new AssertionError("nothing may break");
              }

              @Override
              public void failed(FractureFailure failure) {
                failures.add(failure);
              }
            });
    Range.step(world, HZ, 0.5f);
    Range.step(plain, HZ, 0.5f);
    assertTrue(FractureSystem.of(world).getFailureCount() > 0);
    assertEquals(FractureSystem.of(world).getFailureCount(), failures.size());
    assertTrue(failures.get(0).reason().contains("NaN"), failures.get(0).reason());
    assertEquals(plain.getBodyList().getPosition(), world.getBodyList().getPosition());
    assertEquals(plain.getBodyList().getLinearVelocity(), world.getBodyList().getLinearVelocity());
  }

  @Test
  void defect21BulletsBreakTheWallAtAnyRate() {
    for (float hz : new float[] {30f, 60f, 120f, 240f}) {
      for (int k = 0; k < 24; k++) {
        World world = new World(new Vec2());
        Body wall = Range.body(world, BodyType.STATIC, 0, 0);
        Range.fixture(wall, Range.box(1f, 5f), 1f, Range.uniform(20f, 2f));
        Body bullet = Range.disc(world, -6f - 0.13f * k, 0.1f * k - 1f, 0.3f, 5f, 45f, 0f);
        bullet.setBullet(true);
        Range.step(world, hz, 0.3f);
        assertTrue(
            FractureSystem.of(world).getFractureCount() > 0, "bullet " + k + " at " + hz + " Hz");
      }
    }
  }

  @Test
  void noMaterialNoFracture() {
    World world = shot(null, HZ);
    Range.step(world, HZ, 1f);
    assertNull(world.getBodyList().getFixtureList().m_material);
    assertEquals(2, world.getBodyCount());
  }
}
