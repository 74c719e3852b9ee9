package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a friction joint is made from. */
public class FrictionJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2();

  /** Largest force, N. */
  public float maxForce;

  /** Largest torque, N m. */
  public float maxTorque;

  /** Both origins, no force, no torque. */
  public FrictionJointDef() {
    super(JointType.FRICTION);
  }

  /** Takes bodies and anchor as they are now; the anchor is a world point. */
  public void initialize(Body bA, Body bB, Vec2 anchor) {
    JointChecks.notNull(bA, "bA");
    JointChecks.notNull(bB, "bB");
    JointChecks.finite(anchor, "anchor");
    bodyA = bA;
    bodyB = bB;
    bA.getLocalPointToOut(anchor, localAnchorA);
    bB.getLocalPointToOut(anchor, localAnchorB);
  }
}
