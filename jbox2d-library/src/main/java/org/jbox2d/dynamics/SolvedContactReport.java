package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.common.Rot;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.SolverBodies;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Tells the contact listener and the fixtures' materials what became of each solved contact, in the
 * order of solving.
 */
final class SolvedContactReport {
  private final ContactConstraints constraints;
  private final SolverBodies bodies;
  private final ContactImpulse impulse = new ContactImpulse();
  private final SolvedContact solved = new SolvedContact();

  /** Whether {@link SolvedContact#energyTaken} has been summed for the current contacts. */
  private boolean summed;

  /** Number of bodies whose velocities were kept. */
  private int kept;

  /** Velocities before contacts were solved, laid out as {@link SolverBodies#vel}. */
  private float[] before = new float[0];

  /** Whether impacts within a step are reported, rather than the contacts of a whole step. */
  private final boolean impacts;

  /**
   * A report of contacts solved in a whole step, or of impacts within one. An impact carries no
   * resting load: nothing is taken from, or kept for, the load of the whole step, and the
   * velocities before it have gained nothing since. Its report is sent before the bodies move on.
   */
  SolvedContactReport(ContactConstraints constraints, SolverBodies bodies, boolean impacts) {
    this.constraints = constraints;
    this.bodies = bodies;
    this.impacts = impacts;
  }

  /** Sets when in the step an impact is, as a fraction of it. */
  void at(float alpha) {
    solved.alpha = alpha;
  }

  /**
   * Keeps the velocities: forces applied, contacts not yet solved.
   *
   * @param dt time over which forces are still to be applied, s
   */
  void keepVelocities(float dt) {
    int n = SolverBodies.STRIDE * bodies.count;
    if (before.length < n) {
      before = new float[bodies.vel.length];
    }
    System.arraycopy(bodies.vel, 0, before, 0, n);
    if (dt > 0f) {
      for (int i = 0; i < bodies.count; i++) {
        applyForces(i, dt);
      }
    }
    kept = bodies.count;
    solved.solve++;
    summed = false;
  }

  private void applyForces(int slot, float dt) {
    int o = SolverBodies.STRIDE * slot;
    float linear = 1f / (1f + dt * bodies.damping[2 * slot]);
    before[o] = linear * (before[o] + dt * bodies.accel[o]);
    before[o + 1] = linear * (before[o + 1] + dt * bodies.accel[o + 1]);
    before[o + 2] =
        (before[o + 2] + dt * bodies.accel[o + 2]) / (1f + dt * bodies.damping[2 * slot + 1]);
  }

  /**
   * Reports the first {@code n} contacts, which are those of the constraints.
   *
   * @param materials whether velocities were kept for materials; one that a listener sets where
   *     there was none when the step began hears from the next step on
   */
  void send(
      Contact[] contacts, int n, ContactListener listener, boolean materials, StepConfig step) {
    for (int i = 0; i < n; i++) {
      Contact c = contacts[i];
      Fixture a = c.m_fixtureA;
      Fixture b = c.m_fixtureB;
      if (listener != null) {
        tell(listener, i, c);
      }
      if (materials && (a.m_material != null || b.m_material != null)) {
        float normalImpulse = normalImpulse(i);
        tell(a, b, i, c, step, normalImpulse);
        if (!impacts) {
          c.m_lastImpulse = normalImpulse;
        }
      }
    }
    solved.contact = null;
  }

  private float normalImpulse(int i) {
    float sum = 0f;
    for (int j = 0; j < constraints.pointCount[i]; j++) {
      sum += constraints.vel[V_STRIDE * i + POINT + POINT_STRIDE * j + NORMAL_IMPULSE];
    }
    return sum;
  }

  private void tell(Fixture a, Fixture b, int i, Contact c, StepConfig step, float normalImpulse) {
    FixtureMaterial materialA = a.m_material;
    FixtureMaterial materialB = b.m_material;
    boolean hearsA = materialA != null && materialA.hears(a, normalImpulse);
    boolean hearsB = materialB != null && materialB.hears(b, normalImpulse);
    if (hearsA || hearsB) {
      fill(i, c, step);
    }
    if (hearsA) {
      materialA.contactSolved(a, solved);
    }
    if (hearsB) {
      materialB.contactSolved(b, solved);
    }
  }

