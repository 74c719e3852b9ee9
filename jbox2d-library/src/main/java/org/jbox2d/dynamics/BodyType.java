package org.jbox2d.dynamics;

/** How a body moves. The order of the constants is part of the API. */
public enum BodyType {
  /** Never moves by itself; infinite mass. */
  STATIC,
  /** Moves with the velocity it is given; infinite mass. */
  KINEMATIC,
  /** Moved by forces, impulses and contacts; finite, positive mass. */
  DYNAMIC
}
