package org.jbox2d.fracture.fragmentation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.voronoi.SiteKind;

/**
 * Random fragmentations by number: a case is a function of its kind of outline, its kind of sites
 * and its seed.
 */
final class FragmenterCases {
  private static final int[] SITE_COUNTS = {1, 2, 3, 5, 10, 20, 40, 100, 128};
  private static final double[] SCALES = {1e-3, 0.1, 1, 1, 10, 1e3};
  private static final double[] OFFSETS = {0, 0, 0, 1, 100, 1e4, 1e6};

  private FragmenterCases() {}

  static final class Case {
    Outline outline;
    double[] sites;
    int siteCount;
    List<RegionOfEffect> regions;
    PieceLimits limits;
    double areaTolerance;
  }

  static Case make(OutlineKind outlineKind, SiteKind siteKind, long seed) {
    Random random = new Random(seed * 1_000_003 + outlineKind.ordinal() * 101 + siteKind.ordinal());
    Case result = new Case();
    int n = random.nextInt(20) == 0 ? 3 + random.nextInt(510) : 3 + random.nextInt(24);
    int holes = random.nextInt(3) == 0 ? 1 + random.nextInt(4) : 0;
    Outline unit = outlineKind.make(random, n, holes);
    double scale = SCALES[random.nextInt(SCALES.length)];
    double offset = OFFSETS[random.nextInt(OFFSETS.length)] * scale;
    double[] xy = unit.coordinates().clone();
    for (int i = 0; i < xy.length; i++) {
      // Beyond this offset a float has too few digits for the outline to stay simple.
      xy[i] = offset > 200 * scale ? xy[i] * scale + offset : (float) (xy[i] * scale + offset);
    }
    result.outline = new Outline(xy, unit.ringStarts());
    if (org.jbox2d.fracture.geometry.OutlineCheck.of(result.outline).defect()
        != org.jbox2d.fracture.geometry.OutlineDefect.NONE) {
      return make(outlineKind, siteKind, seed + 7_777_777);
    }
    int count = SITE_COUNTS[random.nextInt(SITE_COUNTS.length)];
    result.siteCount = random.nextInt(200) == 0 ? 1000 : count;
    result.sites = siteKind.make(random, result.siteCount);
    double spread = random.nextBoolean() ? 1 : 0.3;
    int v = random.nextInt(result.outline.vertexCount());
    double[] contact = contact(random, result.outline, v);
    for (int i = 0; i < result.siteCount; i++) {
      double centreX = siteKind == SiteKind.GRID ? offset : contact[0];
      double centreY = siteKind == SiteKind.GRID ? offset : contact[1];
      double s = siteKind == SiteKind.GRID ? scale : spread * scale;
      result.sites[2 * i] = (float) (result.sites[2 * i] * s + centreX);
      result.sites[2 * i + 1] = (float) (result.sites[2 * i + 1] * s + centreY);
    }
    result.regions = new ArrayList<>();
    if (random.nextInt(4) > 0) {
      double angle = 2 * Math.PI * random.nextDouble();
      double length = random.nextInt(4) == 0 ? 0 : 1;
      double radius = scale * (0.1 + random.nextDouble());
      result.regions.add(
          new ImpactRegion(
              contact[0],
              contact[1],
              length * Math.cos(angle),
              length * Math.sin(angle),
              radius,
              radius * (1 + random.nextInt(2))));
    } else {
      result.regions = Collections.emptyList();
    }
    result.limits =
        random.nextBoolean()
            ? PieceLimits.NONE
            : new PieceLimits(random.nextDouble() * 0.01, random.nextDouble() * 0.02 * scale);
    result.areaTolerance = offset >= 1e4 * scale ? 1e-4 : 1e-6;
    return result;
  }

  /** A point inside, on an edge or at a vertex of the outline. */
  private static double[] contact(Random random, Outline outline, int v) {
    int w = v + 1 < outline.ringEnd(0) ? v + 1 : 0;
    double t = random.nextInt(3) * 0.5 * random.nextDouble();
    double x = outline.x(v) + t * (outline.x(w) - outline.x(v));
    double y = outline.y(v) + t * (outline.y(w) - outline.y(v));
    double inwards = random.nextInt(3) * 0.2 * random.nextDouble();
    int far = random.nextInt(outline.vertexCount());
    return new double[] {x + inwards * (outline.x(far) - x), y + inwards * (outline.y(far) - y)};
  }

  /** Runs one case; what is wrong, or null. */
  static String run(Fragmenter fragmenter, Case c, boolean overlaps) {
    Fragmentation result =
        fragmenter.fragment(c.outline, c.sites, c.siteCount, c.regions, c.limits);
    return FragmentationOracle.fault(c.outline, result, c.areaTolerance, overlaps);
  }
}
