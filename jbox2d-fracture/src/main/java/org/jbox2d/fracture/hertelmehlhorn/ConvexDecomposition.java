package org.jbox2d.fracture.hertelmehlhorn;

import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.Rings;
import org.jbox2d.fracture.triangulation.DelaunayTriangulator;
import org.jbox2d.fracture.triangulation.TriangleMesh;
import org.jbox2d.fracture.triangulation.Triangulator;

/**
 * Decomposes an outline, with holes, into convex parts that an engine can take: triangulate, then
 * drop diagonals ({@link HertelMehlhorn}), in several orders, of which that with the fewest parts
 * is taken. What is convex and small enough already is one part.
 *
 * <p><b>Resolution.</b> An engine merges points nearer than some distance, drops vertices that
 * hardly stick out and refuses what is left without area. What is finer than that must not reach
 * it. So if a resolution is given,
 *
 * <ol>
 *   <li>the outline is rounded to floats and simplified first ({@link OutlineSimplifier}): edges
 *       shorter than the resolution are collapsed, keeping the area where that is possible, and
 *       vertices that hardly stick out are dropped;
 *   <li>parts are treated the same way at last ({@link PartFilter}); a part of which nothing is
 *       left is left out.
 * </ol>
 *
 * Both change the area a little; {@link Result#areaError} tells how much. With a resolution of zero
 * the outline is taken exactly and nothing is left out.
 *
 * <p>An instance owns workspaces and reuses them; not for use by two threads at once.
 */
public final class ConvexDecomposition {
  private final Triangulator first;
  private final Triangulator second;
  private final DiagonalOrder[] orders;
  private final OutlineCheck check = new OutlineCheck();
  private final TriangleMesh mesh = new TriangleMesh();
  private final HertelMehlhorn hertelMehlhorn = new HertelMehlhorn();
  private final OutlineSimplifier simplifier = new OutlineSimplifier();
  private final PartFilter filter = new PartFilter();
  private final PlainPiece plain = new PlainPiece();

  /** What is decomposed: the outline, simplified if there is a resolution. */
  private Outline coarse;

  /** Creates a decomposition with the triangulator that was found best by measurement. */
  public ConvexDecomposition() {
    this(new DelaunayTriangulator(), null);
  }

  /**
   * Creates a decomposition that tries all orders of diagonals.
   *
   * @param first the triangulator to use
   * @param second the one to use where the first fails, or null
   */
  public ConvexDecomposition(Triangulator first, Triangulator second) {
    this(first, second, DiagonalOrder.values());
  }

  /**
   * Creates a decomposition that tries some orders of diagonals: fewer are faster, more give fewer
   * parts.
   *
   * @throws IllegalArgumentException if there is no order
   */
  public ConvexDecomposition(Triangulator first, Triangulator second, DiagonalOrder... orders) {
    if (orders.length == 0) {
      throw new IllegalArgumentException("orders of diagonals: none");
    }
    this.first = first;
    this.second = second;
    this.orders = orders.clone();
  }

  /** How a decomposition ended. */
  public enum Status {
    /** There are parts. */
    DECOMPOSED,
    /** The outline is not a simple polygon with separate holes. */
    INVALID_OUTLINE,
    /** All of the outline is finer than the resolution. */
    TOO_FINE,
    /** No triangulator succeeded. */
    NOT_TRIANGULATED
  }

  /** What came of a decomposition. */
  public static final class Result {
    private final Status status;
    private final String reason;
    private final ConvexParts parts;
    private final Outline outline;

    Result(Status status, String reason, ConvexParts parts, Outline outline) {
      this.status = status;
      this.reason = reason;
      this.parts = parts;
      this.outline = outline;
    }

    /** How it ended. */
    public Status status() {
      return status;
    }

    /** What went wrong, or an empty text. */
    public String reason() {
      return reason;
    }

    /** The parts; none on failure. */
    public ConvexParts parts() {
      return parts;
    }

    /**
     * Area of all parts less the area of the outline, as a share of the latter; -1 on failure. It
     * is computed here, of the outline's own arrays.
     */
    public double areaError() {
      if (outline == null) {
        return -1;
      }
      double area = outline.area();
      return (parts.totalArea() - area) / area;
    }
  }

