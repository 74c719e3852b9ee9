package org.jbox2d.benchmarks.engines;

/**
 * A world in some engine at some setting: what scenes are written in. Gravity is (0, -10) and
 * nothing sleeps unless a scene says otherwise. What a joint connects does not collide.
 */
public interface Sim extends AutoCloseable {
  /** Sets the acceleration of gravity, m/s^2. */
  void gravity(double x, double y);

  /** Lets bodies at rest sleep. */
  void allowSleep();

  /** Asks for {@link SimBody#pressed()}. */
  void listen();

  /** Adds a body without shapes. */
  SimBody body(Kind kind, double x, double y, double angle);

  /** Takes a body out. */
  void remove(SimBody body);

  /** A dynamic body. */
  default SimBody dynamic(double x, double y) {
    return body(Kind.DYNAMIC, x, y, 0);
  }

  /** A static body at the origin. */
  default SimBody ground() {
    return body(Kind.STATIC, 0, 0, 0);
  }

  /** A hinge at a place of the world. */
  void hinge(SimBody a, SimBody b, double x, double y);

  /** A hinge with a motor that turns b against a, counter-clockwise, in rad/s and Nm. */
  void motor(SimBody a, SimBody b, double x, double y, double speed, double maxTorque);

  /** A hinge that lets b turn against a between two angles, from that of now. */
  void limited(SimBody a, SimBody b, double x, double y, double lower, double upper);

  /** A massless rod between places of the world. */
  void rod(SimBody a, double ax, double ay, SimBody b, double bx, double by);

  /** A spring between places of the world, of frequency (Hz) and damping ratio, at its length. */
  void spring(
      SimBody a, double ax, double ay, SimBody b, double bx, double by, double hz, double ratio);

  /** A string between the origins of two bodies. */
  void rope(SimBody a, SimBody b, double length);

  /** A rail through a place of the world along a unit vector. */
  void rail(SimBody a, SimBody b, double x, double y, double ux, double uy);

  /** Glues two bodies at a place of the world. */
  void weld(SimBody a, SimBody b, double x, double y);

  /** A wheel at its origin, on a vertical spring of the chassis. */
  void wheel(SimBody chassis, SimBody wheel, double hz, double ratio);

  /** A pulley of two strings from ground places straight down to two bodies' origins. */
  void pulley(SimBody a, double ax, double ay, SimBody b, double bx, double by);

  /** Number of bodies. */
  int bodies();

  /**
   * Casts a ray from (ax, ay) to (bx, by).
   *
   * @return how far the first shape is, as a part of the way; 1 if there is none
   */
  double ray(double ax, double ay, double bx, double by);

  /** Steps by a time, s. */
  void step(double dt);

  /** Frees what the engine holds outside the heap. */
  @Override
  default void close() {}
}
