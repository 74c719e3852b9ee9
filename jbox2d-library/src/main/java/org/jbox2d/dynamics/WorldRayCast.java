package org.jbox2d.dynamics;

import org.jbox2d.callbacks.RayCastCallback;
import org.jbox2d.callbacks.TreeRayCastCallback;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.common.Vec2;

/**
 * One ray cast: from the broad phase's candidates to fixtures. A new object for each, so that casts
 * may be nested.
 */
final class WorldRayCast implements TreeRayCastCallback {
  private final BroadPhase broadPhase;
  private final RayCastCallback callback;
  private final RayCastOutput output = new RayCastOutput();
  private final Vec2 point = new Vec2();

  WorldRayCast(BroadPhase broadPhase, RayCastCallback callback) {
    this.broadPhase = broadPhase;
    this.callback = callback;
  }

  void cast(Vec2 point1, Vec2 point2) {
    RayCastInput input = new RayCastInput();
    input.p1.set(point1);
    input.p2.set(point2);
    input.maxFraction = 1f;
    broadPhase.raycast(this, input);
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
