package org.jbox2d.benchmarks.engines;

/**
 * A body in some engine. Places are those of the body's origin, in metres; angles in radians, of
 * which some engines keep only the remainder of a turn; velocities are those of the centre of mass.
 */
public interface SimBody {
  /** Adds a box of the body's axes, given by half sizes and centre. */
  SimBody box(double halfWidth, double halfHeight, double x, double y, Matter matter);

  /** Adds a convex polygon of at most eight vertices, counter-clockwise: x, y, x, y... */
  SimBody polygon(Matter matter, double... vertices);

  /** Adds a disc. */
  SimBody disc(double radius, double x, double y, Matter matter);

  /** Adds a chain of edges, open, as the engine does it best: x, y, x, y... */
  SimBody chain(Matter matter, double... vertices);

  /** Adds a box about the origin. */
  default SimBody box(double halfWidth, double halfHeight, Matter matter) {
    return box(halfWidth, halfHeight, 0, 0, matter);
  }

  /** Adds a disc about the origin. */
  default SimBody disc(double radius, Matter matter) {
    return disc(radius, 0, 0, matter);
  }

  /** Sets the velocity. */
  SimBody move(double vx, double vy, double w);

  /** Sets the place, without turn. */
  SimBody place(double x, double y);

  /** Sets the damping, 1/s. */
  SimBody damp(double linear, double angular);

  /** Asks for continuous collision against moving bodies as well. */
  SimBody bullet();

  /** Applies a force at the centre for the next step. */
  void push(double fx, double fy);

  double x();

  double y();

  double angle();

  double vx();

  double vy();

  double w();

  boolean awake();

  /**
   * Sum of the normal impulses on the body in the last step, Ns; {@link Sim#listen} comes first.
   */
  double pressed();
}
