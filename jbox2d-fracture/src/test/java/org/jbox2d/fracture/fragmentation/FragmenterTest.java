package org.jbox2d.fracture.fragmentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.voronoi.SiteKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class FragmenterTest {
  private static final List<RegionOfEffect> EVERYWHERE = Collections.emptyList();
  private static final Outline BOX = Outline.of(-1, -1, 1, -1, 1, 1, -1, 1);

  /** Cases of each kind of outline in a normal build; -Dgeometry.cases=N for more. */
  private static final int CASES = Integer.getInteger("geometry.cases", 2000);

  /** Seed of the first case, to run others than usual: -Dgeometry.first=N. */
  private static final int FIRST = Integer.getInteger("geometry.first", 0);

  @ParameterizedTest
  @EnumSource(OutlineKind.class)
  void tilesEveryKindOfOutlineForEveryKindOfSites(OutlineKind outlineKind) {
    Fragmenter fragmenter = new Fragmenter();
    int seeds = (CASES + SiteKind.values().length - 1) / SiteKind.values().length;
    int broken = 0;
    for (SiteKind siteKind : SiteKind.values()) {
      for (int seed = FIRST; seed < FIRST + seeds; seed++) {
        FragmenterCases.Case c = FragmenterCases.make(outlineKind, siteKind, seed);
        Fragmentation result =
            fragmenter.fragment(c.outline, c.sites, c.siteCount, c.regions, c.limits);
        String fault =
            FragmentationOracle.fault(c.outline, result, c.areaTolerance, seed % 16 == 0);
        assertNull(fault, outlineKind + " " + siteKind + " " + seed);
        broken += result.status() == FragmentationStatus.BROKEN ? 1 : 0;
      }
    }
    assertTrue(broken > CASES / 4, "broken: " + broken);
  }

  @Test
  void alignedGridGivesItsSquares() {
    double[] sites = SiteKind.GRID.make(new java.util.Random(1), 16);
    Fragmentation result = new Fragmenter().fragment(BOX, sites, 16, EVERYWHERE, PieceLimits.NONE);
    assertEquals(FragmentationStatus.BROKEN, result.status());
    assertEquals(16, result.fragments().size());
    for (Fragment fragment : result.fragments()) {
      assertEquals(0.25, fragment.outline().area(), 1e-12);
      assertEquals(4, fragment.outline().vertexCount());
    }
  }

  @Test
  void cellEdgesAlongTheOutlineCutNothing() {
    // The bisector of these sites is the right side of the box.
    Fragmentation result =
        new Fragmenter()
            .fragment(BOX, new double[] {0.5, 0, 1.5, 0}, 2, EVERYWHERE, PieceLimits.NONE);
    assertEquals(FragmentationStatus.NOTHING_BREAKS, result.status());
    assertEquals(1, result.remainders().size());
  }

  @Test
  void regionOfEffectLeavesTheRestInOnePiece() {
    double[] sites = SiteKind.UNIFORM.make(new java.util.Random(3), 200);
    RegionOfEffect region = new ImpactRegion(-1, 0, 1, 0, 0.4, 0.8);
    Fragmentation result =
        new Fragmenter()
            .fragment(BOX, sites, 200, Collections.singletonList(region), PieceLimits.NONE);
    assertEquals(FragmentationStatus.BROKEN, result.status());
    assertEquals(1, result.remainders().size());
    double broken = 0;
    for (Fragment fragment : result.fragments()) {
      broken += fragment.outline().area();
    }
    // Half of an ellipse with semi-axes 0.4 and 0.8, give or take half a cell along its border.
    assertEquals(Math.PI * 0.4 * 0.8 / 2, broken, 0.1);
    assertEquals(4, broken + result.remainders().get(0).area(), 1e-9);
  }

  @Test
  void whatIsHiddenBehindAConcavityStays() {
    Outline u = Outline.of(0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3);
    double[] sites = new double[2 * 144];
    for (int i = 0; i < 144; i++) {
      sites[2 * i] = 0.13 + 0.25 * (i % 12);
      sites[2 * i + 1] = 0.13 + 0.25 * (i / 12);
    }
    // The region reaches the other arm, but not around the notch.
    RegionOfEffect region = new ImpactRegion(0, 2.5, 1, 0, 1, 4);
    Fragmentation result =
        new Fragmenter()
            .fragment(u, sites, 144, Collections.singletonList(region), PieceLimits.NONE);
    assertEquals(FragmentationStatus.BROKEN, result.status());
    for (Fragment fragment : result.fragments()) {
      assertTrue(fragment.outline().x(0) <= 1, "a fragment of the other arm");
    }
  }

  @Test
  void holeInsideOneCellStaysAHole() {
    Outline body =
        Outline.ofRings(
            new double[] {0, 0, 4, 0, 4, 4, 0, 4}, new double[] {0.5, 1, 1, 1, 1, 2, 0.5, 2});
    Fragmentation result =
        new Fragmenter().fragment(body, new double[] {1, 2, 3, 2}, 2, EVERYWHERE, PieceLimits.NONE);
    assertEquals(2, result.fragments().size());
    int holes = 0;
    for (Fragment fragment : result.fragments()) {
      holes += fragment.outline().ringCount() - 1;
    }
    assertEquals(1, holes);
    assertNull(FragmentationOracle.fault(body, result, 1e-12, true));
  }

  @Test
  void smallPiecesAreMergedAndNothingIsLost() {
    double[] sites = SiteKind.UNIFORM.make(new java.util.Random(3), 500);
    PieceLimits limits = new PieceLimits(0.005, 0.05);
    Fragmentation result = new Fragmenter().fragment(BOX, sites, 500, EVERYWHERE, limits);
    double total = 0;
    for (Fragment fragment : result.fragments()) {
      assertTrue(fragment.outline().area() >= 0.005 * 4);
      total += fragment.outline().area();
    }
    assertEquals(4, total, 1e-9);
  }

  @Test
  void cutsAlongAPolyline() {
    Fragmentation result =
        new Fragmenter().cut(BOX, new double[] {-2, 0, 0, 0.5, 2, 0}, PieceLimits.NONE);
    assertEquals(2, result.fragments().size());
    assertNull(FragmentationOracle.fault(BOX, result, 1e-12, true));
    Fragmentation loop =
        new Fragmenter()
            .cut(BOX, new double[] {-0.5, -0.5, 0.5, -0.5, 0, 0.5, -0.5, -0.5}, PieceLimits.NONE);
    assertEquals(2, loop.fragments().size());
    assertNull(FragmentationOracle.fault(BOX, loop, 1e-12, true));
    Fragmentation notch = new Fragmenter().cut(BOX, new double[] {-2, 0, 0, 0}, PieceLimits.NONE);
    assertEquals(FragmentationStatus.NOTHING_BREAKS, notch.status());
  }

  @Test
  void invalidOutlinesAreRefusedWithAReason() {
    Fragmentation result =
        new Fragmenter()
            .fragment(
                Outline.of(0, 0, 2, 2, 2, 0, 0, 2),
                new double[] {0, 0, 1, 1},
                2,
                EVERYWHERE,
                PieceLimits.NONE);
    assertEquals(FragmentationStatus.INVALID_OUTLINE, result.status());
    assertTrue(result.reason().contains("vertex 0"), result.reason());
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new Fragmenter()
                .fragment(BOX, new double[] {0, Double.NaN}, 1, EVERYWHERE, PieceLimits.NONE));
  }

  @Test
  void sameInputGivesTheSameResultWhateverRanBefore() {
    FragmenterCases.Case c = FragmenterCases.make(OutlineKind.RANDOM, SiteKind.UNIFORM, 5);
    Fragmenter used = new Fragmenter();
    FragmenterCases.run(used, FragmenterCases.make(OutlineKind.STAR, SiteKind.GRID, 9), false);
    Fragmentation a = used.fragment(c.outline, c.sites, c.siteCount, c.regions, c.limits);
    Fragmentation b =
        new Fragmenter().fragment(c.outline, c.sites, c.siteCount, c.regions, c.limits);
    assertEquals(a.fragments().size(), b.fragments().size());
    for (int i = 0; i < a.fragments().size(); i++) {
      org.junit.jupiter.api.Assertions.assertArrayEquals(
          a.fragments().get(i).outline().coordinates(),
          b.fragments().get(i).outline().coordinates());
    }
  }

  /** The second region hits nothing, but makes the fragmenter look at many more sites. */
  @Test
  void sitesFarFromTheRegionMakeNoDifference() {
    for (SiteKind kind : SiteKind.values()) {
      double[] sites = kind.make(new java.util.Random(8), 2000);
      RegionOfEffect region = new ImpactRegion(-1, 0.2, 1, 0.5, 0.15, 0.3);
      RegionOfEffect nowhere = new ImpactRegion(30, 30, 0, 0, 1e-3, 1e-3);
      Fragmentation few =
          new Fragmenter()
              .fragment(BOX, sites, 2000, Collections.singletonList(region), PieceLimits.NONE);
      Fragmentation many =
          new Fragmenter()
              .fragment(
                  BOX, sites, 2000, java.util.Arrays.asList(region, nowhere), PieceLimits.NONE);
      assertEquals(many.fragments().size(), few.fragments().size(), kind.name());
      java.util.Map<Integer, Double> areas = new java.util.HashMap<>();
      many.fragments().forEach(f -> areas.put(f.site(), f.outline().area()));
      few.fragments()
          .forEach(f -> assertEquals(areas.get(f.site()), f.outline().area(), 1e-9, kind.name()));
    }
  }

  /** With a number for each site, which changes nothing, no site is left out. */
  @ParameterizedTest
  @EnumSource(SiteKind.class)
  void theSitesLeftOutMakeNoDifference(SiteKind kind) {
    Fragmenter fragmenter = new Fragmenter();
    java.util.Random random = new java.util.Random(12);
    for (int c = 0; c < 100; c++) {
      int n = 30 + random.nextInt(300);
      double[] sites = kind.make(random, n);
      int[] alone = new int[n];
      java.util.Arrays.fill(alone, -1);
      List<RegionOfEffect> regions = new java.util.ArrayList<>();
      for (int k = 0; k <= c % 3; k++) {
        double x = 3 * random.nextDouble() - 1.5;
        double y = 3 * random.nextDouble() - 1.5;
        double radius = 0.1 + 0.7 * random.nextDouble();
        double ahead = radius * (1 + random.nextDouble());
        double turn = random.nextGaussian();
        regions.add(new ImpactRegion(x, y, turn, random.nextGaussian(), radius, ahead));
      }
      Fragmentation few = fragmenter.fragment(BOX, sites, n, regions, PieceLimits.NONE);
      Fragmentation all = fragmenter.fragment(BOX, sites, alone, n, regions, PieceLimits.NONE);
      assertEquals(all.status(), few.status(), kind + " " + c);
      assertEquals(all.fragments().size(), few.fragments().size(), kind + " " + c);
      assertEquals(all.remainders().size(), few.remainders().size(), kind + " " + c);
      java.util.Map<Integer, Double> areas = new java.util.HashMap<>();
      all.fragments().forEach(f -> areas.merge(f.site(), f.outline().area(), Double::sum));
      few.fragments().forEach(f -> areas.merge(f.site(), -f.outline().area(), Double::sum));
      areas.forEach((site, area) -> assertEquals(0, area, 1e-9, kind + " " + site));
    }
  }

  /** Sites outside of the box have numbers as well. */
  @Test
  void piecesOfSeveralSitesAreUnionsOfTheirCells() {
    java.util.Random random = new java.util.Random(11);
    for (int c = 0; c < 50; c++) {
      int n = 40 + random.nextInt(200);
      double[] sites = new double[2 * n];
      int[] numbers = new int[n];
      for (int i = 0; i < n; i++) {
        sites[2 * i] = 6 * random.nextDouble() - 3;
        sites[2 * i + 1] = 6 * random.nextDouble() - 3;
        numbers[i] = random.nextInt(6) - 1;
      }
      double[] expected = new double[6];
      Fragmenter fragmenter = new Fragmenter();
      fragmenter
          .fragment(BOX, sites, n, EVERYWHERE, PieceLimits.NONE)
          .fragments()
          .forEach(f -> expected[numbers[f.site()] + 1] += f.outline().area());
      Fragmentation united =
          fragmenter.fragment(BOX, sites, numbers, n, EVERYWHERE, PieceLimits.NONE);
      assertNull(FragmentationOracle.fault(BOX, united, 1e-12, true), "case " + c);
      double[] found = new double[6];
      united.fragments().forEach(f -> found[numbers[f.site()] + 1] += f.outline().area());
      org.junit.jupiter.api.Assertions.assertArrayEquals(expected, found, 1e-12, "case " + c);
    }
  }

  static List<org.jbox2d.fracture.geometry.WktOutlines.Line> handPicked()
      throws java.io.IOException {
    return org.jbox2d.fracture.geometry.WktOutlines.read("valid.wkt");
  }

  @ParameterizedTest
  @org.junit.jupiter.params.provider.MethodSource("handPicked")
  void handPickedOutlines(org.jbox2d.fracture.geometry.WktOutlines.Line line) {
    Outline body = line.outline;
    double size = body.x(1) - body.x(0) + body.y(1) - body.y(0);
    for (SiteKind kind : SiteKind.values()) {
      double[] sites = kind.make(new java.util.Random(2), 60);
      for (int i = 0; i < 60; i++) {
        sites[2 * i] = body.x(0) + size * sites[2 * i];
        sites[2 * i + 1] = body.y(0) + size * sites[2 * i + 1];
      }
      Fragmentation result =
          new Fragmenter().fragment(body, sites, 60, EVERYWHERE, PieceLimits.NONE);
      assertNull(FragmentationOracle.fault(body, result, 1e-6, true), line + " " + kind);
    }
  }
}
