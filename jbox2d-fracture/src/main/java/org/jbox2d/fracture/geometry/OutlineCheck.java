package org.jbox2d.fracture.geometry;

/**
 * Finds the first reason why an outline is not a simple polygon with separate holes. Exact: an
 * outline passes if and only if no two edges share a point but the common end of neighbours, every
 * ring has area, and all holes are inside the outer ring and outside each other. Orientation and
 * collinear vertices do not matter.
 *
 * <p>Cost: O(n) for convex outlines, O(n log n) for those whose edges are short beside their
 * extent, O(n^2) at worst. An instance may be used again and then allocates nothing, unless there
 * is a defect to look for; not for use by two threads at once.
 */
public final class OutlineCheck {
  private final KeyOrder byLeftEnd = new KeyOrder();
  private int[] head = new int[0];
  private int[] ring = new int[0];
  private double[] left = new double[0];

  /** Boxes of the edges in the order of their left ends: left, right, lower, upper. */
  private double[] box = new double[0];

  private Outline outline;
  private boolean mayTouch;
  private boolean convex;
  private OutlineDefect defect = OutlineDefect.NONE;
  private int vertex = -1;
  private int other = -1;

  /** Checks an outline. */
  public static OutlineCheck of(Outline outline) {
    OutlineCheck check = new OutlineCheck();
    check.run(outline, false);
    return check;
  }

  /**
   * Checks an outline whose rings may touch others in common vertices, as the remainders of
   * fragmentations do.
   */
  public static OutlineCheck ofTouching(Outline outline) {
    OutlineCheck check = new OutlineCheck();
    check.run(outline, true);
    return check;
  }

  /**
   * Checks an outline; forgets the one before.
   *
   * @param ringsMayTouch whether rings may touch others in common vertices
   * @return whether it is valid
   */
  public boolean run(Outline given, boolean ringsMayTouch) {
    begin(given, ringsMayTouch);
    if (outline.foundValid && ringsMayTouch) {
      convex = outline.foundConvex;
      return true;
    }
    if (!finite() || !ringsLargeEnough()) {
      return false;
    }
    convex = isStrictlyConvex();
    boolean valid =
        (convex || (edgesHaveLength() && edgesApart())) && ringsHaveArea() && holesPlaced();
    outline.foundConvex = valid && convex;
    outline.foundValid = valid;
    return valid;
  }

  private boolean isStrictlyConvex() {
    return outline.ringCount() == 1
        && Rings.isStrictlyConvex(outline.coordinates(), 0, outline.vertexCount());
  }

  /** Whether the outline, if the last check found it valid, is strictly convex. */
  public boolean isConvex() {
    return convex;
  }

  /**
   * Checks all but whether edges meet others than their neighbours, in linear time for each ring:
   * for those who find that out on the way. Which defect is named if there are several may differ
   * from {@link #run}.
   */
  public boolean runButCrossings(Outline given, boolean ringsMayTouch) {
    begin(given, ringsMayTouch);
    boolean valid =
        finite() && ringsLargeEnough() && edgesHaveLength() && ringsHaveArea() && holesPlaced();
    convex = valid && isStrictlyConvex();
    return valid;
  }

  private void begin(Outline given, boolean ringsMayTouch) {
    outline = given;
    mayTouch = ringsMayTouch;
    convex = false;
    defect = OutlineDefect.NONE;
    vertex = -1;
    other = -1;
  }

  /** What is wrong, or {@link OutlineDefect#NONE}. */
  public OutlineDefect defect() {
    return defect;
  }

  /** The vertex the defect is at, or -1. */
  public int vertex() {
    return vertex;
  }

  /** The other vertex concerned, or -1. */
  public int otherVertex() {
    return other;
  }

  /** A sentence that names the vertex and what is wrong with it. */
  public String message() {
    if (defect == OutlineDefect.NONE) {
      return "outline is valid";
    }
    String where =
        vertex < 0 || vertex >= outline.vertexCount()
            ? "vertex " + vertex
            : "vertex " + vertex + " (" + outline.x(vertex) + ", " + outline.y(vertex) + ")";
    return where + " " + defect.text() + (other < 0 ? "" : " " + other);
  }

  private boolean fail(OutlineDefect reason, int i, int j) {
    defect = reason;
    vertex = i;
    other = j;
    return false;
  }

  private boolean finite() {
    for (int i = 0; i < outline.vertexCount(); i++) {
      double sum = outline.x(i) * 0 + outline.y(i) * 0;
      if (sum != 0) {
        return fail(OutlineDefect.NOT_FINITE, i, -1);
      }
    }
    return true;
  }

