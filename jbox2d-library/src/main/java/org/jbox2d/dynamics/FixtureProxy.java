package org.jbox2d.dynamics;

import org.jbox2d.collision.AABB;

/** A child of a fixture's shape in the broad phase. */
public class FixtureProxy {
  /** As of the last {@link Fixture#getAABB}. */
  final AABB aabb = new AABB();

  Fixture fixture;
  int childIndex;
  int proxyId;

  /** Made by the engine. */
  public FixtureProxy() {}
}
