package org.jbox2d.fracture;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.World;

/**
 * Mass, momentum, angular momentum about the origin, and kinetic energy of all bodies that move,
 * summed in double.
 */
final class Totals {
  double mass;
  double px;
  double py;
  double spin;
  double kinetic;

  /** Density times area of all fixtures, of static bodies too. */
  double material;

  /**
   * Sum of the magnitudes that add up to momentum and angular momentum: the scale of their
   * rounding.
   */
  double momentumScale;

  double spinScale;

  static Totals of(World world) {
    Totals t = new Totals();
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      t.add(b);
    }
    return t;
  }

  private void add(Body b) {
    double m = b.m_mass;
    double vx = b.m_linearVelocity.x;
    double vy = b.m_linearVelocity.y;
    double x = b.m_sweep.c.x;
    double y = b.m_sweep.c.y;
    double w = b.m_angularVelocity;
    mass += m;
    px += m * vx;
    py += m * vy;
    spin += m * (x * vy - y * vx) + b.m_I * w;
    kinetic += 0.5 * (m * (vx * vx + vy * vy) + b.m_I * w * w);
    momentumScale += m * Math.hypot(vx, vy);
    spinScale += m * Math.hypot(x, y) * Math.hypot(vx, vy) + b.m_I * Math.abs(w);
    MassData data = new MassData();
    for (Fixture f = b.getFixtureList(); f != null; f = f.getNext()) {
      f.getMassData(data);
      material += data.mass;
    }
  }
}
