package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.Predicates;

/**
 * The least number of convex parts of a simple polygon without holes, cut along diagonals, vertices
 * per part not limited. Exact, by dynamic programming; for small polygons and as an oracle for
 * {@link HertelMehlhorn}.
 *
 * <p>The problem is that of J. M. Keil, "Decomposing a polygon into simpler components", SIAM
 * Journal on Computing 14 (1985). The recurrence here is a plainer one: let m(i, j) be the least
 * number of parts of the polygon i, i + 1, ..., j cut off by the diagonal i-j, and 0 if i-j is an
 * edge. The part at the diagonal is a convex chain i = v0, v1, ..., vk = j, and
 *
 * <pre>
 * m(i, j) = 1 + min over convex chains of the sum of m(v, v')
 * </pre>
 *
 * over the links of the chain. For fixed i and v1 the best chain that ends in the link u-v is
 * best(u, v). Time O(n^5) with a small constant, memory O(n^2).
 */
public final class MinimumDecomposition {
  /** Polygons of more vertices take seconds. */
  public static final int MOST_VERTICES = 64;

  private static final int IMPOSSIBLE = Integer.MAX_VALUE / 4;

  private final double[] xy;
  private final int n;
  private final boolean[][] linked;
  private final int[][] least;
  private final int[][] best;

  private MinimumDecomposition(Outline outline) {
    xy = outline.coordinates();
    n = outline.vertexCount();
    linked = new boolean[n][n];
    least = new int[n][n];
    best = new int[n][n];
  }

  /**
   * Computes the least number of parts.
   *
   * @param outline simple, without holes, either orientation
   * @throws IllegalArgumentException if it has holes or more than {@link #MOST_VERTICES} vertices
   */
  public static int parts(Outline outline) {
    if (outline.ringCount() > 1 || outline.vertexCount() > MOST_VERTICES) {
      throw new IllegalArgumentException(
          "rings: " + outline.ringCount() + ", vertices: " + outline.vertexCount());
    }
    return new MinimumDecomposition(outline.normal()).compute();
  }

  private int compute() {
    for (int i = 0; i < n; i++) {
      for (int j = i + 1; j < n; j++) {
        linked[i][j] = j == i + 1 || (i == 0 && j == n - 1) || isDiagonal(i, j);
      }
    }
    for (int i = n - 2; i >= 0; i--) {
      Arrays.fill(least[i], IMPOSSIBLE);
      for (int first = i + 1; first < n; first++) {
        if (first == i + 1) {
          least[i][first] = 0;
        }
        if (linked[i][first] && least[i][first] < IMPOSSIBLE) {
          extendFrom(i, first);
        }
      }
    }
    return least[0][n - 1];
  }

  /** Extends convex chains i, first, ... and closes them with the diagonals from i. */
  private void extendFrom(int i, int first) {
    for (int u = first; u < n; u++) {
      Arrays.fill(best[u], IMPOSSIBLE);
    }
    for (int v = first + 1; v < n; v++) {
      for (int u = first; u < v; u++) {
        if (!linked[u][v] || least[u][v] >= IMPOSSIBLE) {
          continue;
        }
        int chain = u == first ? startingWith(i, first, v) : cheapest(first, u, v);
        if (chain < IMPOSSIBLE) {
          best[u][v] = chain + least[u][v];
          close(i, first, u, v);
        }
      }
    }
  }

  private int startingWith(int i, int first, int v) {
    return turn(i, first, v) >= 0 ? least[i][first] : IMPOSSIBLE;
  }

  private int cheapest(int first, int u, int v) {
    int least = IMPOSSIBLE;
    for (int t = first; t < u; t++) {
      if (best[t][u] < least && turn(t, u, v) >= 0) {
        least = best[t][u];
      }
    }
    return least;
  }

  private void close(int i, int first, int u, int v) {
    if (linked[i][v] && turn(u, v, i) >= 0 && turn(v, i, first) >= 0 && turn(i, first, v) > 0) {
      least[i][v] = Math.min(least[i][v], 1 + best[u][v]);
    }
  }

  private int turn(int a, int b, int c) {
    return Predicates.orientation(xy, a, b, c);
  }

  /** Whether i-j runs inside the polygon and touches it in its ends only. */
  private boolean isDiagonal(int i, int j) {
    if (!inCone(i, j) || !inCone(j, i)) {
      return false;
    }
    for (int k = 0; k < n; k++) {
      int l = k + 1 == n ? 0 : k + 1;
      if (k != i
          && k != j
          && l != i
          && l != j
          && org.jbox2d.fracture.geometry.Segments.touch(xy, i, j, k, l)) {
        return false;
      }
    }
    return true;
  }

  /** Whether the direction from i to j points strictly inside at i. */
  private boolean inCone(int i, int j) {
    int before = i == 0 ? n - 1 : i - 1;
    int after = i == n - 1 ? 0 : i + 1;
    if (turn(before, i, after) >= 0) {
      return turn(i, j, before) > 0 && turn(j, i, after) > 0;
    }
    return !(turn(i, j, after) >= 0 && turn(j, i, before) >= 0);
  }
}
