package org.jbox2d.callbacks;

import org.jbox2d.common.Settings;

/**
 * The impulses of a solved contact in N s, one element a contact point; the first {@link #count}
 * are in use.
 */
public class ContactImpulse {

  /** Along the normal, not negative. */
  public float[] normalImpulses = new float[Settings.maxManifoldPoints];

  /** Along the tangent. */
  public float[] tangentImpulses = new float[Settings.maxManifoldPoints];

  /** Number of contact points. */
  public int count;

  public ContactImpulse() {}
}
