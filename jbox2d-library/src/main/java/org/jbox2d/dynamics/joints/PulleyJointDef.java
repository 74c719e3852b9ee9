package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/** What a pulley joint is made from. */
public class PulleyJointDef extends JointDef {
  /** Fixed point above body A, in the world, m. */
  public Vec2 groundAnchorA = new Vec2(-1f, 1f);

  /** Fixed point above body B, in the world, m. */
  public Vec2 groundAnchorB = new Vec2(1f, 1f);

  /** Point of body A, in its frame, m. */
  public Vec2 localAnchorA = new Vec2(-1f, 0f);

  /** Point of body B, in its frame, m. */
  public Vec2 localAnchorB = new Vec2(1f, 0f);

  /** Length of the rope on side A, m. */
  public float lengthA;

  /** Length of the rope on side B, m. */
  public float lengthB;

  /** How much shorter side A gets when side B gets longer by 1; positive. */
  public float ratio = 1f;

  /** Fixed points above the anchors, no rope, ratio 1, bodies that collide with each other. */
  public PulleyJointDef() {
    super(JointType.PULLEY);
    collideConnected = true;
  }

  /** Takes bodies, anchors and lengths as they are now; all points are those of the world. */
  public void initialize(
      Body b1, Body b2, Vec2 ga1, Vec2 ga2, Vec2 anchor1, Vec2 anchor2, float r) {
    JointChecks.notNull(b1, "b1");
    JointChecks.notNull(b2, "b2");
    JointChecks.finite(ga1, "ga1");
    JointChecks.finite(ga2, "ga2");
    JointChecks.finite(anchor1, "anchor1");
    JointChecks.finite(anchor2, "anchor2");
    bodyA = b1;
    bodyB = b2;
    groundAnchorA = new Vec2(ga1);
    groundAnchorB = new Vec2(ga2);
    localAnchorA = b1.getLocalPoint(anchor1);
    localAnchorB = b2.getLocalPoint(anchor2);
    lengthA = distance(anchor1, ga1);
    lengthB = distance(anchor2, ga2);
    ratio = r;
  }

  private static float distance(Vec2 p, Vec2 q) {
    float dx = p.x - q.x;
    float dy = p.y - q.y;
    return (float) Math.sqrt(dx * dx + dy * dy);
  }
}
