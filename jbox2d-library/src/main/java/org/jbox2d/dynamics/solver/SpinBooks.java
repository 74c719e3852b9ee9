package org.jbox2d.dynamics.solver;

/**
 * Gives islands that nothing outside touches back the angular momentum that solving them has taken
 * or brought. Contacts keep the arms they have when the step begins, while the bodies move on: so
 * the impulses of a blow, equal and opposite as they are, do not act along one line.
 *
 * <p>The velocities of an island are those of its rotation as if it were rigid, at L / J about its
 * centre of mass, and a rest that has neither momentum nor angular momentum: J its moment of
 * inertia as it lies, L the angular momentum, both about that centre. The two parts are orthogonal
 * as the masses measure, so L^2 / 2J and the energy of the rest are all of the energy but that of
 * the centre. To change the rotation alone is the least change of the velocities, measured so, that
 * gives the island another L; and as bodies that turn together do not move against each other, what
 * the contacts have found stays as it is: what touches keeps touching, what parts keeps parting.
 *
 * <p>The rest is scaled where energy would be lost that a bounce has given back, or be more than
 * before the step.
 */
public final class SpinBooks {
  /** What is rounding, as a share of the greatest L that bodies of that energy can have. */
  private static final double TOLERANCE = 1e-6;

  /** Share of that up to which an error is one of arms and places; mostly it is a hundredth. */
  public static final double LARGE = 0.5;

  /**
   * The same where a bound of the angular velocity may have taken it, which others must not be
   * given, or where there are two bodies to bear what is the error of more.
   */
  public static final double SMALL = 0.1;

  /** Factor by which the energy of the rest may grow; in more there would be nothing but noise. */
  private static final double MOST_GROWTH = 1.05;

  private final SolverBodies bodies;

  /** Where places are measured from, m: the first body's when the books were opened. */
  private double fromX;

  private double fromY;

  /** Mass, kg; centre of mass, m; its velocity, m/s. */
  private double mass;

  private double centreX;
  private double centreY;
  private double velocityX;
  private double velocityY;

  /** Moment of inertia, kg m^2, and angular momentum, kg m^2/s, about the centre of mass. */
  private double inertia;

  private double spin;

  /** Energy but for that of the centre of mass, J. */
  private double energy;

  private double spinBefore;
  private double energyBefore;

  /** Angular momentum of the centre of mass about the place measured from, kg m^2/s. */
  private double orbitBefore;

  public SpinBooks(SolverBodies bodies) {
    this.bodies = bodies;
  }