  private void tell(ContactListener listener, int i, Contact c) {
    impulse.count = c.m_manifold.pointCount;
    int solvedPoints = constraints.pointCount[i];
    for (int j = 0; j < impulse.count; j++) {
      int k = V_STRIDE * i + POINT + POINT_STRIDE * j;
      // A point left out as redundant carries nothing.
      boolean carries = j < solvedPoints;
      impulse.normalImpulses[j] = carries ? constraints.vel[k + NORMAL_IMPULSE] : 0f;
      impulse.tangentImpulses[j] = carries ? constraints.vel[k + TANGENT_IMPULSE] : 0f;
    }
    listener.postSolve(c, impulse);
  }

  private void fill(int i, Contact c, StepConfig step) {
    float[] d = constraints.vel;
    int o = V_STRIDE * i;
    int oA = SolverBodies.STRIDE * constraints.bodyA[i];
    int oB = SolverBodies.STRIDE * constraints.bodyB[i];
    Body bodyA = c.m_fixtureA.m_body;
    solved.contact = c;
    solved.dt = step.dt;
    solved.pointCount = constraints.pointCount[i];
    float nx = d[o + NX];
    float ny = d[o + NY];
    Body bodyB = c.m_fixtureB.m_body;
    poseOf(bodyA, oA, solved.centerA, solved.rotationA);
    poseOf(bodyB, oB, solved.centerB, solved.rotationB);
    float centreX = solved.centerA.x;
    float centreY = solved.centerA.y;
    solved.normal.set(nx, ny);
    for (int j = 0; j < solved.pointCount; j++) {
      int k = o + POINT + POINT_STRIDE * j;
      solved.normalImpulses[j] = d[k + NORMAL_IMPULSE];
      solved.tangentImpulses[j] = d[k + TANGENT_IMPULSE];
      // The arm from A's centre, from its components along the tangent (r x n) and the normal (-(r
      // x t)).
      float alongTangent = d[k + RN_A];
      float alongNormal = -d[k + RT_A];
      solved.points[j].set(
          centreX + alongTangent * ny + alongNormal * nx,
          centreY - alongTangent * nx + alongNormal * ny);
    }
    solved.previousNormalImpulse = impacts ? 0f : c.m_lastImpulse * step.dtRatio;
    solved.velocityA.set(before[oA], before[oA + 1]);
    solved.angularVelocityA = before[oA + 2];
    solved.velocityB.set(before[oB], before[oB + 1]);
    solved.angularVelocityB = before[oB + 2];
    solved.gainA.setZero();
    solved.gainB.setZero();
    if (!impacts) {
      gain(bodyA, step, solved.gainA);
      gain(bodyB, step, solved.gainB);
    }
    if (!summed) {
      summed = true;
      solved.energyTaken = energyTaken();
    }
  }

  /**
   * Contacts of a step are solved where the bodies stood when it began, impacts where the solver
   * has them.
   */
  private void poseOf(Body b, int o, Vec2 center, Rot rotation) {
    if (impacts) {
      center.set(bodies.pos[o], bodies.pos[o + 1]);
      rotation.s = bodies.pos[o + 2];
      rotation.c = bodies.pos[o + 3];
    } else if (b.awakeIndex >= 0) {
      center.set(b.m_sweep.c0);
      rotation.set(b.m_xf0.q);
    } else {
      center.set(b.m_sweep.c);
      rotation.set(b.m_xf.q);
    }
  }

  private double energyTaken() {
    double sum = 0;
    for (int i = 0; i < kept; i++) {
      int o = SolverBodies.STRIDE * i;
      float invMass = bodies.mass[o];
      float invI = bodies.mass[o + 1];
      if (invMass > 0f) {
        sum += 0.5 * (squares(before, o) - squares(bodies.vel, o)) / invMass;
      }
      if (invI > 0f) {
        double w0 = before[o + 2];
        double w1 = bodies.vel[o + 2];
        sum += 0.5 * (w0 * w0 - w1 * w1) / invI;
      }
    }
    return sum;
  }

  private static double squares(float[] v, int o) {
    return (double) v[o] * v[o] + (double) v[o + 1] * v[o + 1];
  }

  private static void gain(Body b, StepConfig step, Vec2 out) {
    if (b.m_type != BodyType.DYNAMIC || !(b.m_invMass > 0f)) {
      out.setZero();
      return;
    }
    out.set(
        step.dt * (b.m_gravityScale * step.gravityX + b.m_invMass * b.m_force.x),
        step.dt * (b.m_gravityScale * step.gravityY + b.m_invMass * b.m_force.y));
  }
}
