package org.jbox2d.dynamics.joints;

/**
 * What a gear joint is made from. The bodies are those of the two joints; {@link #bodyA} and {@link
 * #bodyB} need not be set.
 */
public class GearJointDef extends JointDef {
  /** A revolute or prismatic joint. */
  public Joint joint1;

  /** Another revolute or prismatic joint. */
  public Joint joint2;

  /** How much coordinate 1 goes back when coordinate 2 goes on by 1; not 0, and must be set. */
  public float ratio;

  /** No joints, no ratio. */
  public GearJointDef() {
    super(JointType.GEAR);
  }
}
