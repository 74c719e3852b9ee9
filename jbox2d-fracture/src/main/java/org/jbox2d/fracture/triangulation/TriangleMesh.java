package org.jbox2d.fracture.triangulation;

import java.util.Arrays;

/**
 * Counter-clockwise triangles over the vertices of an outline. Half-edge h belongs to triangle h /
 * 3 and runs from its vertex h to its vertex {@link #following}(h).
 */
public final class TriangleMesh {
  private int count;
  private int[] vertex = new int[96];
  private int[] twin = new int[96];
  private int[] start = new int[32];
  private int[] fan = new int[96];

  /** Forgets all triangles. */
  public void clear() {
    count = 0;
  }

  /** Adds a counter-clockwise triangle; its half-edges know no twins until they are linked. */
  public void add(int a, int b, int c) {
    if (count + 3 > vertex.length) {
      vertex = Arrays.copyOf(vertex, 2 * vertex.length);
      twin = Arrays.copyOf(twin, vertex.length);
    }
    twin[count] = -1;
    twin[count + 1] = -1;
    twin[count + 2] = -1;
    vertex[count++] = a;
    vertex[count++] = b;
    vertex[count++] = c;
  }

  /** Number of triangles. */
  public int triangleCount() {
    return count / 3;
  }

  /** Number of half-edges. */
  public int halfEdgeCount() {
    return count;
  }

  /** Vertex a half-edge starts from. */
  public int vertex(int h) {
    return vertex[h];
  }

  /** Next half-edge of the same triangle. */
  public static int following(int h) {
    return h % 3 == 2 ? h - 2 : h + 1;
  }

  /** The half-edge on the other side, or -1; see {@link #link} and {@link #linkTwins}. */
  public int twin(int h) {
    return twin[h];
  }

  /** Makes two half-edges that run between the same vertices, in opposite directions, twins. */
  void linkTwins(int h, int k) {
    twin[h] = k;
    twin[k] = h;
  }

  /**
   * Finds the twins of all half-edges.
   *
   * @param vertexCount number of vertices of the outline
   * @return false if two half-edges run between the same vertices in the same direction: triangles
   *     overlap
   */
  public boolean link(int vertexCount) {
    if (start.length < vertexCount + 1) {
      start = new int[2 * vertexCount + 1];
    }
    if (fan.length < count) {
      fan = new int[vertex.length];
    }
    Arrays.fill(start, 0, vertexCount + 1, 0);
    for (int h = 0; h < count; h++) {
      start[vertex[h]]++;
    }
    for (int v = 0; v < vertexCount; v++) {
      start[v + 1] += start[v];
    }
    for (int h = count - 1; h >= 0; h--) {
      fan[--start[vertex[h]]] = h;
    }
    for (int h = 0; h < count; h++) {
      int from = vertex[h];
      int to = vertex[following(h)];
      twin[h] = find(to, from);
      if (find(from, to) != h) {
        return false;
      }
    }
    return true;
  }

  private int find(int from, int to) {
    for (int k = start[from]; k < start[from + 1]; k++) {
      if (vertex[following(fan[k])] == to) {
        return fan[k];
      }
    }
    return -1;
  }
}
