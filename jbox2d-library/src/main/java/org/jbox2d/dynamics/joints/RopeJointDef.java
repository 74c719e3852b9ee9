package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;

/** What a rope joint is made from. */
public class RopeJointDef extends JointDef {
  /** Point of body A, in its frame, m. */
  public final Vec2 localAnchorA = new Vec2(-1f, 0f);

  /** Point of body B, in its frame, m. */
  public final Vec2 localAnchorB = new Vec2(1f, 0f);

  /** Largest distance of the points, m; not negative. */
  public float maxLength;

  /** Anchors one to the left of A and one to the right of B, no length. */
  public RopeJointDef() {
    super(JointType.ROPE);
  }
}
