package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import org.jbox2d.callbacks.ContactImpulse;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.ManifoldPoint;
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

  /** Keeps the velocities as they are now: forces applied, contacts not yet solved. */
  void keepVelocities() {
    int n = SolverBodies.STRIDE * bodies.count;
    if (before.length < n) {
      before = new float[bodies.vel.length];
    }
    System.arraycopy(bodies.vel, 0, before, 0, n);
  }

  /** Reports the first {@code n} contacts, which are those of the constraints. */
  void send(Contact[] contacts, int n, ContactListener listener, StepConfig step) {
    for (int i = 0; i < n; i++) {
      Contact c = contacts[i];
      Fixture a = c.m_fixtureA;
      Fixture b = c.m_fixtureB;
      if (listener != null) {
        tell(listener, c);
      }
      FixtureMaterial materialA = a.m_material;
      FixtureMaterial materialB = b.m_material;
      if (materialA != null || materialB != null) {
        fill(i, c, step);
        if (materialA != null) {
          materialA.contactSolved(a, solved);
        }
        if (materialB != null) {
          materialB.contactSolved(b, solved);
        }
        if (!impacts) {
          c.m_lastImpulse = solved.normalImpulse();
        }
      }
    }
    solved.contact = null;
  }

  private void tell(ContactListener listener, Contact c) {
    impulse.count = c.m_manifold.pointCount;
    for (int j = 0; j < impulse.count; j++) {
      ManifoldPoint p = c.m_manifold.points[j];
      impulse.normalImpulses[j] = p.normalImpulse;
      impulse.tangentImpulses[j] = p.tangentImpulse;
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
    float centreX = impacts ? bodies.pos[oA] : bodyA.m_sweep.c0.x;
    float centreY = impacts ? bodies.pos[oA + 1] : bodyA.m_sweep.c0.y;
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
      gain(c.m_fixtureB.m_body, step, solved.gainB);
    }
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
