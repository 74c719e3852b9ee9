package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a weld joint is made from. */
public class WeldJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2();

  /** Angle of body B minus that of body A, rad. */
  public float referenceAngle;

  /** Frequency of the spring that holds the angle, Hz; 0: rigid. */
  public float frequencyHz;

  /** Damping ratio of the spring: 0 none, 1 critical. */
  public float dampingRatio;

  /** Both origins, rigid. */
  public WeldJointDef() {
    super(JointType.WELD);
  }

  /** Takes bodies, anchor and reference angle as they are now; the anchor is a world point. */
  public void initialize(Body bA, Body bB, Vec2 anchor) {
    JointChecks.notNull(bA, "bA");
    JointChecks.notNull(bB, "bB");
    JointChecks.finite(anchor, "anchor");
    bodyA = bA;
    bodyB = bB;
    bA.getLocalPointToOut(anchor, localAnchorA);
    bB.getLocalPointToOut(anchor, localAnchorB);
    referenceAngle = bB.getAngle() - bA.getAngle();
  }
}
