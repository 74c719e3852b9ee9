package org.jbox2d.dynamics.solver;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

/**
 * Tells whether an island has gained energy in being solved.
 *
 * <p>Iterations over contacts are a descent of the kinetic energy: the impulses that solve {@code
 * vn >= 0, P >= 0, P vn = 0} make {@code P . A P / 2 + P . J v0} least, which is what they add to
 * it (Moreau, "Quadratic programming in mechanics", SIAM J. Control 1966), and each single solve
 * lowers it. From no impulses, energy would never rise. But iterations begin with the impulses kept
 * from the step before; where these are far too large, as where a heap is blown apart, what they
 * have added may not have been taken away when the iterations end.
 */
final class EnergyBooks {
  /** Gain that is rounding, relative. */
  private static final double TOLERANCE = 1e-5;

  /**
   * Speed, as of the mean energy, from which on a gain is large whatever it stems from, m/s. Where
   * less is at stake, as in a stack that sets itself down, what kept impulses bring in too much
   * also holds up what the iterations would let sink.
   */
  static final double WILD = 2;

  private final SolverBodies bodies;
  private final ContactConstraints contacts;
  private double mass;
  private double bound;

  EnergyBooks(SolverBodies bodies, ContactConstraints contacts) {
    this.bodies = bodies;
    this.contacts = contacts;
  }

  /** Notes the energy of the bodies {@code slots[b0, b1)}. */
  void open(int[] slots, int b0, int b1) {
    float[] m = bodies.mass;
    mass = 0;
    for (int k = b0; k < b1; k++) {
      float inverse = m[SolverBodies.STRIDE * slots[k]];
      mass += inverse > 0f ? 1f / inverse : 0f;
    }
    bound = kinetic(slots, b0, b1) * (1 + TOLERANCE);
  }

  /**
   * Whether the bodies have much energy now, and more than they had and were given by the forces of
   * a step along their ways in it.
   *
   * @param speed as of the mean energy, from which on it is much, m/s
   */
  boolean isExceeded(int[] slots, int b0, int b1, double speed) {
    return excess(slots, b0, b1, speed) > 0;
  }

  /** Returns how much more energy that is, J; 0 where {@link #isExceeded} is false. */
  double excess(int[] slots, int b0, int b1, double speed) {
    double more = kinetic(slots, b0, b1) - bound;
    boolean much = more + bound > 0.5 * mass * speed * speed;
    return much && more > 0 ? Math.max(0, more - work(slots, b0, b1)) : 0;
  }

  /** Returns the same as a share of the energy that was noted. */
  double gain(int[] slots, int b0, int b1, double speed) {
    double excess = excess(slots, b0, b1, speed);
    return excess > 0 ? excess / bound : 0;
  }

  private double work(int[] slots, int b0, int b1) {
    float[] a = bodies.accel;
    float[] x = bodies.delta;
    double work = 0;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      float inverse = bodies.mass[o];
      float inverseI = bodies.mass[o + 1];
      work += inverse > 0f ? (a[o] * x[o] + a[o + 1] * x[o + 1]) / inverse : 0f;
      work += inverseI > 0f ? a[o + 2] * x[o + 2] / inverseI : 0f;
    }
    return work;
  }

  private double kinetic(int[] slots, int b0, int b1) {
    float[] v = bodies.vel;
    float[] m = bodies.mass;
    double twice = 0;
    for (int k = b0; k < b1; k++) {
      int o = SolverBodies.STRIDE * slots[k];
      float inverse = m[o];
      float inverseI = m[o + 1];
      twice += inverse > 0f ? (v[o] * v[o] + v[o + 1] * v[o + 1]) / inverse : 0f;
      twice += inverseI > 0f ? v[o + 2] * v[o + 2] / inverseI : 0f;
    }
    return 0.5 * twice;
  }

  /** Whether contacts {@code [c0, c1)} are driven from outside: by moving surfaces. */
  boolean isDriven(int c0, int c1) {
    for (int i = c0; i < c1; i++) {
      int c = V_STRIDE * i;
      float[] d = contacts.vel;
      if (d[c + TANGENT_SPEED] != 0f
          || drives(d[c + INV_MASS_A], d[c + INV_I_A], contacts.bodyA[i])
          || drives(d[c + INV_MASS_B], d[c + INV_I_B], contacts.bodyB[i])) {
        return true;
      }
    }
    return false;
  }

  private boolean drives(float inverseMass, float inverseI, int slot) {
    float[] v = bodies.vel;
    int o = SolverBodies.STRIDE * slot;
    return inverseMass == 0f && inverseI == 0f && (v[o] != 0f || v[o + 1] != 0f || v[o + 2] != 0f);
  }
}
