package org.jbox2d.dynamics;

import org.jbox2d.common.Rot;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;

/**
 * What became of a contact in a step, for a {@link FixtureMaterial}. The object is used again for
 * the next contact: copy what is to be kept.
 */
public final class SolvedContact {
  /** The contact. */
  public Contact contact;

  /** Number of points, 1 or 2. */
  public int pointCount;

  /** Unit normal in world coordinates, from fixture A to fixture B. */
  public final Vec2 normal = new Vec2();

  /** World points at which the impulses acted, m. */
  public final Vec2[] points = {new Vec2(), new Vec2()};

  /** Impulse of each point along the normal, N s; not negative. It acts on B, its opposite on A. */
  public final float[] normalImpulses = new float[2];

  /**
   * Impulse of each point along the tangent {@code (normal.y, -normal.x)}, N s. It acts on B, its
   * opposite on A.
   */
  public final float[] tangentImpulses = new float[2];

  /**
   * Sum of the normal impulses of this contact in the step before, scaled to this step's length, N
   * s; 0 for a new contact and for an impact within a step.
   */
  public float previousNormalImpulse;

  /**
   * Velocities of the centre of mass of body A and B after forces were applied and before contacts
   * were solved, m/s.
   */
  public final Vec2 velocityA = new Vec2();

  /** See {@link #velocityA}. */
  public final Vec2 velocityB = new Vec2();

  /** Angular velocity of body A before contacts were solved, rad/s. */
  public float angularVelocityA;

  /** Angular velocity of body B before contacts were solved, rad/s. */
  public float angularVelocityB;

  /**
   * What gravity and forces added to the velocity of body A in this step, m/s; 0 for an impact
   * within a step, which comes after the whole step has been solved.
   */
  public final Vec2 gainA = new Vec2();

  /** See {@link #gainA}. */
  public final Vec2 gainB = new Vec2();

  /** Where the centre of mass of body A was when the contact was solved, m. */
  public final Vec2 centerA = new Vec2();

  /** Where the centre of mass of body B was when the contact was solved, m. */
  public final Vec2 centerB = new Vec2();

  /** How body A was turned when the contact was solved. */
  public final Rot rotationA = new Rot();

  /** How body B was turned when the contact was solved. */
  public final Rot rotationB = new Rot();

  /**
   * Rises with each time that contacts are solved together, in a step or at an impact within one.
   */
  public long solve;

  /**
   * Kinetic energy that solving took from all the bodies that were solved together, J; the same for
   * all contacts of a {@link #solve}.
   */
  public double energyTaken;

  /** When in the step it was solved, as a fraction of it: 0 at its start, more for an impact. */
  public float alpha;

  /** Length of the step, s. */
  public float dt;

  SolvedContact() {}

  /** Returns the sum of the points' normal impulses, N s. */
  public float normalImpulse() {
    float sum = 0f;
    for (int i = 0; i < pointCount; i++) {
      sum += normalImpulses[i];
    }
    return sum;
  }
}
