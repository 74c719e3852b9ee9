package org.jbox2d.dynamics.solver;

/**
 * The kernels of all kinds of joint, in the order in which an island's joints are solved. What is
 * solved last has the smallest error left when the iterations end, so what may give way comes
 * first, and what must hold last.
 */
public final class JointKernels {
  public static final JointKernel MOUSE = new MouseKernel(0);
  public static final JointKernel DISTANCE = new DistanceKernel(1);
  public static final JointKernel ROPE = new RopeKernel(2);
  public static final JointKernel REVOLUTE = new RevoluteKernel(3);

  /** How many kernels there are. */
  public static final int COUNT = 4;

  private JointKernels() {}
}