  /**
   * Whether forces do not tell one of the bodies {@code slots[b0, b1)} from another: then only what
   * they do to each other changes their angular momentum in a step.
   */
  boolean areDrivenAlike(int[] slots, int b0, int b1) {
    float[] a = bodies.accel;
    int first = SolverBodies.STRIDE * slots[b0];
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      if (a[o] != a[first]
          || a[o + 1] != a[first + 1]
          || a[o + 2] != 0f
          || bodies.damping[2 * slots[k]] != 0f
          || bodies.damping[2 * slots[k] + 1] != 0f) {
        return false;
      }
    }
    return true;
  }

  /**
   * Whether the bodies {@code slots[b0, b1)} have an angular momentum of their own: each can be
   * turned, and their contacts {@code [c0, c1)} are with each other alone.
   */
  public boolean areAlone(
      int[] slots, int b0, int b1, ContactConstraints contacts, int c0, int c1) {
    if (!contacts.areLoose(c0, c1)) {
      return false;
    }
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      if (bodies.mass[o] == 0f || bodies.mass[o + 1] == 0f) {
        return false;
      }
    }
    return true;
  }

  /** Notes the angular momentum of the bodies {@code slots[b0, b1)}, which can all be turned. */
  public void open(int[] slots, int b0, int b1) {
    fromX = bodies.pos[SolverBodies.STRIDE * slots[b0]];
    fromY = bodies.pos[SolverBodies.STRIDE * slots[b0] + 1];
    measure(slots, b0, b1);
    spinBefore = spin;
    energyBefore = energy;
    orbitBefore = mass * (centreX * velocityY - centreY * velocityX);
  }

  /**
   * Gives the bodies the angular momentum about their centre of mass that they had when the books
   * were opened. A step has been made since then.
   *
   * @param bounces whether to leave the energy as it is, rather than only not above what it was
   * @param mostError {@link #SMALL} or {@link #LARGE}: with a larger error all is left as it is
   */
  void close(int[] slots, int b0, int b1, boolean bounces, double mostError) {
    measure(slots, b0, b1);
    settle(slots, b0, b1, bounces, mostError);
  }

  /**
   * As {@link #close}, where the bodies have been put elsewhere in no time, perhaps with their
   * centre of mass: it is the angular momentum about a fixed point that they get back.
   */
  public void closeMoved(int[] slots, int b0, int b1, double mostError) {
    measure(slots, b0, b1);
    spinBefore += orbitBefore - mass * (centreX * velocityY - centreY * velocityX);
    settle(slots, b0, b1, true, mostError);
  }

  private void settle(int[] slots, int b0, int b1, boolean bounces, double mostError) {
    double most = Math.sqrt(2 * Math.max(energy, energyBefore) * inertia);
    double error = Math.abs(spinBefore - spin);
    if (error <= TOLERANCE * most || error > mostError * most) {
      return;
    }
    double rest = energy - 0.5 * spin * spin / inertia;
    double turning = 0.5 * spinBefore * spinBefore / inertia;
    double wanted = bounces ? energy - turning : Math.min(rest, energyBefore - turning);
    double growth = rest > 0 ? Math.min(MOST_GROWTH, Math.max(0, wanted) / rest) : 1;
    double scale = growth == 1 ? 1 : Math.sqrt(growth);
    move(slots, b0, b1, scale - 1, (spinBefore - scale * spin) / inertia);
  }

  /** Adds a share of the velocity against the centre, and a rotation about it. */
  private void move(int[] slots, int b0, int b1, double share, double turn) {
    float[] v = bodies.vel;
    float[] x = bodies.pos;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      double rx = x[o] - fromX - centreX;
      double ry = x[o + 1] - fromY - centreY;
      v[o] = (float) (v[o] + share * (v[o] - velocityX) - turn * ry);
      v[o + 1] = (float) (v[o + 1] + share * (v[o + 1] - velocityY) + turn * rx);
      v[o + 2] = (float) (v[o + 2] + share * v[o + 2] + turn);
    }
  }

  private void measure(int[] slots, int b0, int b1) {
    float[] v = bodies.vel;
    float[] pos = bodies.pos;
    double m = 0;
    double mx = 0;
    double my = 0;
    double px = 0;
    double py = 0;
    double j = 0;
    double l = 0;
    double e = 0;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      double own = 1.0 / bodies.mass[o];
      double ownInertia = 1.0 / bodies.mass[o + 1];
      double x = pos[o] - fromX;
      double y = pos[o + 1] - fromY;
      double vx = v[o];
      double vy = v[o + 1];
      double w = v[o + 2];
      m += own;
      mx += own * x;
      my += own * y;
      px += own * vx;
      py += own * vy;
      j += own * (x * x + y * y) + ownInertia;
      l += own * (x * vy - y * vx) + ownInertia * w;
      e += 0.5 * (own * (vx * vx + vy * vy) + ownInertia * w * w);
    }
    mass = m;
    centreX = mx / m;
    centreY = my / m;
    velocityX = px / m;
    velocityY = py / m;
    inertia = j - m * (centreX * centreX + centreY * centreY);
    spin = l - m * (centreX * velocityY - centreY * velocityX);
    energy = e - 0.5 * m * (velocityX * velocityX + velocityY * velocityY);
  }
}
