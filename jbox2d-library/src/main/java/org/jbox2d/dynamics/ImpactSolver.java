package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import java.util.Arrays;
import org.jbox2d.callbacks.ContactListener;
import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.contacts.ContactEdge;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.ContactPositionKernel;
import org.jbox2d.dynamics.solver.ContactPreparation;
import org.jbox2d.dynamics.solver.ContactVelocityKernel;
import org.jbox2d.dynamics.solver.SolverBodies;
import org.jbox2d.dynamics.solver.SpinBooks;
import org.jbox2d.dynamics.solver.StepConfig;

/**
 * Solves an impact within a step: the one contact, and what else its dynamic bodies touch at that
 * moment of bodies that do not move.
 *
 * <p>Stages: gather; push the overlap of the impact apart; solve the velocities, without warm
 * starting; scatter and report. The impulses of an impact are not kept for warm starting.
 */
final class ImpactSolver {
  /** Bound of the position iterations; they end when the overlap is acceptable. */
  private static final int POSITION_ITERATIONS = 20;

  /**
   * Overlap that is acceptable, in that at rest: with sequential impulses half of that at which an
   * impact is found.
   */
  private static final float ACCEPTED_SLOPS = 1.5f;

  /** Slots of the bodies of an impact. */
  private static final int[] PAIR = {0, 1};

  private final ContactManager contacts;
  private final SolverBodies bodies = new SolverBodies();
  private final ContactConstraints constraints = new ContactConstraints();
  private final SolvedContactReport report = new SolvedContactReport(constraints, bodies, true);
  private final SpinBooks spin = new SpinBooks(bodies);
  private final Body[] slots = new Body[2];

  /** As {@link StepConfig#warmStarting} off: impulses start at 0. */
  private final StepConfig cold = new StepConfig();

  private Contact[] solved = new Contact[32];
  private float[] kept = new float[4 * 32];
  private int count;
  private int moving;

  ImpactSolver(ContactManager contacts) {
    this.contacts = contacts;
  }

  /**
   * Notes the angular momentum of two bodies that both move, at the end of their ways. What the
   * step has pushed apart is taken back in part where they are placed on their ways, and that
   * changes it.
   */
  void begin(Body b, Body o) {
    bodies.count = 0;
    placeAtEnd(b);
    placeAtEnd(o);
    spin.open(PAIR, 0, PAIR.length);
  }

  private void placeAtEnd(Body b) {
    int o = SolverBodies.STRIDE * place(b);
    bodies.pos[o] = b.m_sweep.c.x;
    bodies.pos[o + 1] = b.m_sweep.c.y;
  }

  /**
   * Solves the impact of {@code b} and {@code o}, which are placed where they meet and start the
   * rest of their way there; if both move, {@link #begin} comes before that. Afterwards their
   * velocities are new, and they have been pushed apart.
   *
   * @param alpha when in the step, as a fraction of it
   */
  void solve(Body b, Body o, Contact impact, float alpha, StepConfig step) {
    ContactListener listener = contacts.m_contactListener;
    gather(b, o, impact, listener);
    pushApart(impact, step);
    if (moving == 2 && spin.areAlone(PAIR, 0, 2, constraints, 0, count)) {
      spin.closeMoved(PAIR, 0, 2, SpinBooks.SMALL);
    }
    ContactPreparation.prepare(constraints, bodies, 0, count, step.velocityThreshold);
    BounceTiming.correct(constraints, solved, 0, count, alpha, step);
    report.at(alpha);
    report.keepVelocities(0f);
    for (int n = 0; n < step.velocityIterations; n++) {
      ContactVelocityKernel.solve(constraints, bodies, 0, count);
    }
    scatter();
    keepImpulses();
    report.send(solved, count, listener, true, step);
    restoreImpulses();
    Arrays.fill(solved, 0, count, null);
    Arrays.fill(slots, null);
  }

  // --- Gather ---

  private void gather(Body b, Body o, Contact impact, ContactListener listener) {
    bodies.count = 0;
    count = 0;
    place(b);
    place(o);
    moving = o.m_type == BodyType.DYNAMIC ? 2 : 1;
    slots[0] = b;
    slots[1] = o;
    add(impact);
    for (int i = 0; i < moving; i++) {
      for (ContactEdge edge = slots[i].m_contactList; edge != null; edge = edge.next) {
        if (count < Settings.maxTOIContacts && isSupport(edge, impact, listener)) {
          add(edge.contact);
        }
      }
    }
    for (int i = 0; i < count; i++) {
      Contact c = solved[i];
      constraints.bodyA[i] = slotOf(c.m_fixtureA.m_body);
      constraints.bodyB[i] = slotOf(c.m_fixtureB.m_body);
      ContactGather.writeVelocityRecord(constraints, i, c, bodies, cold);
      ContactGather.writePositionRecord(constraints, i, c, bodies, cold);
    }
  }

