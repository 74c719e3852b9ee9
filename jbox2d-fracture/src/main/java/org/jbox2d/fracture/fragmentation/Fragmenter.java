package org.jbox2d.fracture.fragmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.voronoi.VoronoiDiagram;

/**
 * Breaks an outline along the edges of a Voronoi diagram or along a given polyline.
 *
 * <p>The way through: check the outline; go to local coordinates ({@link LocalFrame}); Voronoi
 * cells that matter ({@link CellSelection}); split cuts and outline at each other ({@link Noder});
 * find the pieces ({@link PlanarMap}); merge small ones ({@link PieceGroups}); choose those that
 * break away ({@link BreakAway}); unite the others; trace outlines ({@link RingTracer}); check the
 * area.
 *
 * <p>A pure function of its arguments. An instance owns workspaces and reuses them; not for use by
 * two threads at once. Malformed outlines and whatever goes wrong inside are reported by the
 * result's status, never thrown.
 */
public final class Fragmenter {
  /**
   * Slivers narrower than this many snapping distances are merged whatever the limits: rounding
   * made them.
   */
  private static final double SLIVER_SNAPS = 64;

  /**
   * Margin of the diagram's rectangle around the outline, in the local unit: borders never touch
   * the outline.
   */
  private static final double MARGIN = 0.125;

  /** Relative error of the total area beyond which the result is refused. */
  private static final double AREA_TOLERANCE = 1e-9;

  private final OutlineCheck check = new OutlineCheck();
  private final VoronoiDiagram voronoi = new VoronoiDiagram();
  private final CellEdges cellEdges = new CellEdges();
  private final Noder noder = new Noder();
  private final PlanarMap map = new PlanarMap();
  private final PieceGroups groups = new PieceGroups();
  private final RingTracer tracer = new RingTracer();
  private final BreakAway breakAway = new BreakAway();

  private Outline outline;
  private final LocalFrame frame = new LocalFrame();
  private final MatteringCells cells = new MatteringCells();
  private final CellSelection selection = new CellSelection(cells);
  private boolean cutByCells;
  private double[] result = new double[0];
  private int[] classOfPiece = new int[0];
  private int[] groupOfClass = new int[0];
  private int fragmentCount;
  private int classCount;

  /**
   * Breaks an outline by the Voronoi cells of sites.
   *
   * @param body the outline: simple, in either orientation, collinear vertices and holes allowed
   * @param sites interleaved coordinates of the sites, in the coordinates of the outline; not
   *     changed
   * @param siteCount number of sites; fewer than two break nothing
   * @param regions where pieces break away, one region an impact; empty: every piece breaks away
   * @param limits what is too small to be a piece
   * @throws IllegalArgumentException if a site is not finite or the number of sites does not fit
   *     the array
   */
  public Fragmentation fragment(
      Outline body,
      double[] sites,
      int siteCount,
      List<? extends RegionOfEffect> regions,
      PieceLimits limits) {
    return fragment(body, sites, null, siteCount, regions, limits);
  }

  /**
   * Breaks an outline by unions of Voronoi cells: shapes that no diagram with a site each has, such
   * as the bricks of a bond.
   *
   * @param pieceOfSite for each site a number; cells of sites with the same non-negative number are
   *     one, a negative one is of its own cell alone; {@code null}: each cell is of its own
   * @throws IllegalArgumentException as the other method, or if there are too few numbers
   */
  public Fragmentation fragment(
      Outline body,
      double[] sites,
      int[] pieceOfSite,
      int siteCount,
      List<? extends RegionOfEffect> regions,
      PieceLimits limits) {
    if (pieceOfSite != null && pieceOfSite.length < siteCount) {
      throw new IllegalArgumentException(
          "piece numbers: " + pieceOfSite.length + " of " + siteCount + " sites");
    }
    Fragmentation refusal = begin(body);
    if (refusal != null) {
      return refusal;
    }
    checkPoints(sites, siteCount);
    cutByCells = true;
    // The cells of a piece may lie far from the region that the piece is in: then no site is left
    // out.
    selection.compute(sites, siteCount, regions, pieceOfSite == null, frame, voronoi);
    cellEdges.add(voronoi, selection, cells, pieceOfSite, noder, frame);
    return finish(regions, limits);
  }

