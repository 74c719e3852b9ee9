package org.jbox2d.fracture.voronoi;

/**
 * The edges of a Voronoi diagram inside a rectangle, and the table of their vertices. The dual of
 * each Delaunay edge between different circumcentres is one, as far as it is inside. Owns its
 * arrays and reuses them.
 */
final class DualEdges {
  private static final int NONE = -1;

  /** A centre outside the rectangle is no vertex; nor is one that does not exist. */
  private static final int OUTSIDE = -2;

  /** Logarithm of the numbers of an edge in {@link #record}: from, to, site left, site right. */
  static final int SHIFT = 2;

  private Delaunay delaunay;
  private Circumcentres centres;
  private Clip clip;

  private int vertexCount;
  private double[] vertex = new double[0];

  /** For each face the vertex its centre has become, {@link #NONE} yet, or {@link #OUTSIDE}. */
  private int[] vertexOfFace = new int[0];

  private int count;
  private int[] record = new int[0];

  /** Start and end parameters of the clipped edge, what {@link #clipSlab} cuts. */
  private double clipStart;

  private double clipEnd;

  /**
   * Makes the edges from the faces noted at the Delaunay edges, and notes there, in both directions
   * alike, the dual edge or -1. It is seen from the even one of its pair.
   */
  void compute(Delaunay triangulation, Circumcentres faces, Clip rectangle) {
    delaunay = triangulation;
    centres = faces;
    clip = rectangle;
    ensure(delaunay.edgeEnd());
    for (int f = 0; f < centres.count(); f++) {
      vertexOfFace[f] = clip.contains(centres.x(f), centres.y(f)) ? NONE : OUTSIDE;
    }
    vertexCount = 0;
    count = 0;
    makeEdges();
  }

  /** Most edges run between two circumcentres inside: these are made here, others are clipped. */
  private void makeEdges() {
    int[] records = delaunay.records();
    int directed = delaunay.edgeEnd();
    for (int e = 0; e < directed; e += 2) {
      int a = EdgeRings.origin(records, e);
      if (a < 0) {
        continue;
      }
      int left = EdgeRings.note(records, e);
      int right = EdgeRings.note(records, e + 1);
      int made = count;
      if (left != right || left == Circumcentres.NONE) {
        if ((left | right) >= 0 && Math.min(vertexOfFace[left], vertexOfFace[right]) != OUTSIDE) {
          int from = vertexOfCentre(right);
          int to = vertexOfCentre(left);
          add(from, to, a, EdgeRings.origin(records, e + 1));
        } else {
          makeClippedEdge(e, right, left);
        }
      }
      made = count > made ? made : NONE;
      EdgeRings.setNote(records, e, made);
      EdgeRings.setNote(records, e + 1, made);
    }
  }

  private void ensure(int directed) {
    if (record.length < directed / 2 << SHIFT) {
      record = new int[(directed / 2 << SHIFT) * 3 / 2];
    }
    if (vertexOfFace.length < centres.count()) {
      vertexOfFace = new int[centres.count() + centres.count() / 2];
    }
    // A vertex is a circumcentre, an end of a clipped edge, or a corner of the rectangle.
    int vertices = directed + directed / 2 + 4;
    if (vertex.length < 2 * vertices) {
      vertex = new double[3 * vertices];
    }
  }

  int vertexCount() {
    return vertexCount;
  }

  double x(int v) {
    return vertex[2 * v];
  }

  double y(int v) {
    return vertex[2 * v + 1];
  }

  int count() {
    return count;
  }

  /** All edges, four numbers for each: from, to, site left, site right; not a copy. */
  int[] records() {
    return record;
  }

  int from(int edge) {
    return record[edge << SHIFT];
  }

  int to(int edge) {
    return record[(edge << SHIFT) + 1];
  }

  int left(int edge) {
    return record[(edge << SHIFT) + 2];
  }

  int right(int edge) {
    return record[(edge << SHIFT) + 3];
  }

  int addVertex(double x, double y) {
    vertex[2 * vertexCount] = x;
    vertex[2 * vertexCount + 1] = y;
    return vertexCount++;
  }

