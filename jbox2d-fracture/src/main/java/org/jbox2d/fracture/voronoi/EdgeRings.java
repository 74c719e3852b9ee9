package org.jbox2d.fracture.voronoi;

/**
 * The edges of a plane subdivision, each a pair of directed ones, e and {@code e ^ 1}. A directed
 * edge knows its origin and its neighbours among the edges of the same origin, counter-clockwise
 * ({@link #next}) and clockwise ({@link #previous}):
 *
 * <pre>
 *        next(e)
 *           \      left face of e
 *            \
 *   origin(e) o-----------&gt; e
 *            /
 *           /      right face of e
 *     previous(e)
 * </pre>
 *
 * <p>Source: L. Guibas, J. Stolfi, "Primitives for the Manipulation of General Subdivisions and the
 * Computation of Voronoi Diagrams", ACM Transactions on Graphics 4 (1985), without the dual edges.
 * All that is known of a pair lies together in one array, since what one step of an algorithm asks
 * for is nearly always all of it.
 */
final class EdgeRings {
  static final int NONE = -1;

  /** What is noted for a new edge. */
  static final int UNNOTED = -2;

  /** Elements of {@link #record} for a directed edge: origin, next, previous, note. */
  private static final int SHIFT = 2;

  private int[] record = new int[0];
  private int end;
  private int free;

  /** Forgets all edges; makes room for the given number of directed ones. */
  void clear(int capacity) {
    if (record.length < capacity << SHIFT) {
      record = new int[capacity << SHIFT];
    }
    end = 0;
    free = NONE;
  }

  /** One past the highest directed edge; not every number below is in use. */
  int end() {
    return end;
  }

  boolean isEdge(int e) {
    return record[e << SHIFT] >= 0;
  }

  int origin(int e) {
    return record[e << SHIFT];
  }

  int destination(int e) {
    return record[(e ^ 1) << SHIFT];
  }

  int next(int e) {
    return record[(e << SHIFT) + 1];
  }

  int previous(int e) {
    return record[(e << SHIFT) + 2];
  }

  /** Next edge along the face left of e, which starts where e ends. */
  int nextLeft(int e) {
    return record[((e ^ 1) << SHIFT) + 2];
  }

  /** What has been noted for e last. */
  int note(int e) {
    return record[(e << SHIFT) + 3];
  }

  void setNote(int e, int value) {
    record[(e << SHIFT) + 3] = value;
  }

  /**
   * All that is known of the edges, for loops over many: they keep it in a local variable and read
   * it with the methods below. Valid until {@link #clear}.
   */
  int[] records() {
    return record;
  }

  static int origin(int[] records, int e) {
    return records[e << SHIFT];
  }

  static int next(int[] records, int e) {
    return records[(e << SHIFT) + 1];
  }

  static int nextLeft(int[] records, int e) {
    return records[((e ^ 1) << SHIFT) + 2];
  }

  static int note(int[] records, int e) {
    return records[(e << SHIFT) + 3];
  }

  static void setNote(int[] records, int e, int value) {
    records[(e << SHIFT) + 3] = value;
  }

  /** Makes an edge that is alone at both its ends. */
  int make(int from, int to) {
    int e = free;
    if (e == NONE) {
      e = end;
      end += 2;
    } else {
      free = next(e);
    }
    int k = e << SHIFT;
    record[k] = from;
    record[k + 1] = e;
    record[k + 2] = e;
    record[k + 3] = UNNOTED;
    record[k + (1 << SHIFT)] = to;
    record[k + (1 << SHIFT) + 1] = e + 1;
    record[k + (1 << SHIFT) + 2] = e + 1;
    record[k + (1 << SHIFT) + 3] = UNNOTED;
    return e;
  }

  /**
   * Joins the edge rings of a and b if they are apart, or cuts them apart if they are one (section
   * 4).
   */
  void splice(int a, int b) {
    int afterA = next(a);
    int afterB = next(b);
    link(a, afterB);
    link(b, afterA);
  }

  private void link(int e, int following) {
    record[(e << SHIFT) + 1] = following;
    record[(following << SHIFT) + 2] = e;
  }

  /** New edge from the end of a to the start of b, such that all three have the same left face. */
  int connect(int a, int b) {
    return connect(a, b, destination(a), origin(b));
  }

  /** The same, for those who know where the edge starts and ends. */
  int connect(int a, int b, int from, int to) {
    int e = make(from, to);
    int x = nextLeft(a);
    int y = next(b);
    link(x, e);
    link(e, a ^ 1);
    link(b, e ^ 1);
    link(e ^ 1, y);
    return e;
  }

  void delete(int e) {
    link(previous(e), next(e));
    link(previous(e ^ 1), next(e ^ 1));
    int even = e & ~1;
    record[even << SHIFT] = NONE;
    record[(even + 1) << SHIFT] = NONE;
    record[(even << SHIFT) + 1] = free;
    free = even;
  }

  /**
   * Replaces the diagonal e of the quadrilateral of its two triangles by the other diagonal; e
   * keeps its number and turns counter-clockwise.
   */
  void flip(int e) {
    int a = previous(e);
    int b = previous(e ^ 1);
    splice(e, a);
    splice(e ^ 1, b);
    splice(e, nextLeft(a));
    splice(e ^ 1, nextLeft(b));
    record[e << SHIFT] = destination(a);
    record[(e ^ 1) << SHIFT] = destination(b);
  }

  /** Enters for each origin the last of its edges. */
  void collectOrigins(int[] edgeOf) {
    for (int e = 0; e < end; e++) {
      int from = record[e << SHIFT];
      if (from >= 0) {
        edgeOf[from] = e;
      }
    }
  }
}
