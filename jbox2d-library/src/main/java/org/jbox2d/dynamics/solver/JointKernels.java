package org.jbox2d.dynamics.solver;

/** The kernels of all kinds of joint, in the order in which an island's joints are solved. */
public final class JointKernels {
  public static final JointKernel MOUSE = new MouseKernel(0);

  /** How many kernels there are. */
  public static final int COUNT = 1;

  private JointKernels() {}
}
