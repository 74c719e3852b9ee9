package org.jbox2d.fracture.materials;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.fracture.FractureSystem;
import org.jbox2d.fracture.Material;
import org.jbox2d.fracture.Site;
import org.jbox2d.fracture.SiteRandom;
import org.jbox2d.fracture.fragmentation.Fragment;
import org.jbox2d.fracture.fragmentation.Fragmentation;
import org.jbox2d.fracture.fragmentation.FragmentationStatus;
import org.jbox2d.fracture.fragmentation.Fragmenter;
import org.jbox2d.fracture.fragmentation.ImpactRegion;
import org.jbox2d.fracture.fragmentation.PieceLimits;
import org.jbox2d.fracture.geometry.Outline;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shapes of the pieces that radial cracks, splinters and bricks give. */
class PieceShapesTest {
  /** Of lengths of some metres in floats. */
  private static final double ROUNDING = 1e-5;

  private static final Vec2 CONTACT = new Vec2(0.3f, 0.2f);
  private static final Vec2 VECTOR = new Vec2(8f, 1f);

  /** Pieces of a box of 20 m x 20 m about the origin that is struck in its middle. */
  private static List<Outline> pieces(Material m, long seed) {
    Vec2[] points = m.focee(CONTACT, VECTOR, new SiteRandom(seed));
    double[] sites = new double[2 * points.length];
    int[] pieceOfSite = new int[points.length];
    for (int i = 0; i < points.length; i++) {
      sites[2 * i] = points[i].x;
      sites[2 * i + 1] = points[i].y;
      pieceOfSite[i] = points[i] instanceof Site ? ((Site) points[i]).piece() : -1;
    }
    ImpactRegion region =
        new ImpactRegion(CONTACT.x, CONTACT.y, VECTOR.x, VECTOR.y, m.m_radius, m.m_radius);
    Fragmentation result =
        new Fragmenter()
            .fragment(
                Outline.of(new double[] {-10, -10, 10, -10, 10, 10, -10, 10}),
                sites,
                pieceOfSite,
                points.length,
                Collections.singletonList(region),
                PieceLimits.NONE);
    assertEquals(FragmentationStatus.BROKEN, result.status());
    List<Outline> outlines = new ArrayList<>();
    for (Fragment f : result.fragments()) {
      outlines.add(f.outline());
    }
    return outlines;
  }

  /** Left, right, bottom, top in a frame turned by the angle. */
  private static double[] bounds(Outline outline, double angle) {
    double[] b = {1e9, -1e9, 1e9, -1e9};
    for (int i = 0; i < outline.vertexCount(); i++) {
      double x = outline.x(i) * Math.cos(angle) + outline.y(i) * Math.sin(angle);
      double y = outline.y(i) * Math.cos(angle) - outline.x(i) * Math.sin(angle);
      b[0] = Math.min(b[0], x);
      b[1] = Math.max(b[1], x);
      b[2] = Math.min(b[2], y);
      b[3] = Math.max(b[3], y);
    }
    return b;
  }

  private static void assertRectangle(Outline outline, double[] b) {
    double box = (b[1] - b[0]) * (b[3] - b[2]);
    assertEquals(box, outline.area(), 1e-4 * box, "not a rectangle along the courses");
  }

  @ParameterizedTest
  @ValueSource(floats = {0f, 0.7f, -2f})
  void bricksAreTheRectanglesOfARunningBond(float angle) {
    Bricks m = new Bricks();
    m.setAngle(angle);
    m.setSlenderness(2.5f);
    m.m_shattering = 0.8f;
    m.m_radius = 1.6f;
    List<Outline> bricks = pieces(m, 1);
    double length = 0.8;
    double height = 0.32;
    for (Outline brick : bricks) {
      double[] b = bounds(brick, angle);
      assertRectangle(brick, b);
      assertEquals(length, b[1] - b[0], ROUNDING);
      assertEquals(height, b[3] - b[2], ROUNDING);
      double course = b[2] / height;
      assertEquals(Math.rint(course), course, 1e-4);
      double column = b[0] / length + 0.5 * (Math.floorMod(Math.round(course), 2));
      assertEquals(Math.rint(column), column, 1e-4, "every other course is moved by half a brick");
    }
    // The region is a disc; bricks on its rim count if more than half of them lies in it.
    double expected = Math.PI * 1.6 * 1.6 / (length * height);
    assertEquals(expected, bricks.size(), 0.15 * expected);
  }

