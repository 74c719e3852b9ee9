package org.jbox2d.benchmarks.engines;

/**
 * What a shape is made of. All engines mix friction as the geometric mean of the two and
 * restitution as the greater of the two.
 *
 * @param density mass over area, kg/m^2
 * @param friction coefficient of friction
 * @param restitution speed after over speed before
 * @param ghost whether the shape passes through other ghosts
 */
public record Matter(double density, double friction, double restitution, boolean ghost) {
  /** Without friction and bounce. */
  public static Matter smooth(double density) {
    return new Matter(density, 0, 0, false);
  }

  /** With friction, without bounce. */
  public static Matter rough(double density, double friction) {
    return new Matter(density, friction, 0, false);
  }

  /** With bounce, without friction. */
  public static Matter bouncy(double density, double restitution) {
    return new Matter(density, 0, restitution, false);
  }

  /** The same that passes through other ghosts. */
  public Matter ghostly() {
    return new Matter(density, friction, restitution, true);
  }
}