  /**
   * The bisector of the sites a, b of a Delaunay edge is m + t n, with m the midpoint and n = b - a
   * turned by +90 degrees; t runs from the circumcentre on the right, or minus infinity, to that on
   * the left, or infinity. Clipped by its parameter: a circumcentre far away, known only roughly,
   * does not tilt the part inside.
   */
  private void makeClippedEdge(int e, int right, int left) {
    boolean startInside = isInside(right);
    boolean endInside = isInside(left);
    int a = delaunay.origin(e);
    int b = delaunay.destination(e);
    double nx = -(delaunay.y(b) - delaunay.y(a));
    double ny = delaunay.x(b) - delaunay.x(a);
    double mx = delaunay.x(a) + 0.5 * ny;
    double my = delaunay.y(a) - 0.5 * nx;
    clipStart = parameter(right, mx, my, nx, ny, Double.NEGATIVE_INFINITY);
    clipEnd = parameter(left, mx, my, nx, ny, Double.POSITIVE_INFINITY);
    boolean hits = clipSlab(mx, nx, clip.minX, clip.maxX) && clipSlab(my, ny, clip.minY, clip.maxY);
    if (!hits && !startInside && !endInside) {
      return;
    }
    int from = startInside ? vertexOfCentre(right) : NONE;
    int to = endInside ? vertexOfCentre(left) : NONE;
    from = from != NONE ? from : borderVertex(mx, my, nx, ny, clipStart, to);
    to = to != NONE ? to : borderVertex(mx, my, nx, ny, clipEnd, from);
    add(from, to, a, b);
  }

  /** Adds the dual of the Delaunay edge from rank a to rank b, unless its ends are the same. */
  private void add(int from, int to, int a, int b) {
    int k = count << SHIFT;
    record[k] = from;
    record[k + 1] = to;
    record[k + 2] = delaunay.siteOfRank(a);
    record[k + 3] = delaunay.siteOfRank(b);
    count += from == to ? 0 : 1;
  }

  private boolean isInside(int face) {
    return face != Circumcentres.NONE && vertexOfFace[face] != OUTSIDE;
  }

  private double parameter(int face, double mx, double my, double nx, double ny, double ifNone) {
    if (face == Circumcentres.NONE) {
      return ifNone;
    }
    double dx = centres.x(face) - mx;
    double dy = centres.y(face) - my;
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

  /** The vertex of a face whose centre is inside, made if need be: that is one time in three. */
  private int vertexOfCentre(int face) {
    int known = vertexOfFace[face];
    int isNew = known >> 31;
    vertex[2 * vertexCount] = centres.x(face);
    vertex[2 * vertexCount + 1] = centres.y(face);
    int v = known ^ ((known ^ vertexCount) & isNew);
    vertexCount -= isNew;
    vertexOfFace[face] = v;
    return v;
  }

  /**
   * The vertex at parameter t, put exactly on the border, or {@code other} if that is the same
   * point.
   */
  private int borderVertex(double mx, double my, double nx, double ny, double t, int other) {
    double px = mx + t * nx;
    double py = my + t * ny;
    double gapX = Math.min(Math.abs(px - clip.minX), Math.abs(px - clip.maxX));
    double gapY = Math.min(Math.abs(py - clip.minY), Math.abs(py - clip.maxY));
    if (gapX <= gapY) {
      px = Math.abs(px - clip.minX) < Math.abs(px - clip.maxX) ? clip.minX : clip.maxX;
    } else {
      py = Math.abs(py - clip.minY) < Math.abs(py - clip.maxY) ? clip.minY : clip.maxY;
    }
    px = Math.max(clip.minX, Math.min(clip.maxX, px));
    py = Math.max(clip.minY, Math.min(clip.maxY, py));
    if (other != NONE
        && Math.abs(px - x(other)) <= clip.samePoint
        && Math.abs(py - y(other)) <= clip.samePoint) {
      return other;
    }
    return addVertex(px, py);
  }
}
