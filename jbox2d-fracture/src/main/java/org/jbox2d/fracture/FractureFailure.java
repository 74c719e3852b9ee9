package org.jbox2d.fracture;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;

/**
 * A fracture that was called off: nothing has changed. Holds its whole input, so that it can be
 * played again.
 */
public final class FractureFailure {
  private final String reason;
  private final Body body;
  private final Material material;
  private final Vec2 point;
  private final Vec2 vector;
  private final long seed;

  FractureFailure(String reason, Body body, Material material, Vec2 point, Vec2 vector, long seed) {
    this.reason = reason;
    this.body = body;
    this.material = material;
    this.point = point;
    this.vector = vector;
    this.seed = seed;
  }

  /** Returns what went wrong. */
  public String reason() {
    return reason;
  }

  /** Returns the body that stayed whole. */
  public Body body() {
    return body;
  }

  /** Returns the material of the fixture that was struck. */
  public Material material() {
    return material;
  }

  /** Returns where the blow struck, in the body's frame, m. */
  public Vec2 point() {
    return point;
  }

  /**
   * Returns the velocity of the striking body relative to the struck one, in the body's frame, m/s.
   */
  public Vec2 vector() {
    return vector;
  }

  /** Returns the seed of the sites. */
  public long seed() {
    return seed;
  }

  @Override
  public String toString() {
    return "fracture called off: "
        + reason
        + "; point "
        + point
        + ", vector "
        + vector
        + ", seed "
        + seed;
  }
}
