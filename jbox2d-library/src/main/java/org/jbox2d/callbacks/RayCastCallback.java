package org.jbox2d.callbacks;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Fixture;

/** Hears of the fixtures that a ray meets, in no particular order. */
public interface RayCastCallback {
  /**
   * A fixture that the ray meets. The vectors are valid until this returns: keep copies.
   *
   * @param point world point where the ray enters it
   * @param normal world normal there
   * @param fraction of the ray's length
   * @return -1 to ignore the fixture, 0 to end, {@code fraction} to cut the ray here, 1 to go on
   */
  float reportFixture(Fixture fixture, Vec2 point, Vec2 normal, float fraction);
}
