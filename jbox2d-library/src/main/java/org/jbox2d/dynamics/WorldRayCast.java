package org.jbox2d.dynamics;

import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.common.Vec2;

/**
 * Casts rays: from the broad phase's candidates to fixtures. An object does one cast at a time; a
 * cast that a callback asks for during another is done by a further one, made when first needed. So
 * a warm world casts without allocating. What callbacks are given is valid until they return.
 */
final class WorldRayCast implements TreeRayCastCallback {
  private final BroadPhase broadPhase;
  private final RayCastInput input = new RayCastInput();
  private final RayCastOutput output = new RayCastOutput();
  private final Vec2 point = new Vec2();

  /** Who hears of this cast; null while none is under way. */
  private RayCastCallback callback;

  /** Does the casts that are asked for during one of this object. */
  private WorldRayCast nested;

  WorldRayCast(BroadPhase broadPhase) {
    this.broadPhase = broadPhase;
  }

  void cast(RayCastCallback callback, Vec2 point1, Vec2 point2) {
    if (this.callback == null) {
      run(callback, point1, point2);
      return;
    }
    if (nested == null) {
      nested = new WorldRayCast(broadPhase);
    }
    nested.cast(callback, point1, point2);
  }

  private void run(RayCastCallback callback, Vec2 point1, Vec2 point2) {
    input.p1.set(point1);
    input.p2.set(point2);
    input.maxFraction = 1f;
    this.callback = callback;
    try {
      broadPhase.raycast(this, input);
    } finally {
      this.callback = null;
    }
  }

  @Override
  public float raycastCallback(RayCastInput input, int nodeId) {
    FixtureProxy proxy = (FixtureProxy) broadPhase.getUserData(nodeId);
    if (!proxy.fixture.raycast(output, input, proxy.childIndex)) {
      return input.maxFraction;
    }
    float f = output.fraction;
    point.set((1f - f) * input.p1.x + f * input.p2.x, (1f - f) * input.p1.y + f * input.p2.y);
    return callback.reportFixture(proxy.fixture, point, output.normal, f);
  }
}
