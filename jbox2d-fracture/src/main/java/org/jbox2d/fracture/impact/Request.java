package org.jbox2d.fracture.impact;

import java.util.List;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.Material;

/** One fracture that is called for: all strikes of a step on what breaks as one. */
public final class Request {
  public final Body body;

  /** The fixture that was struck hardest. */
  public final Fixture fixture;

  /** Its material. */
  public final Material material;

  /**
   * Impulse of the hardest blow, summed over the contacts of what breaks with one striking body, N
   * s.
   */
  public final float intensity;

  /** The hardest first. */
  public final List<Strike> strikes;

  Request(Strike hardest, float intensity, List<Strike> strikes) {
    body = hardest.fixture.getBody();
    fixture = hardest.fixture;
    material = hardest.material;
    this.intensity = intensity;
    this.strikes = strikes;
  }

  private Request(Request other, Material material) {
    body = other.body;
    fixture = other.fixture;
    this.material = material;
    intensity = other.intensity;
    strikes = other.strikes;
  }

  /** The hardest of the strikes. */
  public Strike hardest() {
    return strikes.get(0);
  }

  /** Returns this request with another material. */
  public Request with(Material other) {
    return new Request(this, other);
  }
}
