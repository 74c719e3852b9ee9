package org.jbox2d.fracture.impact;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.Material;

/** The strongest blow on a body in a step: which fixture it is to break, where, and by what. */
public final class Request {
  public final Body body;
  public final Fixture fixture;
  public final Material material;
  public final Blow blow;

  /** Where the blow struck, in the body's frame, m. */
  public final Vec2 point = new Vec2();

  /** Velocity of the striking body relative to the struck one, in the body's frame, m/s. */
  public final Vec2 vector = new Vec2();

  public Request(Fixture fixture, Material material, Blow blow) {
    this.fixture = fixture;
    this.material = material;
    this.blow = blow;
    body = fixture.getBody();
    Vec2 world = new Vec2();
    blow.strikingPoint(world);
    blow.impactVelocity(body, world, vector);
    blow.toFrameOf(body, world, point);
    blow.turnToFrameOf(body, vector, vector);
  }

  /** Whether the body and the fixture are still there. */
  public boolean isLive() {
    return body.m_world != null
        && fixture.m_body == body
        && blow.bodyA.m_world != null
        && blow.bodyB.m_world != null;
  }
}