  private boolean ringsLargeEnough() {
    for (int r = 0; r < outline.ringCount(); r++) {
      if (outline.ringEnd(r) - outline.ringStart(r) < 3) {
        return fail(OutlineDefect.TOO_FEW_VERTICES, outline.ringStart(r), -1);
      }
    }
    return true;
  }

  private boolean edgesHaveLength() {
    for (int r = 0; r < outline.ringCount(); r++) {
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        int j = next(i, r);
        if (outline.x(i) == outline.x(j) && outline.y(i) == outline.y(j)) {
          return fail(OutlineDefect.REPEATED_VERTEX, i, j);
        }
      }
    }
    return true;
  }

  private boolean ringsHaveArea() {
    for (int r = 0; r < outline.ringCount(); r++) {
      if (outline.ringArea(r) == 0) {
        return fail(OutlineDefect.ZERO_AREA, outline.ringStart(r), -1);
      }
    }
    return true;
  }

  private int next(int i, int ring) {
    return i + 1 < outline.ringEnd(ring) ? i + 1 : outline.ringStart(ring);
  }

  private boolean edgesApart() {
    int n = outline.vertexCount();
    ensure(n);
    for (int r = 0; r < outline.ringCount(); r++) {
      for (int i = outline.ringStart(r); i < outline.ringEnd(r); i++) {
        int j = next(i, r);
        ring[i] = r;
        head[i] = j;
        left[i] = Math.min(outline.x(i), outline.x(j));
      }
    }
    int[] order = byLeftEnd.ascending(left, n);
    for (int k = 0; k < n; k++) {
      setBox(k, order[k]);
    }
    for (int k = 0; k < n; k++) {
      if (!apartFromLater(k, n, order)) {
        return false;
      }
    }
    return true;
  }

  private void ensure(int n) {
    if (head.length < n) {
      int size = n + n / 2;
      head = new int[size];
      ring = new int[size];
      left = new double[size];
      box = new double[4 * size];
    }
  }

  private void setBox(int k, int e) {
    double[] xy = outline.coordinates();
    int f = head[e];
    box[4 * k] = left[e];
    box[4 * k + 1] = Math.max(xy[2 * e], xy[2 * f]);
    box[4 * k + 2] = Math.min(xy[2 * e + 1], xy[2 * f + 1]);
    box[4 * k + 3] = Math.max(xy[2 * e + 1], xy[2 * f + 1]);
  }

  /** Compares the k-th edge with those that begin left of its right end, but not left of it. */
  private boolean apartFromLater(int k, int n, int[] order) {
    double right = box[4 * k + 1];
    double lower = box[4 * k + 2];
    double upper = box[4 * k + 3];
    int e = order[k];
    for (int l = k + 1; l < n && box[4 * l] <= right; l++) {
      // One branch for both: either alone is as likely as not.
      boolean near = box[4 * l + 2] <= upper & box[4 * l + 3] >= lower;
      int f = order[l];
      if (near
          && meet(e, head[e], f, head[f])
          && !(mayTouch && ring[e] != ring[f] && touchInVertex(e, head[e], f, head[f]))) {
        return failMeeting(e, f, ring[e] == ring[f]);
      }
    }
    return true;
  }

  private boolean failMeeting(int e, int f, boolean sameRing) {
    int low = Math.min(e, f);
    int high = Math.max(e, f);
    if (outline.x(e) == outline.x(f) && outline.y(e) == outline.y(f)) {
      return fail(sameRing ? OutlineDefect.REPEATED_VERTEX : OutlineDefect.RINGS_MEET, low, high);
    }
    int tipE = head[e];
    int tipF = head[f];
    if (sameRing
        && tipE != tipF
        && outline.x(tipE) == outline.x(tipF)
        && outline.y(tipE) == outline.y(tipF)) {
      return fail(OutlineDefect.REPEATED_VERTEX, Math.min(tipE, tipF), Math.max(tipE, tipF));
    }
    return fail(sameRing ? OutlineDefect.SELF_INTERSECTION : OutlineDefect.RINGS_MEET, low, high);
  }

  /**
   * Whether edges a-b and c-d, whose boxes overlap, share a point that is not their common end
   * vertex.
   */
  private boolean meet(int a, int b, int c, int d) {
    double[] xy = outline.coordinates();
    if (b == c) {
      return foldsBack(xy, a, b, d);
    }
    if (d == a) {
      return foldsBack(xy, c, a, b);
    }
    return Segments.touch(xy, a, b, c, d);
  }

  /**
   * Whether edges a-b and c-d of two rings, known to meet, do so only in an end of both, and the
   * rings do not cross there.
   */
  private boolean touchInVertex(int a, int b, int c, int d) {
    int e = same(a, c) || same(a, d) ? a : b;
    int f = same(e, c) ? c : d;
    if (!same(e, f)) {
      return false;
    }
    double[] xy = outline.coordinates();
    int tipE = e == a ? b : a;
    int tipF = f == c ? d : c;
    return (Predicates.orientation(xy, e, tipE, tipF) != 0 || foldsApart(xy, e, tipE, tipF))
        && !crossInVertex(e, f);
  }

  /**
   * Whether the rings through the same point at vertices v and w cross there: one edge of w is
   * inside the sector between the edges of v, the other is not. Edges that overlap are found
   * elsewhere.
   */
  private boolean crossInVertex(int v, int w) {
    int before = before(v);
    int after = head[v];
    return inSector(v, after, before, before(w)) != inSector(v, after, before, head[w]);
  }

  private int before(int i) {
    int r = ring[i];
    return i > outline.ringStart(r) ? i - 1 : outline.ringEnd(r) - 1;
  }

  /**
   * Whether the direction from v to p is in the sector from the direction of {@code from},
   * counter-clockwise, to that of {@code to}; it is neither of them.
   */
  private boolean inSector(int v, int from, int to, int p) {
    double[] xy = outline.coordinates();
    int turn = Predicates.orientation(xy, v, from, to);
    if (turn > 0) {
      return Predicates.orientation(xy, v, from, p) > 0 && Predicates.orientation(xy, v, p, to) > 0;
    }
    if (turn < 0) {
      return Predicates.orientation(xy, v, to, p) <= 0
          || Predicates.orientation(xy, v, p, from) <= 0;
    }
    return Predicates.orientation(xy, v, from, p) > 0;
  }

  private boolean same(int i, int j) {
    return outline.x(i) == outline.x(j) && outline.y(i) == outline.y(j);
  }

  /** For collinear points: whether a and b are on different sides of e. */
  private static boolean foldsApart(double[] xy, int e, int a, int b) {
    return (xy[2 * a] - xy[2 * e]) * (xy[2 * b] - xy[2 * e])
            + (xy[2 * a + 1] - xy[2 * e + 1]) * (xy[2 * b + 1] - xy[2 * e + 1])
        < 0;
  }

  private static boolean foldsBack(double[] xy, int a, int b, int c) {
    if (Predicates.orientation(xy, a, b, c) != 0) {
      return false;
    }
    double dot =
        (xy[2 * b] - xy[2 * a]) * (xy[2 * c] - xy[2 * b])
            + (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c + 1] - xy[2 * b + 1]);
    return dot < 0;
  }

  private boolean holesPlaced() {
    for (int r = 1; r < outline.ringCount(); r++) {
      int first = outline.ringStart(r);
      if (side(r, 0) < 0) {
        return fail(OutlineDefect.HOLE_OUTSIDE, first, -1);
      }
      for (int s = 1; s < outline.ringCount(); s++) {
        if (s != r && side(r, s) > 0) {
          return fail(OutlineDefect.HOLE_IN_HOLE, first, outline.ringStart(s));
        }
      }
    }
    return true;
  }

  /**
   * Where ring r is relative to ring s, which it does not cross: that of its first vertex that does
   * not touch s; if all do, that of its first edge, which starts in a vertex of s.
   *
   * @return +1 inside, -1 outside, 0 if all vertices touch s, but not in its vertices
   */
  private int side(int r, int s) {
    double[] xy = outline.coordinates();
    int side = 0;
    for (int i = outline.ringStart(r); side == 0 && i < outline.ringEnd(r); i++) {
      side = Rings.locate(xy, outline.ringStart(s), outline.ringEnd(s), xy[2 * i], xy[2 * i + 1]);
    }
    return side != 0 ? side : sideOfEdge(outline.ringStart(r), s);
  }

  private int sideOfEdge(int i, int s) {
    int start = outline.ringStart(s);
    int end = outline.ringEnd(s);
    boolean isLeftInside = outline.ringArea(s) > 0;
    for (int w = start; w < end; w++) {
      if (same(w, i)) {
        int before = w > start ? w - 1 : end - 1;
        int after = w + 1 < end ? w + 1 : start;
        return inSector(w, after, before, i + 1) == isLeftInside ? 1 : -1;
      }
    }
    return 0;
  }
}