  @Test
  void bricksOfAllBlowsAreOfOneWall() {
    Bricks m = new Bricks();
    Set<String> first = centres(m.focee(new Vec2(0.1f, 0.1f), new Vec2(3f, 0f)));
    Set<String> second = centres(m.focee(new Vec2(0.9f, -0.7f), new Vec2(-1f, 2f)));
    Set<String> common = new HashSet<>(first);
    common.retainAll(second);
    assertTrue(common.size() > first.size() / 3, common.size() + " of " + first.size());
  }

  private static Set<String> centres(Vec2[] sites) {
    Set<String> names = new HashSet<>();
    for (Vec2 v : sites) {
      names.add(Math.round(v.x * 1000) + " " + Math.round(v.y * 1000));
    }
    return names;
  }

  @ParameterizedTest
  @ValueSource(floats = {0f, 1.2f, 3f})
  void splintersAreLongAlongTheGrain(float angle) {
    Splinters m = new Splinters();
    m.setAngle(angle);
    m.m_radius = 2f;
    m.m_shattering = 1.6f;
    List<Outline> splinters = pieces(m, 4);
    assertTrue(splinters.size() > 20, splinters.size() + " splinters");
    Set<Long> ends = new HashSet<>();
    double mean = 0;
    for (Outline splinter : splinters) {
      double[] b = bounds(splinter, angle);
      assertRectangle(splinter, b);
      double length = b[1] - b[0];
      double breadth = b[3] - b[2];
      assertTrue(length > 0.8 - ROUNDING && length < 2.4 + ROUNDING, "length " + length);
      assertTrue(Math.abs(breadth / 0.2 - 1) <= 1.0 / 3 + 1e-3, "breadth " + breadth);
      mean += length / breadth / splinters.size();
      ends.add(Math.round(b[0] * 1000));
    }
    assertEquals(8, mean, 1.5, "slenderness");
    assertTrue(ends.size() >= 4, "ends lie side by side: " + ends.size() + " places");
  }

  /**
   * Every edge of a piece is part of a spoke, whose line meets the contact, or a chord of a ring.
   */
  @Test
  void radialCracksAreSpokesAndRings() {
    Radial m = new Radial();
    m.m_radius = 3f;
    m.m_shattering = 1.2f;
    List<Outline> pieces = pieces(m, 9);
    int spokes = 16;
    assertTrue(pieces.size() >= 5 * spokes, pieces.size() + " pieces");
    double area = 0;
    for (Outline piece : pieces) {
      area += piece.area();
      List<Double> directions = new ArrayList<>();
      for (int i = 0; i < piece.vertexCount(); i++) {
        int j = (i + 1) % piece.vertexCount();
        if (isSpoke(piece, i, j)) {
          addIfNew(directions, directionOf(piece, i, j));
        }
      }
      assertEquals(2, directions.size(), "each piece lies between two spokes");
    }
    // Chords of a circle of m_radius that touch it from outside on the sites' rays.
    double polygon = spokes * Math.tan(Math.PI / spokes) * 9;
    assertEquals(polygon, area, 0.03 * polygon, "the outermost ring is the edge of the region");
  }

  /** A neighbour's corner may divide the edge of a piece. */
  private static void addIfNew(List<Double> directions, double direction) {
    for (double d : directions) {
      if (Math.abs(Math.IEEEremainder(d - direction, 2 * Math.PI)) < 0.02) {
        return;
      }
    }
    directions.add(direction);
  }

