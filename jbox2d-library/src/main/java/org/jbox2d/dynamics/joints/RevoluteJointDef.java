package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a revolute joint is made from. */
public class RevoluteJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public Vec2 localAnchorB = new Vec2();

  /** Angle of body B minus that of body A where the joint's angle is 0, rad. */
  public float referenceAngle;

  /** Whether the limits hold. */
  public boolean enableLimit;

  /** Least angle of the joint, rad. */
  public float lowerAngle;

  /** Largest angle of the joint, rad. */
  public float upperAngle;

  /** Whether the motor runs. */
  public boolean enableMotor;

  /** Speed of the motor, rad/s. */
  public float motorSpeed;

  /** Largest torque of the motor, N m. */
  public float maxMotorTorque;

  /** Both origins, no limits, no motor. */
  public RevoluteJointDef() {
    super(JointType.REVOLUTE);
  }

  /** Takes bodies, anchor and reference angle as they are now; the anchor is a world point. */
  public void initialize(Body b1, Body b2, Vec2 anchor) {
    JointChecks.notNull(b1, "b1");
    JointChecks.notNull(b2, "b2");
    JointChecks.finite(anchor, "anchor");
    bodyA = b1;
    bodyB = b2;
    b1.getLocalPointToOut(anchor, localAnchorA);
    b2.getLocalPointToOut(anchor, localAnchorB);
    referenceAngle = b2.getAngle() - b1.getAngle();
  }
}
