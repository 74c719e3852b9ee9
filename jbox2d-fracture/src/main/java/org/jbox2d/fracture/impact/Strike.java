package org.jbox2d.fracture.impact;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.Material;

/** One blow as one of its bodies takes it: where it struck, how fast, how hard. */
public final class Strike {
  public final Fixture fixture;
  public final Material material;

  /** The contact of which this is a side; {@code null} if a game commanded it. */
  public final Blow blow;

  /** Impulse, N s, without the share of a resting load. */
  public final float intensity;

  /** Where it struck, in the body's frame, m. */
  public final Vec2 point = new Vec2();

  /**
   * Velocity of the striking body relative to the struck one, in the body's frame, m/s; only the
   * direction if commanded.
   */
  public final Vec2 vector = new Vec2();

  /** The share of the blow that acts if the fixture breaks, in (0, 1]. */
  float share = 1f;

  /** A side of a solved contact. */
  public Strike(Fixture fixture, Material material, Blow blow) {
    this.fixture = fixture;
    this.material = material;
    this.blow = blow;
    intensity = blow.intensity;
    Body body = fixture.getBody();
    Vec2 world = new Vec2();
    blow.strikingPoint(world);
    blow.impactVelocity(body, world, vector);
    blow.toFrameOf(body, world, point);
    blow.turnToFrameOf(body, vector, vector);
  }

  /** A commanded strike at a world point with a world impulse. */
  public Strike(Fixture fixture, Material material, Vec2 worldPoint, Vec2 impulse) {
    this.fixture = fixture;
    this.material = material;
    blow = null;
    intensity = impulse.length();
    Body body = fixture.getBody();
    body.getLocalPointToOut(worldPoint, point);
    body.getLocalVectorToOut(impulse, vector);
    if (intensity > 0f) {
      vector.mulLocal(1f / intensity);
    }
  }

  /** Returns the share of the blow that acts if the fixture breaks, in (0, 1]. */
  public float share() {
    return share;
  }

  /** The body at the other end of the blow, or {@code null}. */
  Body striker() {
    if (blow == null) {
      return null;
    }
    return blow.bodyA == fixture.getBody() ? blow.bodyB : blow.bodyA;
  }

  /** What breaks as one with the fixture. */
  Object breakable() {
    return fixture.getCompound() == null ? fixture : fixture.getCompound();
  }

  boolean isLive(Body body) {
    return fixture.m_body == body
        && (blow == null || (blow.bodyA.m_world != null && blow.bodyB.m_world != null));
  }
}
