package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a distance joint is made from. */
public class DistanceJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2();

  /** Distance of the points, m; not negative. */
  public float length = 1f;

  /** Frequency of the spring, Hz; 0: rigid. */
  public float frequencyHz;

  /** Damping ratio of the spring: 0 none, 1 critical. */
  public float dampingRatio;

  /** Both origins, 1 m apart, rigid. */
  public DistanceJointDef() {
    super(JointType.DISTANCE);
  }

  /** Takes bodies, anchors and length as they are now; anchors are world points. */
  public void initialize(Body b1, Body b2, Vec2 anchor1, Vec2 anchor2) {
    JointChecks.notNull(b1, "b1");
    JointChecks.notNull(b2, "b2");
    JointChecks.finite(anchor1, "anchor1");
    JointChecks.finite(anchor2, "anchor2");
    bodyA = b1;
    bodyB = b2;
    b1.getLocalPointToOut(anchor1, localAnchorA);
    b2.getLocalPointToOut(anchor2, localAnchorB);
    float dx = anchor2.x - anchor1.x;
    float dy = anchor2.y - anchor1.y;
    length = (float) Math.sqrt(dx * dx + dy * dy);
  }
}