  private static double directionOf(Outline piece, int i, int j) {
    double x = 0.5 * (piece.x(i) + piece.x(j)) - CONTACT.x;
    double y = 0.5 * (piece.y(i) + piece.y(j)) - CONTACT.y;
    return Math.atan2(y, x);
  }

  private static boolean isSpoke(Outline piece, int i, int j) {
    double ax = piece.x(i) - CONTACT.x;
    double ay = piece.y(i) - CONTACT.y;
    double bx = piece.x(j) - CONTACT.x;
    double by = piece.y(j) - CONTACT.y;
    double length = Math.hypot(bx - ax, by - ay);
    // As the sites are floats, the spokes meet in a knot of edges of micrometres.
    return length > 1e-4
        && Math.abs(ax * by - ay * bx) / length < 1e-3 * Math.max(1, Math.hypot(ax, ay));
  }

  @Test
  void radialPiecesGrowOutwards() {
    Radial m = new Radial();
    double[] near = {0, 0};
    double[] far = {0, 0};
    for (Outline piece : pieces(m, 2)) {
      double x = 0;
      double y = 0;
      for (int i = 0; i < piece.vertexCount(); i++) {
        x += (piece.x(i) - CONTACT.x) / piece.vertexCount();
        y += (piece.y(i) - CONTACT.y) / piece.vertexCount();
      }
      double[] sum = Math.hypot(x, y) < 1.5 ? near : far;
      sum[0] += piece.area();
      sum[1]++;
    }
    assertTrue(far[0] / far[1] > 4 * near[0] / near[1], "outer pieces are larger");
  }

  private static Material[] all() {
    return new Material[] {new Radial(), new Splinters(), new Bricks()};
  }

  @Test
  void sitesAreAFunctionOfTheArguments() {
    for (Material m : all()) {
      assertArrayEquals(m.focee(CONTACT, VECTOR), m.focee(CONTACT, VECTOR));
      assertArrayEquals(
          m.focee(CONTACT, VECTOR, new SiteRandom(5)), m.focee(CONTACT, VECTOR, new SiteRandom(5)));
    }
    for (Material m : new Material[] {new Radial(), new Splinters()}) {
      assertNotEquals(
          Arrays.asList(m.focee(CONTACT, VECTOR, new SiteRandom(5))),
          Arrays.asList(m.focee(CONTACT, VECTOR, new SiteRandom(6))));
    }
  }

  /**
   * However fine or coarse: some sites, all of them finite, no more than a diagram takes easily.
   */
  @Test
  void sitesAreBounded() {
    for (float shattering : new float[] {1e-3f, 0.05f, 0.3f, 1f, 7f, 1e3f, 1e6f}) {
      for (float radius : new float[] {0.01f, 0.5f, 2f, 30f, 1e5f}) {
        for (float slenderness : new float[] {1f, 2f, 12f, 100f}) {
          for (Vec2 vector : new Vec2[] {new Vec2(), new Vec2(3f, -4f), new Vec2(0f, 1e4f)}) {
            assertBounded(shattering, radius, slenderness, vector);
          }
        }
      }
    }
  }

  private static void assertBounded(float shattering, float radius, float slenderness, Vec2 v) {
    Splinters splinters = new Splinters();
    splinters.setSlenderness(slenderness);
    Bricks bricks = new Bricks();
    bricks.setSlenderness(slenderness);
    for (Material m : new Material[] {new Radial(), splinters, bricks}) {
      m.m_shattering = shattering;
      m.m_radius = radius;
      Vec2[] sites = m.focee(new Vec2(-40f, 3f), v);
      String what = m.getClass() + " " + shattering + " " + radius + " " + slenderness + " " + v;
      assertTrue(sites.length > 1 && sites.length <= 600, what + ": " + sites.length);
      for (Vec2 site : sites) {
        assertTrue(Float.isFinite(site.x) && Float.isFinite(site.y), what);
      }
    }
  }

