package org.jbox2d.dynamics;

import java.util.Arrays;
import org.jbox2d.common.Settings;
import org.jbox2d.dynamics.joints.Joint;
import org.jbox2d.dynamics.solver.JointRows;

/**
 * The joints of a step and their rows in the solver.
 *
 * <p>To visit thousands of joints that lie about in memory costs a sixth of the step of a net, so
 * rows are kept: while joints, their order and the slots of their bodies are those of the last
 * step, it writes and reads back the {@link JointRows#due} rows alone. A row that is not due holds
 * what its joint would write, and the joint reads its impulses there; see {@link Joint#keepRow}.
 *
 * <p>All rows are written anew where anything has changed that no joint notices: which joints and
 * bodies are awake ({@link Islands#jointBuilds}), contacts that unite islands and so bring joints
 * into another order, a centre of mass, and {@link Settings#linearSlop}, the least length of rods
 * and ropes.
 */
final class StepJoints {
  final JointRows rows = new JointRows();

  /** The joint of each row; its impulses may be there alone. */
  private Joint[] joints = new Joint[16];

  /** The {@link Islands#jointBuilds} and the slop with which the rows were written. */
  private int build;

  private float slop;

  /**
   * Brings the rows up to date. Bodies have their slots.
   *
   * @param sameCentres whether the centres of mass of all these bodies are those of the last step
   */
  void gather(Islands islands, boolean sameCentres) {
    boolean same = sameCentres && build == islands.jointBuilds && slop == Settings.linearSlop;
    if (same && isSameOrder(islands)) {
      writeDue();
    } else {
      writeAll(islands);
    }
  }

  /** Whether the joints, which are the same, are in the order of the rows. */
  private boolean isSameOrder(Islands islands) {
    for (int i = 0; i < rows.count; i++) {
      if (joints[i] != islands.joints[i]) {
        return false;
      }
    }
    return true;
  }

  private void writeDue() {
    int n = rows.dueCount;
    rows.dueCount = 0;
    for (int i = 0; i < n; i++) {
      // Adds at most as many rows as have been read.
      int row = rows.due[i];
      rows.rewrite(row);
      write(row);
    }
  }

  private void writeAll(Islands islands) {
    int before = rows.count;
    for (int r = 0; r < before; r++) {
      joints[r].takeBackRow();
    }
    rows.clear();
    int n = islands.jointCount;
    if (joints.length < n) {
      joints = new Joint[n + (n >> 1)];
    } else {
      Arrays.fill(joints, Math.min(n, before), before, null);
    }
    for (int r = 0; r < n; r++) {
      joints[r] = islands.joints[r];
      write(r);
    }
    build = islands.jointBuilds;
    slop = Settings.linearSlop;
  }

  private void write(int row) {
    Joint joint = joints[row];
    joint.gather(rows);
    if (!joint.keepRow(rows, row)) {
      rows.addDue(row);
    }
  }

  /** Lets the joints of rows that are not kept read their impulses. */
  void scatter() {
    for (int i = 0; i < rows.dueCount; i++) {
      int row = rows.due[i];
      joints[row].scatter(rows, row);
    }
  }
}
