package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a motor joint is made from. */
public class MotorJointDef extends JointDef {
  /** Where the origin of body B is wanted, in A's frame, m. */
  public final Vec2 linearOffset = new Vec2();

  /** Which angle of body B less that of body A is wanted, rad. */
  public float angularOffset;

  /** Largest force, N. */
  public float maxForce = 1f;

  /** Largest torque, N m. */
  public float maxTorque = 1f;

  /** Share of the error that is to be removed in a step, 0 to 1. */
  public float correctionFactor = 0.3f;

  /** No offset, 1 N, 1 N m, correction factor 0.3. */
  public MotorJointDef() {
    super(JointType.MOTOR);
  }

  /** Takes bodies and offsets as they are now. */
  public void initialize(Body bA, Body bB) {
    JointChecks.notNull(bA, "bA");
    JointChecks.notNull(bB, "bB");
    bodyA = bA;
    bodyB = bB;
    bA.getLocalPointToOut(bB.getPosition(), linearOffset);
    angularOffset = bB.getAngle() - bA.getAngle();
  }
}
