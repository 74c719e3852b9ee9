package org.jbox2d.dynamics.solver;

import java.util.Arrays;

/**
 * The joint constraints of a step as flat records: for each row a kernel, the bodies it acts on,
 * and a block of floats whose layout the kernel defines. Rows are grouped by island and, within
 * one, by kernel.
 *
 * <p>A joint appends its row with {@link #add}, writes its parameters and kept impulses into the
 * block, and reads impulses back from the same block after the step. A row may be kept for the next
 * step, see {@link #due}: a kernel must leave parameters as they are, and not read what it has
 * written in an earlier step but the impulses.
 */
public final class JointRows {
  public int count;

  /** The kernel of each row, from {@link JointKernels}. */
  public JointKernel[] kernel = new JointKernel[0];

  /** Where the row's floats start in {@link #f}, and its body slots in {@link #bodies}. */
  public int[] floatAt = new int[0];

  public int[] bodyAt = new int[0];

  /** How many bodies the row acts on. */
  public int[] bodyCount = new int[0];

  public float[] f = new float[0];

  /** {@link SolverBodies#mass}, with the slots of the bodies of the row that is being added. */
  public float[] masses;

  public int[] bodies = new int[0];

  /**
   * Rows that their joints write in the next step: those of joints that write theirs in each step,
   * and of others that have been changed. The other rows are kept as the last step has left them.
   */
  public int[] due = new int[16];

  public int dueCount;

  /** The row that the next {@link #add} writes again, or -1. */
  private int rewritten = -1;

  private int floats;
  private int slots;

  /** Forgets all rows; keeps the memory. */
  public void clear() {
    count = 0;
    dueCount = 0;
    floats = 0;
    slots = 0;
  }

  /** Adds a row, not there yet, to {@link #due}. */
  public void addDue(int row) {
    if (dueCount == due.length) {
      due = Arrays.copyOf(due, 2 * dueCount);
    }
    due[dueCount++] = row;
  }

  /** Lets the next {@link #add} return a row that there is, of the same kind and length. */
  public void rewrite(int row) {
    rewritten = row;
  }

  /**
   * Appends a row with {@code floatCount} floats (set to 0) and {@code bodies} body slots (to be
   * filled in by the caller).
   *
   * @return the row's index
   */
  public int add(JointKernel k, int floatCount, int bodyCount) {
    if (rewritten >= 0) {
      int row = rewritten;
      rewritten = -1;
      Arrays.fill(f, floatAt[row], floatAt[row] + floatCount, 0f);
      return row;
    }
    int row = count++;
    if (count > kernel.length) {
      int capacity = Math.max(16, count + (count >> 1));
      kernel = Arrays.copyOf(kernel, capacity);
      floatAt = Arrays.copyOf(floatAt, capacity);
      bodyAt = Arrays.copyOf(bodyAt, capacity);
      this.bodyCount = Arrays.copyOf(this.bodyCount, capacity);
    }
    if (floats + floatCount > f.length) {
      f = Arrays.copyOf(f, Math.max(256, (floats + floatCount) + (f.length >> 1)));
    }
    if (slots + bodyCount > bodies.length) {
      bodies = Arrays.copyOf(bodies, Math.max(32, (slots + bodyCount) + (bodies.length >> 1)));
    }
    kernel[row] = k;
    floatAt[row] = floats;
    bodyAt[row] = slots;
    this.bodyCount[row] = bodyCount;
    Arrays.fill(f, floats, floats + floatCount, 0f);
    floats += floatCount;
    slots += bodyCount;
    return row;
  }

  /** Appends a row for two bodies. */
  public int add(JointKernel k, int floatCount, int slotA, int slotB) {
    int row = add(k, floatCount, 2);
    bodies[bodyAt[row]] = slotA;
    bodies[bodyAt[row] + 1] = slotB;
    return row;
  }

  /** Returns the end of the rows from {@code r} on, below {@code limit}, that share its kernel. */
  int endOfRun(int r, int limit) {
    JointKernel k = kernel[r];
    int end = r + 1;
    while (end < limit && kernel[end] == k) {
      end++;
    }
    return end;
  }
}
