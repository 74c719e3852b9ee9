package org.jbox2d.dynamics.joints;

import org.jbox2d.dynamics.Body;

/** A node in the list of joints of a body. Each joint has one for each of its two bodies. */
public class JointEdge {
  /** The body at the other end. */
  public Body other;

  /** The joint. */
  public Joint joint;

  /** The previous node of the body's list, or {@code null}. */
  public JointEdge prev;

  /** The next node of the body's list, or {@code null}. */
  public JointEdge next;

  /** A node that is in no list. */
  public JointEdge() {}
}
