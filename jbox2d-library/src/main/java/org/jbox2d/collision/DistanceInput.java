package org.jbox2d.collision;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.common.Transform;

/** What {@link Distance} measures: two convex shapes and their transforms. */
public class DistanceInput {

  public DistanceProxy proxyA = new DistanceProxy();
  public DistanceProxy proxyB = new DistanceProxy();
  public Transform transformA = new Transform();
  public Transform transformB = new Transform();

  /** Whether the distance is taken between the skins instead of between the cores. */
  public boolean useRadii;

  public DistanceInput() {}
}
