package org.jbox2d.dynamics.solver;

/**
 * The kernels of all kinds of joint, in the order in which an island's joints are solved. What is
 * solved last has the smallest error left when the iterations end, so what may give way comes
 * first, and what must hold last; with substeps, {@link HingeChains} after all.
 */
public final class JointKernels {
  public static final JointKernel MOUSE = new MouseKernel(0);

  /** Motor and friction joints. */
  public static final JointKernel DRIVE = new DriveKernel(1);

  public static final JointKernel GEAR = new GearKernel(2);
  public static final JointKernel CONSTANT_VOLUME = new ConstantVolumeKernel(3);
  public static final JointKernel PULLEY = new PulleyKernel(4);
  public static final JointKernel DISTANCE = new DistanceKernel(5);
  public static final JointKernel ROPE = new RopeKernel(6);
  public static final JointKernel WHEEL = new WheelKernel(7);
  public static final JointKernel PRISMATIC = new PrismaticKernel(8);
  public static final JointKernel REVOLUTE = new RevoluteKernel(9);
  public static final JointKernel WELD = new WeldKernel(10);

  /** How many kernels there are. */
  public static final int COUNT = 11;

  private JointKernels() {}
}
