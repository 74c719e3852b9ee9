package org.jbox2d.collision;

import org.jbox2d.common.Vec2;

/** A contact point of a {@link Manifold}, with the impulses that carry over to the next step. */
public class ManifoldPoint {

  /** In coordinates of A or B as {@link Manifold#type} says. */
  public final Vec2 localPoint;

  /** Impulse along the normal that holds the shapes apart, in N s. */
  public float normalImpulse;

  /** Friction impulse, in N s. */
  public float tangentImpulse;

  /** The features that meet here. */
  public final ContactID id;

  public ManifoldPoint() {
    localPoint = new Vec2();
    id = new ContactID();
  }

  /** Copies {@code cp}. */
  public ManifoldPoint(ManifoldPoint cp) {
    this();
    set(cp);
  }

  public void set(ManifoldPoint cp) {
    localPoint.set(cp.localPoint);
    normalImpulse = cp.normalImpulse;
    tangentImpulse = cp.tangentImpulse;
    id.set(cp.id);
  }
}