  /**
   * Cuts an outline along a polyline, which may cross itself; what it does not cut off stays. Every
   * piece breaks away.
   *
   * @param body the outline, as for {@link #fragment}
   * @param polyline interleaved coordinates of at least two points
   * @throws IllegalArgumentException if a coordinate is not finite or there are fewer than two
   *     points
   */
  public Fragmentation cut(Outline body, double[] polyline, PieceLimits limits) {
    int points = polyline.length / 2;
    if (points < 2) {
      throw new IllegalArgumentException("points of the polyline: " + points);
    }
    Fragmentation refusal = begin(body);
    if (refusal != null) {
      return refusal;
    }
    checkPoints(polyline, points);
    cutByCells = false;
    int last = addNode(polyline[0], polyline[1]);
    for (int i = 1; i < points; i++) {
      int next = addNode(polyline[2 * i], polyline[2 * i + 1]);
      noder.addSegment(last, next, -1, -1, false, true);
      last = next;
    }
    return finish(Collections.<RegionOfEffect>emptyList(), limits);
  }

  // ---- before ----

  /** Checks the outline and puts it into the noder; null if all is well. */
  private Fragmentation begin(Outline body) {
    if (!check.run(body, true)) {
      return Fragmentation.failure(FragmentationStatus.INVALID_OUTLINE, check.message());
    }
    outline = body.normal();
    frame.choose(outline);
    noder.clear(frame.snap());
    for (int i = 0; i < outline.vertexCount(); i++) {
      addNode(outline.x(i), outline.y(i));
    }
    for (int r = 0; r < outline.ringCount(); r++) {
      int last = outline.ringEnd(r) - 1;
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        noder.addSegment(last, i, last, -1, true, true);
        last = i;
      }
    }
    return null;
  }

  private int addNode(double x, double y) {
    return noder.addNode(frame.toLocalX(x), frame.toLocalY(y));
  }

  private static void checkPoints(double[] points, int count) {
    if (count < 0 || points.length / 2 < count) {
      throw new IllegalArgumentException("number of points: " + count);
    }
    for (int i = 0; i < count; i++) {
      if (points[2 * i] * 0 + points[2 * i + 1] * 0 != 0) {
        throw new IllegalArgumentException(
            "point " + i + " is not finite: (" + points[2 * i] + ", " + points[2 * i + 1] + ")");
      }
    }
  }

  // ---- after the cuts are known ----

  private Fragmentation finish(List<? extends RegionOfEffect> regions, PieceLimits limits) {
    if (!noder.node()) {
      return Fragmentation.failure(
          FragmentationStatus.NOT_NODED, noder.segmentCount() + " segments do not come apart");
    }
    if (!map.build(noder)) {
      return Fragmentation.failure(
          FragmentationStatus.NO_CONSISTENT_PIECES, "inside and outside cannot be told apart");
    }
    groups.build(map);
    double snap = frame.snap();
    double area = outline.area() * frame.scale() * frame.scale();
    groups.mergeSmall(
        Math.max(limits.areaShare() * area, snap * snap),
        Math.max(limits.width() * frame.scale(), SLIVER_SNAPS * snap));
    resultCoordinates();
    if (!choose(regions)) {
      return Fragmentation.unbroken(outline);
    }
    tracer.trace(map, classOfPiece, classCount, outline.vertexCount());
    return collect();
  }

  private void resultCoordinates() {
    double[] xy = noder.coordinates();
    int n = noder.nodeCount();
    if (result.length < 2 * n) {
      result = new double[3 * n];
    }
    System.arraycopy(outline.coordinates(), 0, result, 0, 2 * outline.vertexCount());
    for (int i = outline.vertexCount(); i < n; i++) {
      result[2 * i] = frame.toInputX(xy[2 * i]);
      result[2 * i + 1] = frame.toInputY(xy[2 * i + 1]);
    }
  }

  /**
   * Numbers the classes: first the groups that break away, then the connected parts of what stays.
   * False if nothing breaks.
   */
  private boolean choose(List<? extends RegionOfEffect> regions) {
    int pieces = map.pieceCount();
    if (classOfPiece.length < pieces) {
      classOfPiece = new int[2 * pieces];
      groupOfClass = new int[2 * pieces];
    }
    double unitArea = frame.unit() * frame.unit();
    boolean[] breaks = breakAway.choose(map, groups, regions, result, outline, unitArea);
    fragmentCount = 0;
    boolean anyStays = false;
    for (int p = 0; p < pieces; p++) {
      if (groups.group(p) == p) {
        anyStays |= !breaks[p];
        fragmentCount += breaks[p] ? 1 : 0;
      }
    }
    if (fragmentCount == 0 || (fragmentCount == 1 && !anyStays)) {
      return false;
    }
    if (anyStays) {
      uniteWhatStays(breaks);
    }
    numberClasses(breaks);
    return true;
  }

  private void uniteWhatStays(boolean[] breaks) {
    for (int h = 0; h < map.halfEdgeCount(); h += 2) {
      if (map.piece(h) < 0 || map.piece(h + 1) < 0) {
        continue;
      }
      int g = groups.group(map.piece(h));
      int k = groups.group(map.piece(h + 1));
      if (!breaks[g] && !breaks[k]) {
        groups.unite(g, k);
      }
    }
  }

  private void numberClasses(boolean[] breaks) {
    classCount = 0;
    Arrays.fill(classOfPiece, 0, map.pieceCount(), -1);
    for (int stay = 0; stay < 2; stay++) {
      for (int p = 0; p < map.pieceCount(); p++) {
        if (groups.group(p) == p && breaks[p] == (stay == 0)) {
          groupOfClass[classCount] = p;
          for (int m = p; m >= 0; m = groups.nextMember(m)) {
            classOfPiece[m] = classCount;
          }
          classCount++;
        }
      }
    }
  }

  private Fragmentation collect() {
    List<Fragment> fragments = new ArrayList<>(fragmentCount);
    List<Outline> remainders = new ArrayList<>(classCount - fragmentCount);
    double total = 0;
    for (int c = 0; c < classCount; c++) {
      if (!tracer.isSound(c)) {
        return Fragmentation.failure(
            FragmentationStatus.NO_CONSISTENT_PIECES, "a piece has no proper outer ring");
      }
      Outline piece = tracer.outline(c, result);
      total += piece.area();
      if (c < fragmentCount) {
        fragments.add(new Fragment(piece, siteOf(groupOfClass[c])));
      } else {
        remainders.add(piece);
      }
    }
    double expected = outline.area();
    if (!(Math.abs(total - expected) <= areaTolerance() * expected)) {
      return Fragmentation.failure(
          FragmentationStatus.AREA_LOST, "pieces have area " + total + " instead of " + expected);
    }
    return new Fragmentation(FragmentationStatus.BROKEN, "", fragments, remainders);
  }

  /**
   * The area may change by what the rounding of coordinates in the input's frame makes of the
   * outline's thinnest parts.
   */
  private double areaTolerance() {
    double extent = (frame.maxX() - frame.minX()) + (frame.maxY() - frame.minY());
    double localArea = outline.area() * frame.scale() * frame.scale();
    return AREA_TOLERANCE + 4 * frame.snap() * extent / localArea;
  }

  /** The site whose cell the first piece of a group lies in. */
  private int siteOf(int group) {
    for (int k = groups.edgeStart(group); k < groups.edgeEnd(group); k++) {
      if (map.outlineEdge(groups.edge(k)) < 0) {
        return cutByCells ? selection.site(map.label(groups.edge(k))) : -1;
      }
    }
    return -1;
  }
}
