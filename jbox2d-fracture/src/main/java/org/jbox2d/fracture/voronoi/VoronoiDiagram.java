package org.jbox2d.fracture.voronoi;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Predicates;
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

  /** A triangle's vertex that has not been looked at. */
  private static final int UNSEEN = -2;

  /**
   * Where an edge leaves the rectangle this close to one of its ends, in units of the rectangle's
   * extent, it ends there: rounding of the intersection, a few units in the last place, must not
   * give an edge of its own.
   */
  private static final double SAME_POINT = 0x1p-46;

  /**
   * Sine of the angle between two sides of a triangle above which its circumcentre is known to a
   * relative error of about 2^-52 over this, even if the differences of coordinates were rounded.
   */
  private static final double WELL_SHAPED = 1e-6;

  /**
   * Centres of well-shaped triangles that differ by more than this share of the radius are not the
   * same; rounding is below 1e-9.
   */
  private static final double SAME_CENTRE = 1e-7;

  /**
   * Sine that stands for those too small to be told from zero: the centre is so far away that only
   * its direction matters.
   */
  private static final double LEAST_CROSS = 1e-25;

  private final Delaunay delaunay = new Delaunay();
  private double minX;
  private double minY;
  private double maxX;
  private double maxY;
  private double samePoint;

  private int faceCount;
  private int[] leftFace = new int[0];
  private int[] faceEdge = new int[0];
  private boolean[] wellShaped = new boolean[0];
  private int[] faceParent = new int[0];
  private double[] centre = new double[0];
  private int[] centreVertex = new int[0];

  private int vertexCount;
  private double[] vertex = new double[0];
  private int[] vertexBorder = new int[0];

  private int edgeCount;
  private int[] edgeOfPair = new int[0];

  /** Vertices each edge starts from and ends in. */
  private int[] edgeVertex = new int[0];

  /** Sites left and right of each edge. */
  private int[] edgeSite = new int[0];

  private int[] cellStart = new int[0];
  private int[] cellEnd = new int[0];
  private int[] cellVertex = new int[0];
  private int[] cellNeighbour = new int[0];
  private int cornerEnd;
  private final int[] corner = new int[4];

  /** Start and end parameters of the clipped edge, what {@link #clipSlab} cuts. */
  private double clipStart;

  private double clipEnd;

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
    if (!(minX < maxX && minY < maxY && (maxX - minX) * 0 == 0 && (maxY - minY) * 0 == 0)) {
      throw new IllegalArgumentException(
          "rectangle is empty: (" + minX + ", " + minY + ") to (" + maxX + ", " + maxY + ")");
    }
    this.minX = minX;
    this.minY = minY;
    this.maxX = maxX;
    this.maxY = maxY;
    samePoint = SAME_POINT * Math.max(maxX - minX, maxY - minY);
    vertexCount = 0;
    edgeCount = 0;
    cornerEnd = 0;
    Arrays.fill(corner, NONE);
    delaunay.compute(sites, n);
    ensure(n);
    numberFaces();
    uniteCocircularFaces();
    makeEdges();
    makeCells(n);
  }

  // ---- results ----

  /** Number of sites, repeated ones included. */
  public int siteCount() {
    return delaunay.siteCount();
  }

  /** Number of vertices in the table. */
  public int vertexCount() {
    return vertexCount;
  }

  /** x of a vertex. */
  public double vertexX(int v) {
    return vertex[2 * v];
  }

  /** y of a vertex. */
  public double vertexY(int v) {
    return vertex[2 * v + 1];
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
    return cellVertex[k];
  }

  /** Site across the edge from this corner to the next of the same cell, or {@link #BORDER}. */
  public int cornerNeighbour(int k) {
    return cellNeighbour[k];
  }

  /** Number of edges between cells, inside the rectangle. */
  public int edgeCount() {
    return edgeCount;
  }

  /** Vertex edge e starts from. */
  public int edgeFrom(int e) {
    return edgeVertex[2 * e];
  }

  /** Vertex edge e ends in. */
  public int edgeTo(int e) {
    return edgeVertex[2 * e + 1];
  }

  /** Site whose cell is left of edge e. */
  public int edgeLeft(int e) {
    return edgeSite[2 * e];
  }

  /** Site whose cell is right of edge e. */
  public int edgeRight(int e) {
    return edgeSite[2 * e + 1];
  }

  /** Site i itself, or, if it repeats another, the site of lowest index in the same place. */
  public int representative(int i) {
    return delaunay.siteOfRank(delaunay.rankOfSite(i));
  }

  /** The triangulation whose dual this is. */
  public Delaunay delaunay() {
    return delaunay;
  }

  // ---- triangles ----

  private void ensure(int n) {
    int directed = delaunay.edgeEnd();
    if (leftFace.length < directed) {
      int size = directed + directed / 2;
      leftFace = new int[size];
      faceEdge = new int[size];
      faceParent = new int[size];
      wellShaped = new boolean[size];
      centre = new double[2 * size];
      centreVertex = new int[size];
      edgeOfPair = new int[size / 2 + 1];
      edgeVertex = new int[size + 2];
      edgeSite = new int[size + 2];
    }
    if (cellStart.length < n) {
      cellStart = new int[n + n / 2];
      cellEnd = new int[n + n / 2];
    }
    // A vertex is a circumcentre, an end of a clipped edge, or a corner of the rectangle.
    int vertices = directed + directed / 2 + 4;
    if (vertexBorder.length < vertices) {
      vertex = new double[3 * vertices];
      vertexBorder = new int[3 * vertices / 2];
    }
    // Each edge gives a corner to two cells; each cell has at most two more for each of its gaps
    // and one for its corner.
    int corners = 2 * directed + n + 8;
    if (cellVertex.length < corners) {
      cellVertex = new int[corners + corners / 2];
      cellNeighbour = new int[corners + corners / 2];
    }
  }

  private void numberFaces() {
    int directed = delaunay.edgeEnd();
    Arrays.fill(leftFace, 0, directed, UNSEEN);
    faceCount = 0;
    markUnboundedFace();
    for (int e = 0; e < directed; e++) {
      if (leftFace[e] != UNSEEN || !delaunay.isEdge(e)) {
        continue;
      }
      int f = delaunay.nextLeft(e);
      int g = delaunay.nextLeft(f);
      leftFace[e] = faceCount;
      leftFace[f] = faceCount;
      leftFace[g] = faceCount;
      faceEdge[faceCount] = e;
      faceParent[faceCount] = faceCount;
      centreVertex[faceCount] = UNSEEN;
      faceCount++;
    }
  }

  private void markUnboundedFace() {
    int hull = delaunay.hullEdge();
    if (hull == NONE) {
      return;
    }
    int e = hull;
    do {
      leftFace[e] = NONE;
      e = delaunay.nextLeft(e);
    } while (e != hull);
  }

  /** Triangles whose circumcircles are the same become one face, so that they have one centre. */
  private void uniteCocircularFaces() {
    for (int f = 0; f < faceCount; f++) {
      computeCentre(f);
    }
    int directed = delaunay.edgeEnd();
    for (int e = 0; e < directed; e += 2) {
      if (delaunay.isEdge(e)
          && leftFace[e] != NONE
          && leftFace[e + 1] != NONE
          && mayBeCocircular(e)
          && delaunay.inCircleSign(e) == 0) {
        int f = root(leftFace[e]);
        int g = root(leftFace[e + 1]);
        faceParent[Math.max(f, g)] = Math.min(f, g);
      }
    }
  }

  /**
   * False if the centres on both sides of an edge are known well and differ by far more than
   * rounding.
   */
  private boolean mayBeCocircular(int e) {
    int f = leftFace[e];
    int g = leftFace[e + 1];
    if (!wellShaped[f] || !wellShaped[g]) {
      return true;
    }
    double dx = centre[2 * f] - centre[2 * g];
    double dy = centre[2 * f + 1] - centre[2 * g + 1];
    double rx = centre[2 * f] - delaunay.x(delaunay.origin(e));
    double ry = centre[2 * f + 1] - delaunay.y(delaunay.origin(e));
    return dx * dx + dy * dy <= SAME_CENTRE * SAME_CENTRE * (rx * rx + ry * ry);
  }

  private int root(int f) {
    int r = f;
    while (faceParent[r] != r) {
      faceParent[r] = faceParent[faceParent[r]];
      r = faceParent[r];
    }
    return r;
  }

  /**
   * Circumcentre of triangle A, B, C with U = B - A, V = C - A (thesis, section 3):
   *
   * <pre>
   * S = A + (Vy |U|^2 - Uy |V|^2, Ux |V|^2 - Vx |U|^2) / (2 U x V)
   * </pre>
   *
   * A is an end of the shortest side, so that the numerators do not cancel; U x V is evaluated with
   * compensation.
   */
  private void computeCentre(int face) {
    int e = faceEdge[face];
    int f = delaunay.nextLeft(e);
    int g = delaunay.nextLeft(f);
    double le = squaredLength(e);
    double lf = squaredLength(f);
    double lg = squaredLength(g);
    int shortest = le <= lf && le <= lg ? e : lf <= lg ? f : g;
    int a = delaunay.origin(shortest);
    int b = delaunay.destination(shortest);
    int c = delaunay.destination(delaunay.nextLeft(shortest));
    double ux = delaunay.x(b) - delaunay.x(a);
    double uy = delaunay.y(b) - delaunay.y(a);
    double vx = delaunay.x(c) - delaunay.x(a);
    double vy = delaunay.y(c) - delaunay.y(a);
    double uu = ux * ux + uy * uy;
    double vv = vx * vx + vy * vy;
    double cross = Predicates.crossValue(ux, vy, uy, vx);
    double product = uu * vv;
    wellShaped[face] = cross * cross > WELL_SHAPED * WELL_SHAPED * product;
    if (!wellShaped[face]) {
      // The differences may have been rounded; then the sign may be lost, but the triangle is known
      // to have an area.
      cross = Math.max(cross, LEAST_CROSS * Math.sqrt(product));
    }
    double twiceCross = 2 * cross;
    double cx = delaunay.x(a) + (vy * uu - uy * vv) / twiceCross;
    double cy = delaunay.y(a) + (ux * vv - vx * uu) / twiceCross;
    centre[2 * face] = ontoBorder(cx, minX, maxX);
    centre[2 * face + 1] = ontoBorder(cy, minY, maxY);
  }

  /**
   * A circumcentre as good as on the border is put there, so that no edge is too short to leave the
   * rectangle.
   */
  private double ontoBorder(double value, double low, double high) {
    if (Math.abs(value - low) <= 2 * samePoint) {
      return low;
    }
    return Math.abs(value - high) <= 2 * samePoint ? high : value;
  }

  private double squaredLength(int e) {
    double dx = delaunay.x(delaunay.destination(e)) - delaunay.x(delaunay.origin(e));
    double dy = delaunay.y(delaunay.destination(e)) - delaunay.y(delaunay.origin(e));
    return dx * dx + dy * dy;
  }

  // ---- edges ----

  /**
   * The dual of each Delaunay edge between different circumcentres, as far as it is inside the
   * rectangle.
   */
  private void makeEdges() {
    int directed = delaunay.edgeEnd();
    for (int e = 0; e < directed; e += 2) {
      edgeOfPair[e >> 1] = NONE;
      if (!delaunay.isEdge(e)) {
        continue;
      }
      int right = leftFace[e + 1] == NONE ? NONE : root(leftFace[e + 1]);
      int left = leftFace[e] == NONE ? NONE : root(leftFace[e]);
      if (left == right && left != NONE) {
        continue;
      }
      makeEdge(e, right, left);
    }
  }

  /**
   * The bisector of the sites a, b of a Delaunay edge is m + t n, with m the midpoint and n = b - a
   * turned by +90 degrees; t runs from the circumcentre on the right, or minus infinity, to that on
   * the left, or infinity. Clipped by its parameter: a circumcentre far away, known only roughly,
   * does not tilt the part inside.
   */
  private void makeEdge(int e, int rightFace, int leftFaceOfEdge) {
    boolean startInside = rightFace != NONE && centreInside(rightFace);
    boolean endInside = leftFaceOfEdge != NONE && centreInside(leftFaceOfEdge);
    if (startInside && endInside) {
      addEdge(e, vertexOfCentre(rightFace), vertexOfCentre(leftFaceOfEdge));
      return;
    }
    int a = delaunay.origin(e);
    int b = delaunay.destination(e);
    double nx = -(delaunay.y(b) - delaunay.y(a));
    double ny = delaunay.x(b) - delaunay.x(a);
    double mx = delaunay.x(a) + 0.5 * ny;
    double my = delaunay.y(a) - 0.5 * nx;
    clipStart = parameter(rightFace, mx, my, nx, ny, Double.NEGATIVE_INFINITY);
    clipEnd = parameter(leftFaceOfEdge, mx, my, nx, ny, Double.POSITIVE_INFINITY);
    boolean hits = clipSlab(mx, nx, minX, maxX) && clipSlab(my, ny, minY, maxY);
    if (!hits && !startInside && !endInside) {
      return;
    }
    int from = startInside ? vertexOfCentre(rightFace) : NONE;
    int to = endInside ? vertexOfCentre(leftFaceOfEdge) : NONE;
    from = from != NONE ? from : borderVertex(mx, my, nx, ny, clipStart, to);
    to = to != NONE ? to : borderVertex(mx, my, nx, ny, clipEnd, from);
    addEdge(e, from, to);
  }

  private void addEdge(int e, int from, int to) {
    if (from == to) {
      return;
    }
    edgeOfPair[e >> 1] = edgeCount;
    edgeVertex[2 * edgeCount] = from;
    edgeVertex[2 * edgeCount + 1] = to;
    edgeSite[2 * edgeCount] = delaunay.siteOfRank(delaunay.origin(e));
    edgeSite[2 * edgeCount + 1] = delaunay.siteOfRank(delaunay.destination(e));
    edgeCount++;
  }

  private boolean centreInside(int face) {
    double cx = centre[2 * face];
    double cy = centre[2 * face + 1];
    return cx >= minX && cx <= maxX && cy >= minY && cy <= maxY;
  }

  private double parameter(int face, double mx, double my, double nx, double ny, double ifNone) {
    if (face == NONE) {
      return ifNone;
    }
    double dx = centre[2 * face] - mx;
    double dy = centre[2 * face + 1] - my;
    return (dx * nx + dy * ny) / (nx * nx + ny * ny);
  }

  /**
   * Cuts the parameters to a slab of the rectangle (Liang and Barsky 1984); false if nothing is
   * left.
   */
  private boolean clipSlab(double m, double n, double low, double high) {
    if (n == 0) {
      return m >= low && m <= high;
    }
    double t1 = (low - m) / n;
    double t2 = (high - m) / n;
    clipStart = Math.max(clipStart, Math.min(t1, t2));
    clipEnd = Math.min(clipEnd, Math.max(t1, t2));
    return clipStart < clipEnd;
  }

  private int vertexOfCentre(int face) {
    if (centreVertex[face] == UNSEEN) {
      centreVertex[face] = addVertex(centre[2 * face], centre[2 * face + 1]);
    }
    return centreVertex[face];
  }

  /**
   * The vertex at parameter t, put exactly on the border, or {@code other} if that is the same
   * point.
   */
  private int borderVertex(double mx, double my, double nx, double ny, double t, int other) {
    double px = mx + t * nx;
    double py = my + t * ny;
    double gapX = Math.min(Math.abs(px - minX), Math.abs(px - maxX));
    double gapY = Math.min(Math.abs(py - minY), Math.abs(py - maxY));
    if (gapX <= gapY) {
      px = Math.abs(px - minX) < Math.abs(px - maxX) ? minX : maxX;
    } else {
      py = Math.abs(py - minY) < Math.abs(py - maxY) ? minY : maxY;
    }
    px = Math.max(minX, Math.min(maxX, px));
    py = Math.max(minY, Math.min(maxY, py));
    if (other != NONE
        && Math.abs(px - vertex[2 * other]) <= samePoint
        && Math.abs(py - vertex[2 * other + 1]) <= samePoint) {
      return other;
    }
    return addVertex(px, py);
  }

  private int addVertex(double px, double py) {
    vertex[2 * vertexCount] = px;
    vertex[2 * vertexCount + 1] = py;
    return vertexCount++;
  }

  // ---- cells ----

  /** In the order of ranks, in which neighbours are near each other in memory. */
  private void makeCells(int n) {
    Arrays.fill(cellStart, 0, n, 0);
    Arrays.fill(cellEnd, 0, n, 0);
    int whole = edgeCount == 0 ? nearestToMiddle() : NONE;
    for (int rank = 0; rank < delaunay.count(); rank++) {
      int site = delaunay.siteOfRank(rank);
      cellStart[site] = cornerEnd;
      if (edgeCount > 0) {
        makeCell(rank, site);
      } else if (site == whole) {
        addCorners(0, 4, 0);
      }
      cellEnd[site] = cornerEnd;
    }
  }

  /** The site whose cell is the whole rectangle, when no edge crosses it. */
  private int nearestToMiddle() {
    double mx = 0.5 * (minX + maxX);
    double my = 0.5 * (minY + maxY);
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
    int start = cornerEnd;
    int firstEdge = delaunay.firstEdge(rank);
    int e = firstEdge;
    int lastTo = NONE;
    int lastNeighbour = NONE;
    do {
      int edge = edgeOfPair[e >> 1];
      if (edge != NONE) {
        // Edges were made from even Delaunay edges; from an odd one they are seen from their right
        // side, in reverse.
        int reverse = e & 1;
        int from = edgeVertex[2 * edge + reverse];
        int neighbour = edgeSite[2 * edge + 1 - reverse];
        if (lastTo != NONE && lastTo != from) {
          closeGap(lastTo, from, site, lastNeighbour);
        }
        addCorner(from, neighbour);
        lastTo = edgeVertex[2 * edge + 1 - reverse];
        lastNeighbour = neighbour;
      }
      e = delaunay.next(e);
    } while (e != firstEdge);
    if (cornerEnd > start && lastTo != cellVertex[start]) {
      closeGap(lastTo, cellVertex[start], site, lastNeighbour);
    }
  }

  private void addCorner(int v, int neighbour) {
    cellVertex[cornerEnd] = v;
    cellNeighbour[cornerEnd++] = neighbour;
  }

  /** Follows the border counter-clockwise from one vertex to another. */
  private void closeGap(int from, int to, int site, int neighbour) {
    addCorner(from, BORDER);
    double start = borderPosition(from);
    double end = borderPosition(to);
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
        corner[c] = addVertex(cornerX(c), cornerY(c));
      }
      addCorner(corner[c], BORDER);
    }
  }

  private double cornerX(int c) {
    return c == 0 || c == 3 ? minX : maxX;
  }

  private double cornerY(int c) {
    return c < 2 ? minY : maxY;
  }

  private boolean ownsCorner(int c, int site, int neighbour) {
    return squaredDistance(c, site) < squaredDistance(c, neighbour);
  }

  private double squaredDistance(int c, int site) {
    int rank = delaunay.rankOfSite(site);
    double dx = delaunay.x(rank) - cornerX(c);
    double dy = delaunay.y(rank) - cornerY(c);
    return dx * dx + dy * dy;
  }

  /** Position along the border, counter-clockwise from the lower left corner, a side counting 1. */
  private double borderPosition(int v) {
    double px = vertex[2 * v];
    double py = vertex[2 * v + 1];
    double fx = (px - minX) / (maxX - minX);
    double fy = (py - minY) / (maxY - minY);
    if (py == minY) {
      return fx;
    }
    if (px == maxX) {
      return 1 + fy;
    }
    if (py == maxY) {
      return 3 - fx;
    }
    return 4 - fy;
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
    return new VoronoiCheck(this, minX, minY, maxX, maxY).validate();
  }

  /** Whether edge e of the triangulation has a triangle on both sides. */
  boolean isInner(int e) {
    return leftFace[e] != NONE && leftFace[e ^ 1] != NONE;
  }
}