  /**
   * Decomposes an outline.
   *
   * @param outline simple, in either orientation, collinear vertices allowed; holes may touch other
   *     rings in common vertices
   * @param mostVertices most vertices of a part, 3 or more
   * @param resolution distance below which the engine does not tell points apart, or zero
   * @throws IllegalArgumentException if the number of vertices is below 3, or the resolution
   *     negative or not finite
   */
  public Result decompose(Outline outline, int mostVertices, double resolution) {
    if (mostVertices < 3) {
      throw new IllegalArgumentException("most vertices of a part: " + mostVertices);
    }
    if (!(resolution >= 0 && resolution * 0 == 0)) {
      throw new IllegalArgumentException("resolution: " + resolution);
    }
    ConvexParts only = resolution > 0 ? plain.of(outline, mostVertices, resolution) : null;
    if (only != null) {
      return new Result(Status.DECOMPOSED, "", only, outline);
    }
    // With a resolution something else than the given outline is triangulated.
    boolean triangulationChecks = resolution == 0 && first.refusesCrossings();
    boolean acceptable =
        triangulationChecks ? check.runButCrossings(outline, true) : check.run(outline, true);
    if (!acceptable) {
      return invalid(outline);
    }
    // A triangulator that refuses crossings finds the few that simplifying has made.
    boolean findsCrossings = first.refusesCrossings() && second == null;
    Outline normal = outline.normal();
    ConvexParts parts = partsOf(normal, mostVertices, resolution, !findsCrossings);
    if (parts == null && findsCrossings && resolution > 0) {
      parts = partsOf(normal, mostVertices, resolution, true);
    }
    if (coarse == null) {
      return failure(Status.TOO_FINE, "outline is finer than the resolution " + resolution);
    }
    if (parts == null) {
      return triangulationChecks && !check.run(outline, true)
          ? invalid(outline)
          : failure(
              Status.NOT_TRIANGULATED, "outline of " + coarse.vertexCount() + " vertices resists");
    }
    if (resolution > 0) {
      parts = filter.filter(parts, resolution, outline.area());
      if (parts.count() == 0) {
        return failure(Status.TOO_FINE, "all parts are finer than the resolution " + resolution);
      }
    }
    return new Result(Status.DECOMPOSED, "", parts, outline);
  }

  /** Simplifies and decomposes a normal outline; null if nothing is left of it or it resists. */
  private ConvexParts partsOf(
      Outline normal, int mostVertices, double resolution, boolean checkCrossings) {
    coarse = resolution > 0 ? simplifier.simplify(normal, resolution, checkCrossings) : normal;
    boolean convex = resolution > 0 ? simplifier.isConvex() : isConvex(coarse);
    if (coarse == null) {
      return null;
    }
    return convex && coarse.vertexCount() <= mostVertices
        ? onePart(coarse)
        : decompose(coarse, mostVertices);
  }

  private static boolean isConvex(Outline outline) {
    return outline.ringCount() == 1
        && Rings.isStrictlyConvex(outline.coordinates(), 0, outline.vertexCount());
  }

  /** Names the first defect. */
  private Result invalid(Outline outline) {
    check.run(outline, true);
    return failure(Status.INVALID_OUTLINE, check.message());
  }

  private static Result failure(Status status, String reason) {
    return new Result(status, reason, new ConvexParts(new double[0], new int[1]), null);
  }

  /** The parts of a normal outline, or null if it resists. */
  private ConvexParts decompose(Outline outline, int mostVertices) {
    if (!first.triangulate(outline, mesh)
        && (second == null || !second.triangulate(outline, mesh))) {
      return null;
    }
    hertelMehlhorn.begin(outline, mesh);
    for (int k = 0; k < orders.length; k++) {
      if (!hertelMehlhorn.merge(mostVertices, orders[k])) {
        break;
      }
    }
    return hertelMehlhorn.fewestParts();
  }

  /** The vertices in the order in which they would come out of a triangulation: the last first. */
  private static ConvexParts onePart(Outline outline) {
    int n = outline.vertexCount();
    double[] xy = outline.coordinates();
    double[] part = new double[2 * n];
    part[0] = xy[2 * n - 2];
    part[1] = xy[2 * n - 1];
    System.arraycopy(xy, 0, part, 2, 2 * n - 2);
    return new ConvexParts(part, new int[] {0, n});
  }
}
