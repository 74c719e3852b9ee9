package org.jbox2d.dynamics.solver;

import java.util.Arrays;

/**
 * The joint constraints of a step as flat records: for each row a kernel, the bodies it acts on,
 * and a block of floats whose layout the kernel defines. Rows are grouped by island and, within
 * one, by kernel.
 *
 * <p>A joint appends its row with {@link #add}, writes its parameters and kept impulses into the
 * block, and reads impulses back from the same block after the step.
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
  private int floats;
  private int slots;

  /** Forgets all rows; keeps the memory. */
  public void clear() {
    count = 0;
    floats = 0;
    slots = 0;
  }

  /**
   * Appends a row with {@code floatCount} floats (set to 0) and {@code bodies} body slots (to be
   * filled in by the caller).
   *
   * @return the row's index
   */
  public int add(JointKernel k, int floatCount, int bodyCount) {
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
