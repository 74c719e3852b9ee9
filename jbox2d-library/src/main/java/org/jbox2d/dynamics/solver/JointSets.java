package org.jbox2d.dynamics.solver;

/**
 * The sets of bodies that joints tie to each other, not counting ways through what does not move:
 * chains, bridges, dolls. Contacts may unite many of them to one island, but none of them hangs on
 * the joints of another. Found by a disjoint-set forest (Tarjan 1975).
 */
final class JointSets {
  private int[] parent = new int[0];

  /** Of each set, at its root: number of joints. */
  private int[] links = new int[0];

  /** Of each set, at its root: the largest and the least inverse mass, 1/kg. */
  private float[] lightest = new float[0];

  private float[] heaviest = new float[0];

  /** Of each set, at its root: the largest {@link JointKernel#twist}, rad/s. */
  private float[] twist = new float[0];

  /** Of the worst set: by which factor one of its bodies is heavier than another. */
  float massRatio;

  /** Of the worst set: number of joints. */
  int mostLinks;

  /** Of the worst set: twist times number of joints, rad/s. */
  float worstTwist;

  /** Measures the sets of the joints {@code [from, to)}. */
  void measure(JointRows rows, SolverBodies bodies, int from, int to) {
    makeRoom(bodies.angle.length);
    for (int r = from; r < to; r++) {
      isolate(rows, r);
    }
    for (int r = from; r < to; r++) {
      unite(rows, bodies, r);
    }
    for (int r = from; r < to; r++) {
      add(rows, bodies, r);
    }
    massRatio = 1f;
    mostLinks = 0;
    worstTwist = 0f;
    for (int r = from; r < to; r++) {
      int slot = mover(rows, bodies, r);
      if (slot >= 0) {
        int root = rootOf(slot);
        massRatio = Math.max(massRatio, lightest[root] / heaviest[root]);
        mostLinks = Math.max(mostLinks, links[root]);
        worstTwist = Math.max(worstTwist, twist[root] * links[root]);
      }
    }
  }

  private void makeRoom(int slots) {
    if (parent.length < slots) {
      parent = new int[slots];
      links = new int[slots];
      lightest = new float[slots];
      heaviest = new float[slots];
      twist = new float[slots];
    }
  }

  private void isolate(JointRows rows, int row) {
    int at = rows.bodyAt[row];
    for (int k = at; k < at + rows.bodyCount[row]; k++) {
      int slot = rows.bodies[k];
      parent[slot] = slot;
      links[slot] = 0;
      lightest[slot] = 0f;
      heaviest[slot] = Float.MAX_VALUE;
      twist[slot] = 0f;
    }
  }

  private void unite(JointRows rows, SolverBodies bodies, int row) {
    int first = mover(rows, bodies, row);
    int at = rows.bodyAt[row];
    for (int k = at; k < at + rows.bodyCount[row]; k++) {
      int slot = rows.bodies[k];
      if (slot != first && isMover(bodies, slot)) {
        int a = rootOf(first);
        int b = rootOf(slot);
        parent[Math.max(a, b)] = Math.min(a, b);
      }
    }
  }

  private void add(JointRows rows, SolverBodies bodies, int row) {
    int first = mover(rows, bodies, row);
    if (first < 0) {
      return;
    }
    int root = rootOf(first);
    links[root]++;
    twist[root] = Math.max(twist[root], rows.kernel[row].twist(rows, row, bodies));
    int at = rows.bodyAt[row];
    for (int k = at; k < at + rows.bodyCount[row]; k++) {
      float m = bodies.mass[SolverBodies.STRIDE * rows.bodies[k]];
      if (m > 0f) {
        lightest[root] = Math.max(lightest[root], m);
        heaviest[root] = Math.min(heaviest[root], m);
      }
    }
  }

  /** The first body of a row that forces move; -1 if there is none. */
  private static int mover(JointRows rows, SolverBodies bodies, int row) {
    int at = rows.bodyAt[row];
    for (int k = at; k < at + rows.bodyCount[row]; k++) {
      if (isMover(bodies, rows.bodies[k])) {
        return rows.bodies[k];
      }
    }
    return -1;
  }

  private static boolean isMover(SolverBodies bodies, int slot) {
    return bodies.mass[SolverBodies.STRIDE * slot] > 0f;
  }

  private int rootOf(int slot) {
    int i = slot;
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }
}
