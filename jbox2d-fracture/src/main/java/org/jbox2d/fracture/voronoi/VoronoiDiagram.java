package org.jbox2d.fracture.voronoi;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Rings;

/**
 * Voronoi diagram of any number of sites, clipped to a rectangle: the dual of the {@link Delaunay}
 * triangulation.
 *
 * <p>Cell i belongs to site i. A cell is a convex counter-clockwise list of indices into one shared
 * table of vertices, so that cells that meet share their vertices exactly. Cocircular sites give
 * one vertex, not several in the same place: whether two triangles share their circumcentre is
 * decided exactly. A repeated site has an empty cell, and {@link #representative} names the site of
 * lowest index in its place. Sites may lie outside the rectangle; a cell that does not reach it is
 * empty.
 *
 * <p>Coordinates of vertices are rounded: the relative error is a few units in the last place of
 * the distance from the sites, since the one cancelling term, the area of a triangle, is evaluated
 * to full precision.
 *
 * <p>An instance owns its arrays and reuses them: once it has seen as many sites, {@link #compute}
 * allocates nothing. Results are valid until the next call. Not for use by two threads at once.
 */
public final class VoronoiDiagram {
  /** A site-less neighbour: the border of the rectangle. */
  public static final int BORDER = -1;

  private static final int NONE = -1;

  private final Delaunay delaunay = new Delaunay();
  private final Clip clip = new Clip();
  private final Circumcentres centres = new Circumcentres();
  private final DualEdges edges = new DualEdges();

  private int[] cellStart = new int[0];
  private int[] cellEnd = new int[0];

  /** Vertex and neighbour of each corner. */
  private int[] cornerRecord = new int[0];

  private int cornerEnd;
  private final int[] corner = new int[4];

  /**
   * Computes the diagram of n sites, clipped to a rectangle.
   *
   * @param sites interleaved coordinates, at least 2 n; not changed
   * @param n number of sites, zero or more
   * @throws IllegalArgumentException if a coordinate is not finite, the rectangle is empty, or n
   *     does not fit the array
   */
  public void compute(double[] sites, int n, double minX, double minY, double maxX, double maxY) {
    if (n < 0 || sites.length / 2 < n) {
      throw new IllegalArgumentException("number of sites: " + n);
    }
    clip.set(minX, minY, maxX, maxY);
    delaunay.compute(sites, n);
    centres.compute(delaunay, clip);
    edges.compute(delaunay, centres, clip);
    ensureCells(n);
    makeCells(n);
  }

  // ---- results ----

  /** Number of sites, repeated ones included. */
  public int siteCount() {
    return delaunay.siteCount();
  }

  /** Number of vertices in the table. */
  public int vertexCount() {
    return edges.vertexCount();
  }

  /** x of a vertex. */
  public double vertexX(int v) {
    return edges.x(v);
  }

  /** y of a vertex. */
  public double vertexY(int v) {
    return edges.y(v);
  }

  /** Index of the first corner of cell i, for {@link #cornerVertex}. */
  public int cellStart(int i) {
    return cellStart[i];
  }

  /** One past the last corner of cell i; equal to the start if the cell is empty. */
  public int cellEnd(int i) {
    return cellEnd[i];
  }

  /** Vertex of a corner. */
  public int cornerVertex(int k) {
    return cornerRecord[2 * k];
  }

  /** Site across the edge from this corner to the next of the same cell, or {@link #BORDER}. */
  public int cornerNeighbour(int k) {
    return cornerRecord[2 * k + 1];
  }

  /** Number of edges between cells, inside the rectangle. */
  public int edgeCount() {
    return edges.count();
  }

  /** Vertex edge e starts from. */
  public int edgeFrom(int e) {
    return edges.from(e);
  }

  /** Vertex edge e ends in. */
  public int edgeTo(int e) {
    return edges.to(e);
  }

  /** Site whose cell is left of edge e. */
  public int edgeLeft(int e) {
    return edges.left(e);
  }

  /** Site whose cell is right of edge e. */
  public int edgeRight(int e) {
    return edges.right(e);
  }

  /** Site i itself, or, if it repeats another, the site of lowest index in the same place. */
  public int representative(int i) {
    return delaunay.siteOfRank(delaunay.rankOfSite(i));
  }

  /** The triangulation whose dual this is. */
  public Delaunay delaunay() {
    return delaunay;
  }

  // ---- cells ----

  private void ensureCells(int n) {
    if (cellStart.length < n) {
      cellStart = new int[n + n / 2];
      cellEnd = new int[n + n / 2];
    }
    // Each edge gives a corner to two cells; each cell has at most two more for each of its gaps
    // and one for its corner.
    int corners = 2 * delaunay.edgeEnd() + n + 8;
    if (cornerRecord.length < 2 * corners) {
      cornerRecord = new int[3 * corners];
    }
  }