  @Test
  void copiesAreIndependent() {
    Splinters wood = new Splinters();
    wood.setAngle(1f);
    Splinters copy = (Splinters) wood.copy();
    assertNotSame(wood, copy);
    assertEquals(1f, copy.getAngle());
    copy.setAngle(2f);
    assertEquals(1f, wood.getAngle());
    Bricks bricks = new Bricks();
    Bricks other = (Bricks) bricks.copy();
    other.setSlenderness(4f);
    assertEquals(2f, bricks.getSlenderness());
    assertSame(other, other.m_fragments);
  }

  @Test
  void nonsenseIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Splinters().setAngle(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> new Splinters().setSlenderness(0.5f));
    assertThrows(IllegalArgumentException.class, () -> new Bricks().setAngle(1f / 0f));
    assertThrows(IllegalArgumentException.class, () -> new Bricks().setSlenderness(Float.NaN));
    assertThrows(IllegalArgumentException.class, () -> new FunctionMaterial(null));
    assertThrows(IllegalArgumentException.class, () -> new Site(0f, 0f, -1));
  }

  @Test
  void functionGivesTheSites() {
    Vec2 contact = new Vec2(1f, 2f);
    FunctionMaterial m =
        new FunctionMaterial(
            (d, v, random) -> {
              Vec2[] sites = {new Vec2(d.x - 1f, d.y), new Vec2(d.x + v.x, d.y + random.unit())};
              d.setZero();
              return sites;
            });
    Vec2[] sites = m.focee(contact, new Vec2(3f, 0f), new SiteRandom(8));
    assertEquals(new Vec2(0f, 2f), sites[0]);
    assertEquals(4f, sites[1].x);
    assertEquals(new Vec2(1f, 2f), contact, "the function gets copies");
    assertArrayEquals(m.focee(contact, new Vec2()), m.focee(contact, new Vec2()));
  }

  /** Sites of two pieces, side by side like the squares of a chessboard's column. */
  @Test
  void cellsOfAPieceAreUnited() {
    double[] sites = {-5, -5, -5, 5, 5, -5, 5, 5};
    Fragmentation result =
        new Fragmenter()
            .fragment(
                Outline.of(new double[] {-10, -10, 10, -10, 10, 10, -10, 10}),
                sites,
                new int[] {7, 7, -1, -1},
                4,
                Collections.emptyList(),
                PieceLimits.NONE);
    assertEquals(3, result.fragments().size());
    double[] areas =
        result.fragments().stream().mapToDouble(f -> f.outline().area()).sorted().toArray();
    assertArrayEquals(new double[] {100, 100, 200}, areas, 1e-9);
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new Fragmenter()
                .fragment(
                    Outline.of(new double[] {0, 0, 1, 0, 0, 1}),
                    sites,
                    new int[] {1},
                    4,
                    Collections.emptyList(),
                    PieceLimits.NONE));
  }

  /** Of a wall in a world, whole bricks break out. */
  @Test
  void bricksBreakOutWhole() {
    World world = new World(new Vec2());
    BodyDef def = new BodyDef();
    def.type = BodyType.STATIC;
    PolygonShape box = new PolygonShape();
    box.setAsBox(4f, 4f);
    FixtureDef wall = new FixtureDef();
    wall.shape = box;
    wall.material = new Bricks();
    Body body = world.createBody(def);
    Fixture fixture = body.createFixture(wall);
    List<Body> pieces =
        FractureSystem.of(world).strike(fixture, new Vec2(0.3f, 0.2f), new Vec2(1000f, 0f));
    int whole = 0;
    for (Body piece : pieces.subList(1, pieces.size())) {
      MassData data = new MassData();
      piece.getFixtureList().getShape().computeMass(data, 1f);
      whole += Math.abs(data.mass - 0.5f) < 1e-3f ? 1 : 0;
    }
    assertTrue(whole > 10, whole + " whole bricks of " + pieces.size());
    assertEquals(pieces.size() - 1, whole, "all that breaks away within the wall");
  }
}
