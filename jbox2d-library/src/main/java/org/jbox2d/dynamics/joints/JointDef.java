package org.jbox2d.dynamics.joints;

import org.jbox2d.dynamics.Body;

/** What a joint is made from. */
public class JointDef {
  /** The kind of joint; set by the subclass. */
  public JointType type;

  /** Handed back by {@link Joint#getUserData()}. */
  public Object userData;

  /** The first body. */
  public Body bodyA;

  /** The second body. */
  public Body bodyB;

  /** Whether the two bodies collide with each other. */
  public boolean collideConnected;

  /** A definition of unknown type, for programs compiled against 2.2.1.1. */
  public JointDef() {
    this(JointType.UNKNOWN);
  }

  /** A definition of the given type. */
  public JointDef(JointType type) {
    this.type = type;
  }
}