  /** In the order of ranks, in which neighbours are near each other in memory. */
  private void makeCells(int n) {
    Arrays.fill(cellStart, 0, n, 0);
    Arrays.fill(cellEnd, 0, n, 0);
    Arrays.fill(corner, NONE);
    cornerEnd = 0;
    int whole = edges.count() == 0 ? nearestToMiddle() : NONE;
    for (int rank = 0; rank < delaunay.count(); rank++) {
      int site = delaunay.siteOfRank(rank);
      cellStart[site] = cornerEnd;
      if (edges.count() > 0) {
        makeCell(rank, site);
      } else if (site == whole) {
        addCorners(0, 4, 0);
      }
      cellEnd[site] = cornerEnd;
    }
  }

  /** The site whose cell is the whole rectangle, when no edge crosses it. */
  private int nearestToMiddle() {
    double mx = 0.5 * (clip.minX + clip.maxX);
    double my = 0.5 * (clip.minY + clip.maxY);
    int best = NONE;
    double least = Double.POSITIVE_INFINITY;
    for (int rank = 0; rank < delaunay.count(); rank++) {
      double dx = delaunay.x(rank) - mx;
      double dy = delaunay.y(rank) - my;
      double distance = dx * dx + dy * dy;
      if (distance < least) {
        least = distance;
        best = delaunay.siteOfRank(rank);
      }
    }
    return best;
  }

  /** Goes around a site counter-clockwise, edge by edge, along the border where there is none. */
  private void makeCell(int rank, int site) {
    int[] records = delaunay.records();
    int[] dual = edges.records();
    int start = cornerEnd;
    int end = start;
    int firstEdge = delaunay.firstEdge(rank);
    int e = firstEdge;
    int lastTo = NONE;
    int lastNeighbour = NONE;
    do {
      int edge = EdgeRings.note(records, e);
      if (edge != NONE) {
        // Edges were made from even Delaunay edges; from an odd one they are seen from their right
        // side, in reverse.
        int k = edge << DualEdges.SHIFT;
        int odd = e & 1;
        int from = dual[k + odd];
        if (lastTo != from && lastTo != NONE) {
          cornerEnd = end;
          closeGap(lastTo, from, site, lastNeighbour);
          end = cornerEnd;
        }
        lastTo = dual[k + 1 - odd];
        lastNeighbour = dual[k + 3 - odd];
        cornerRecord[2 * end] = from;
        cornerRecord[2 * end + 1] = lastNeighbour;
        end++;
      }
      e = EdgeRings.next(records, e);
    } while (e != firstEdge);
    cornerEnd = end;
    if (end > start && lastTo != cornerVertex(start)) {
      closeGap(lastTo, cornerVertex(start), site, lastNeighbour);
    }
  }

  private void addCorner(int v, int neighbour) {
    cornerRecord[2 * cornerEnd] = v;
    cornerRecord[2 * cornerEnd + 1] = neighbour;
    cornerEnd++;
  }

  /** Follows the border counter-clockwise from one vertex to another. */
  private void closeGap(int from, int to, int site, int neighbour) {
    addCorner(from, BORDER);
    double start = clip.position(vertexX(from), vertexY(from));
    double end = clip.position(vertexX(to), vertexY(to));
    if (end < start) {
      // Rounding may have swapped two ends that are nearly the same point; only the owner of a
      // corner goes around.
      boolean swapped = start - end < 1 && !ownsCorner((int) Math.ceil(start) & 3, site, neighbour);
      if (swapped) {
        return;
      }
      end += 4;
    }
    addCorners((int) Math.floor(start) + 1, (int) Math.ceil(end), site);
  }

  /**
   * Adds the corners first (inclusive) to last (exclusive), counted from the lower left one
   * counter-clockwise.
   */
  private void addCorners(int first, int last, int site) {
    for (int k = first; k < last; k++) {
      int c = k & 3;
      if (corner[c] == NONE) {
        corner[c] = edges.addVertex(clip.cornerX(c), clip.cornerY(c));
      }
      addCorner(corner[c], BORDER);
    }
  }

  private boolean ownsCorner(int c, int site, int neighbour) {
    return squaredDistance(c, site) < squaredDistance(c, neighbour);
  }

  private double squaredDistance(int c, int site) {
    int rank = delaunay.rankOfSite(site);
    double dx = delaunay.x(rank) - clip.cornerX(c);
    double dy = delaunay.y(rank) - clip.cornerY(c);
    return dx * dx + dy * dy;
  }

  /** Area of cell i. */
  public double cellArea(int i) {
    int size = cellEnd(i) - cellStart(i);
    double[] ring = new double[2 * size];
    for (int k = 0; k < size; k++) {
      ring[2 * k] = vertexX(cornerVertex(cellStart(i) + k));
      ring[2 * k + 1] = vertexY(cornerVertex(cellStart(i) + k));
    }
    return Rings.signedArea(ring, 0, size);
  }

  /**
   * Checks the result: the triangulation is Delaunay, cells are convex and their areas add up to
   * that of the rectangle, edges are shared by the cells on both sides.
   *
   * @return null if all is well, else what is wrong
   */
  public String validate() {
    return new VoronoiCheck(this, clip.minX, clip.minY, clip.maxX, clip.maxY).validate();
  }

  /** Whether edge e of the triangulation has a triangle on both sides. */
  boolean isInner(int e) {
    return delaunay.hasTriangleLeft(e) && delaunay.hasTriangleLeft(e ^ 1);
  }
}
