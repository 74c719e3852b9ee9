package org.jbox2d.collision.shapes;

import org.jbox2d.common.Vec2;

/** Mass, centre of mass, and moment of inertia of a shape. */
public class MassData {

  /** In kg. */
  public float mass;

  /** Centre of mass in the shape's coordinates, in metres. */
  public final Vec2 center;

  /**
   * Moment of inertia about the origin of the shape's coordinates (not about {@link #center}), in
   * kg m^2.
   */
  public float I;

  public MassData() {
    center = new Vec2();
  }

  public MassData(MassData md) {
    this();
    set(md);
  }

  public void set(MassData md) {
    mass = md.mass;
    I = md.I;
    center.set(md.center);
  }

  @Override
  public MassData clone() {
    return new MassData(this);
  }
}
