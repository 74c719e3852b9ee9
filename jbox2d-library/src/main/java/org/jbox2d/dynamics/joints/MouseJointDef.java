package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;

/** What a mouse joint is made from. Body A is not moved; it serves as the other end. */
public class MouseJointDef extends JointDef {
  /** World point on body B that is to be dragged, m. */
  public final Vec2 target = new Vec2();

  /** Largest force, N. Usually some multiple of the body's weight. */
  public float maxForce;

  /** Frequency of the spring, Hz. */
  public float frequencyHz;

  /** Damping ratio: 0 none, 1 critical. */
  public float dampingRatio;

  /** No force, 5 Hz, damping ratio 0.7. */
  public MouseJointDef() {
    super(JointType.MOUSE);
    frequencyHz = 5f;
    dampingRatio = 0.7f;
  }
}
