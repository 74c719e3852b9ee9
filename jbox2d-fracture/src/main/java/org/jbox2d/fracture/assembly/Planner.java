package org.jbox2d.fracture.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.fracture.FractureLimit;
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
import org.jbox2d.fracture.impact.Request;
import org.jbox2d.fracture.impact.Strike;

/**
 * Works out a fracture: outline, sites, cells, fragmentation, convex parts, checks. A pure function
 * of request and seed; touches no world. Owns workspaces that are used again.
 */
public final class Planner {
  /**
   * The time whose way the region of effect reaches ahead, s. The thesis (7.1) takes twice the way
   * of a step, {@code d = 2 |v| dt}, so that what lies in the projectile's way in the next step has
   * broken by then; but then the same blow breaks eight times as deep at 30 Hz as at 240. So the
   * step is that of 60 Hz here, whatever the world's: it is the usual one, and the thesis' scenes,
   * made for 50 Hz, look as in it.
   */
  private static final double REACH_TIME = 2 * (double) (1f / 60f);

  /** Pieces below this share of the area of what breaks are merged into a neighbour. */
  private static final double LEAST_AREA_SHARE = 1e-4;

  /**
   * Pieces thinner than this many slops, by twice their area over their perimeter, are merged:
   * contacts let bodies sink into each other by one slop, so that thinner ones would be pressed
   * through. A square at the limit has a side of twice this.
   */
  private static final double LEAST_WIDTH_IN_SLOPS = 3;

  /**
   * Share of the original area below which a piece does not break any more, where the absolute
   * limit is larger.
   */
  private static final double LEAST_BREAKABLE_SHARE = 0.1;

  private final Fragmenter fragmenter = new Fragmenter();
  private final PartShapes partShapes = new PartShapes();
  private double[] sites = new double[0];
  private int[] pieceOfSite = new int[0];
  private int siteCount;
  private int pieceCount;

  /**
   * Works out what a request comes to.
   *
   * @param minimumArea area below which nothing breaks, m^2
   * @param pieceLimit how many pieces it may break into, what stays counted
   */
  public Plan plan(Request request, long seed, float minimumArea, int pieceLimit) {
    Breakable breakable = Breakable.of(request.fixture);
    if (breakable == null) {
      return Plan.without(request, Plan.Outcome.HOLDS);
    }
    if (breakable.outline.area() < leastBreakableArea(breakable, minimumArea)) {
      boolean loose = request.body.getType() == BodyType.STATIC;
      return loose
          ? Plan.without(request, Plan.Outcome.COMES_LOOSE)
          : Plan.limited(request, FractureLimit.MINIMUM_AREA);
    }
    return breakUp(request, breakable, seed, pieceLimit);
  }

  /**
   * The limit scales with what first broke, so that small bodies break too, but no piece is ground
   * to dust.
   */
  private static double leastBreakableArea(Breakable breakable, float minimumArea) {
    return Math.min(minimumArea, LEAST_BREAKABLE_SHARE * breakable.originalArea);
  }

  private Plan breakUp(Request request, Breakable breakable, long seed, int pieceLimit) {
    siteCount = 0;
    pieceCount = 0;
    List<ImpactRegion> regions = new ArrayList<>(request.strikes.size());
    SiteRandom random = new SiteRandom(seed);
    for (Strike strike : request.strikes) {
      Vec2[] points = request.material.focee(strike.point.clone(), strike.vector.clone(), random);
      String defect = takeSites(points, strike, request);
      if (defect != null) {
        return Plan.failed(request, defect);
      }
      regions.add(regionOf(strike, request.material));
    }
    Fragmentation result = fragment(breakable, regions);
    FractureLimit limit = null;
    int wanted = result.fragments().size();
    while (wanted > 1 && excess(pieceLimit, result) > 0) {
      limit = FractureLimit.PIECES_PER_FRACTURE;
      wanted =
          Math.max(1, Math.min(wanted, result.fragments().size()) - excess(pieceLimit, result));
      PieceMerger.gather(result.fragments(), sites, pieceOfSite, siteCount, wanted, pieceCount);
      pieceCount += wanted;
      result = fragment(breakable, regions);
    }
    boolean nothing = result.status() == FragmentationStatus.NOTHING_BREAKS;
    if (excess(pieceLimit, result) > 0 || (nothing && limit != null)) {
      return Plan.limited(request, FractureLimit.PIECES_PER_FRACTURE);
    }
    if (nothing) {
      return Plan.without(request, Plan.Outcome.HOLDS);
    }
    if (result.status().isFailure()) {
      return Plan.failed(request, result.status() + " " + result.reason());
    }
    return shape(request, breakable, result.remainders(), outlinesOf(result.fragments()))
        .madeBy(Arrays.copyOf(sites, 2 * siteCount), regions, limit);
  }

  private Fragmentation fragment(Breakable breakable, List<ImpactRegion> regions) {
    int[] numbers = pieceCount > 0 ? pieceOfSite : null;
    return fragmenter.fragment(breakable.outline, sites, numbers, siteCount, regions, limits());
  }

  private static int excess(int pieceLimit, Fragmentation result) {
    return result.fragments().size() + result.remainders().size() - pieceLimit;
  }