  /** Whether a contact other than that of the impact touches a still body at this moment. */
  private boolean isSupport(ContactEdge edge, Contact impact, ContactListener listener) {
    Contact c = edge.contact;
    if (c == impact
        || edge.other.m_type != BodyType.STATIC
        || c.m_fixtureA.m_isSensor
        || c.m_fixtureB.m_isSensor) {
      return false;
    }
    c.update(listener);
    return c.isTouching() && c.isEnabled() && c.m_manifold.pointCount > 0;
  }

  private void add(Contact c) {
    if (count == solved.length) {
      solved = Arrays.copyOf(solved, 2 * count);
      kept = Arrays.copyOf(kept, 4 * solved.length);
    }
    solved[count++] = c;
    constraints.count = count;
    constraints.ensureCapacity(count);
  }

  /**
   * A still body has a slot for each of its contacts; it makes no difference, as it is not moved.
   */
  private int slotOf(Body b) {
    for (int i = 0; i < slots.length; i++) {
      if (slots[i] == b) {
        return i;
      }
    }
    return place(b);
  }

  private int place(Body b) {
    int i = bodies.count;
    bodies.ensureCapacity(i + 1);
    bodies.count = i + 1;
    int o = SolverBodies.STRIDE * i;
    Vec2 l = b.m_sweep.localCenter;
    bodies.vel[o] = b.m_linearVelocity.x;
    bodies.vel[o + 1] = b.m_linearVelocity.y;
    bodies.vel[o + 2] = b.m_angularVelocity;
    // The transform tells where a body is; the sweep of a kinematic one goes through the whole
    // step.
    bodies.pos[o] = b.m_xf.p.x + b.m_xf.q.c * l.x - b.m_xf.q.s * l.y;
    bodies.pos[o + 1] = b.m_xf.p.y + b.m_xf.q.s * l.x + b.m_xf.q.c * l.y;
    bodies.pos[o + 2] = b.m_xf.q.s;
    bodies.pos[o + 3] = b.m_xf.q.c;
    bodies.mass[o] = b.m_invMass;
    bodies.mass[o + 1] = b.m_invI;
    bodies.mass[o + 2] = l.x;
    bodies.mass[o + 3] = l.y;
    bodies.angle[i] = b.m_sweep.a0;
    return i;
  }

  // --- Solve ---

  /** Pushes the overlap apart as far as the step's solver would at rest. */
  private void pushApart(Contact impact, StepConfig step) {
    float slop = ContactGather.restDepth(impact, step);
    float least = Float.NEGATIVE_INFINITY;
    for (int n = 0; n < POSITION_ITERATIONS && least < -ACCEPTED_SLOPS * slop; n++) {
      least =
          ContactPositionKernel.solve(
              constraints, bodies, 0, count, Settings.toiBaugarte, slop, step.maxLinearCorrection);
    }
  }

  private void scatter() {
    for (int i = 0; i < moving; i++) {
      Body b = slots[i];
      int o = SolverBodies.STRIDE * i;
      b.m_linearVelocity.set(bodies.vel[o], bodies.vel[o + 1]);
      b.m_angularVelocity = bodies.vel[o + 2];
      b.m_sweep.c0.set(bodies.pos[o], bodies.pos[o + 1]);
      b.m_sweep.a0 = bodies.angle[i];
      b.m_sweep.c.set(b.m_sweep.c0);
      b.m_sweep.a = b.m_sweep.a0;
      b.synchronizeTransform();
    }
  }

  // --- Impulses ---

  /** Sets the impulses of the whole step aside, and shows those of the impact to the listener. */
  private void keepImpulses() {
    for (int i = 0; i < count; i++) {
      Manifold m = solved[i].m_manifold;
      for (int j = 0; j < m.pointCount; j++) {
        kept[4 * i + 2 * j] = m.points[j].normalImpulse;
        kept[4 * i + 2 * j + 1] = m.points[j].tangentImpulse;
      }
      ContactGather.readImpulses(constraints, i, solved[i]);
    }
  }

  private void restoreImpulses() {
    for (int i = 0; i < count; i++) {
      Manifold m = solved[i].m_manifold;
      for (int j = 0; j < m.pointCount; j++) {
        ManifoldPoint p = m.points[j];
        p.normalImpulse = kept[4 * i + 2 * j];
        p.tangentImpulse = kept[4 * i + 2 * j + 1];
      }
    }
  }
}
