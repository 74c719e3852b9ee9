package org.jbox2d.fracture.impact;

import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.Material;

/** A blow that was too weak to break what it struck, but not too weak to damage it. */
public final class Wear {
  public final Fixture fixture;
  public final Material material;

  /** Impulse, summed over the contacts of what it struck with one striking body, N s. */
  public final float intensity;

  Wear(Strike strike, float intensity) {
    fixture = strike.fixture;
    material = strike.material;
    this.intensity = intensity;
  }
}