  /**
   * Works out a cut along a polyline: the largest piece stays, the others come off.
   *
   * @param polyline interleaved coordinates in the body's frame
   */
  public Plan cut(Request request, double[] polyline) {
    Breakable breakable = Breakable.of(request.fixture);
    if (breakable == null) {
      return Plan.without(request, Plan.Outcome.HOLDS);
    }
    Fragmentation result = fragmenter.cut(breakable.outline, polyline, limits());
    if (result.status().isFailure()) {
      return Plan.failed(request, result.status() + " " + result.reason());
    }
    List<Outline> pieces = outlinesOf(result.fragments());
    if (pieces.size() < 2) {
      return Plan.without(request, Plan.Outcome.HOLDS);
    }
    Outline largest = pieces.get(0);
    for (Outline piece : pieces) {
      if (piece.area() > largest.area()) {
        largest = piece;
      }
    }
    pieces.remove(largest);
    return shape(request, breakable, Collections.singletonList(largest), pieces);
  }

  private static PieceLimits limits() {
    return new PieceLimits(LEAST_AREA_SHARE, LEAST_WIDTH_IN_SLOPS * Settings.linearSlop);
  }

  private static List<Outline> outlinesOf(List<Fragment> fragments) {
    List<Outline> outlines = new ArrayList<>(fragments.size());
    for (Fragment fragment : fragments) {
      outlines.add(fragment.outline());
    }
    return outlines;
  }

  /**
   * Takes the sites of a strike that lie nearest to it: where the sites of several strikes overlap
   * they would else add up, and the pieces be finer than the material makes them.
   */
  private String takeSites(Vec2[] points, Strike strike, Request request) {
    if (points == null || points.length == 0) {
      return "the material gave no sites";
    }
    int needed = 2 * (siteCount + points.length);
    if (sites.length < needed) {
      sites = Arrays.copyOf(sites, needed);
      pieceOfSite = Arrays.copyOf(pieceOfSite, needed / 2);
    }
    // Each strike has pieces of its own, whatever numbers the others have.
    int first = pieceCount;
    for (Vec2 p : points) {
      if (p == null || !Float.isFinite(p.x) || !Float.isFinite(p.y)) {
        return "the material gave a site that is not finite: " + p;
      }
      if (isNearest(strike, p, request)) {
        sites[2 * siteCount] = p.x;
        sites[2 * siteCount + 1] = p.y;
        pieceOfSite[siteCount] = numberOf(p, first);
        siteCount++;
      }
    }
    return null;
  }

  /** Whether no other strike is nearer; of equally near ones the first counts. */
  private static boolean isNearest(Strike strike, Vec2 p, Request request) {
    if (request.strikes.size() == 1) {
      return true;
    }
    float own = distance2(strike.point, p);
    boolean before = true;
    for (Strike other : request.strikes) {
      if (other == strike) {
        before = false;
        continue;
      }
      float distance = distance2(other.point, p);
      if (distance < own || (before && distance == own)) {
        return false;
      }
    }
    return true;
  }

  private static float distance2(Vec2 a, Vec2 b) {
    float dx = a.x - b.x;
    float dy = a.y - b.y;
    return dx * dx + dy * dy;
  }

  private int numberOf(Vec2 site, int first) {
    if (!(site instanceof Site)) {
      return -1;
    }
    int number = first + ((Site) site).piece();
    pieceCount = Math.max(pieceCount, number + 1);
    return number;
  }

  private static ImpactRegion regionOf(Strike strike, Material material) {
    double radius = material.m_radius;
    // The vector of a commanded strike is only a direction.
    double way = strike.blow == null ? 0 : strike.vector.length() * REACH_TIME;
    double depth = Math.max(way, radius);
    return new ImpactRegion(
        strike.point.x, strike.point.y, strike.vector.x, strike.vector.y, radius, depth);
  }

  private Plan shape(
      Request request, Breakable breakable, List<Outline> staying, List<Outline> leaving) {
    List<Piece> remainders = new ArrayList<>();
    List<Piece> splinters = new ArrayList<>();
    try {
      for (Outline outline : staying) {
        remainders.add(pieceOf(outline, breakable));
      }
      for (Outline outline : leaving) {
        splinters.add(pieceOf(outline, breakable));
      }
    } catch (IllegalArgumentException e) {
      return Plan.failed(request, "a piece has no convex parts: " + e.getMessage());
    }
    List<Piece> all = new ArrayList<>(remainders);
    all.addAll(splinters);
    double area = 0;
    for (Piece piece : all) {
      area += piece.areaOfParts;
    }
    double expected = breakable.outline.area();
    if (!isWithinTolerance(Math.abs(area - expected), all)) {
      return Plan.failed(request, "the pieces have an area of " + area + " of " + expected);
    }
    return Plan.breaks(request, breakable, remainders, splinters);
  }

  private Piece pieceOf(Outline outline, Breakable breakable) {
    Shape[] parts = partShapes.of(outline, PartShapes.PIECE_SKIN_IN_SLOPS * Settings.linearSlop);
    return new Piece(outline, breakable.originalArea, parts);
  }

  /**
   * Vertices that move by less than the engine's resolution change the area of a piece by less than
   * that times half its perimeter. If the areas are off by more, something is missing and the
   * fracture is called off.
   */
  private static boolean isWithinTolerance(double change, List<Piece> pieces) {
    double perimeters = 0;
    for (Piece piece : pieces) {
      perimeters += piece.perimeter();
      // Mostly those of the first few are enough.
      if (change <= 0.5 * PartShapes.resolution() * perimeters) {
        return true;
      }
    }
    return false;
  }
}
