package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a wheel joint is made from: body A is the chassis, body B the wheel. */
public class WheelJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2();

  /** Direction of the suspension, in A's frame; of any length but 0. */
  public final Vec2 localAxisA = new Vec2(1f, 0f);

  /** Whether the motor runs. */
  public boolean enableMotor;

  /** Largest torque of the motor, N m. */
  public float maxMotorTorque;

  /** Speed of the motor, rad/s. */
  public float motorSpeed;

  /** Frequency of the suspension, Hz; 0: no spring. */
  public float frequencyHz;

  /** Damping ratio of the suspension: 0 none, 1 critical. */
  public float dampingRatio;

  /** Both origins, along x, no spring, no motor. */
  public WheelJointDef() {
    super(JointType.WHEEL);
  }

  /** Takes bodies and anchor as they are now; anchor and axis are those of the world. */
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
  }
}
