package org.jbox2d.testbed.simulation;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;

/**
 * Sums over the bodies of a world.
 *
 * @param mass of all fixtures with a density, of static bodies too, kg
 * @param momentumX of dynamic bodies, kg m/s
 * @param momentumY see {@code momentumX}
 * @param angularMomentum of dynamic bodies about the world's origin, kg m^2/s
 * @param kineticEnergy of dynamic bodies, J
 * @param potentialEnergy of dynamic bodies in the world's gravity, 0 at the world's origin, J
 */
public record Totals(
    double mass,
    double momentumX,
    double momentumY,
    double angularMomentum,
    double kineticEnergy,
    double potentialEnergy) {

  /** Returns the sums for a world between steps. */
  public static Totals of(World world) {
    MassData scratch = new MassData();
    double mass = 0;
    double px = 0;
    double py = 0;
    double angular = 0;
    double kinetic = 0;
    double potential = 0;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      mass += MassBalance.massOf(b, scratch);
      // 0 for static and kinematic bodies.
      double m = b.getMass();
      double cx = b.getWorldCenter().x;
      double cy = b.getWorldCenter().y;
      double vx = b.getLinearVelocity().x;
      double vy = b.getLinearVelocity().y;
      double w = b.getAngularVelocity();
      px += m * vx;
      py += m * vy;
      angular += m * (cx * vy - cy * vx) + b.m_I * w;
      kinetic += 0.5 * (m * (vx * vx + vy * vy) + b.m_I * w * w);
      potential -= m * (world.getGravity().x * cx + world.getGravity().y * cy);
    }
    return new Totals(mass, px, py, angular, kinetic, potential);
  }
}
