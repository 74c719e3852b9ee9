package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a prismatic joint is made from. */
public class PrismaticJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2();

  /** Direction in which B slides, in A's frame; of any length but 0. */
  public final Vec2 localAxisA = new Vec2(1f, 0f);

  /** Angle of body B minus that of body A, rad. */
  public float referenceAngle;

  /** Whether the limits hold. */
  public boolean enableLimit;

  /** Least translation, m. */
  public float lowerTranslation;

  /** Largest translation, m. */
  public float upperTranslation;

  /** Whether the motor runs. */
  public boolean enableMotor;

  /** Largest force of the motor, N. */
  public float maxMotorForce;

  /** Speed of the motor, m/s. */
  public float motorSpeed;

  /** Both origins, along x, no limits, no motor. */
  public PrismaticJointDef() {
    super(JointType.PRISMATIC);
  }

  /**
   * Takes bodies, anchor and reference angle as they are now; anchor and axis are those of the
   * world.
   */
  public void initialize(Body b1, Body b2, Vec2 anchor, Vec2 axis) {
    JointChecks.notNull(b1, "b1");
    JointChecks.notNull(b2, "b2");
    JointChecks.finite(anchor, "anchor");
    JointChecks.finite(axis, "axis");
    bodyA = b1;
    bodyB = b2;
    b1.getLocalPointToOut(anchor, localAnchorA);
    b2.getLocalPointToOut(anchor, localAnchorB);
    b1.getLocalVectorToOut(axis, localAxisA);
    referenceAngle = b2.getAngle() - b1.getAngle();
  }
}
