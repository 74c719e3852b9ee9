package org.jbox2d.dynamics;

import org.jbox2d.collision.shapes.Shape;

/**
 * A shape that consists of several convex parts, such as a concave polygon. {@link
 * Body#createFixture(FixtureDef, CompoundShape)} makes a fixture of each part; the fixtures
 * remember their compound.
 */
public interface CompoundShape {
  /** Returns the parts, in body coordinates; at least one. They are cloned. */
  Shape[] getParts();
}
