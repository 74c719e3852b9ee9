package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.SolverBodies;
import org.jbox2d.dynamics.solver.StepConfig;

/** Copies a contact into its solver records, and its impulses back. */
final class ContactGather {
  private ContactGather() {}

  /** The bodies' slots must have been written, and the bodies be in them. */
  static void writeVelocityRecord(
      ContactConstraints cc, int i, Contact c, SolverBodies bodies, StepConfig step) {
    float[] d = cc.vel;
    float[] m = bodies.mass;
    int o = V_STRIDE * i;
    int oA = SolverBodies.STRIDE * cc.bodyA[i];
    int oB = SolverBodies.STRIDE * cc.bodyB[i];
    d[o + INV_MASS_A] = m[oA];
    d[o + INV_I_A] = m[oA + 1];
    d[o + INV_MASS_B] = m[oB];
    d[o + INV_I_B] = m[oB + 1];
    d[o + FRICTION] = c.m_friction;
    d[o + TANGENT_SPEED] = c.m_tangentSpeed;
    d[o + RESTITUTION] = c.m_restitution;
    float scale = step.warmStarting ? step.dtRatio : 0f;
    Manifold manifold = c.m_manifold;
    for (int j = 0; j < manifold.pointCount; j++) {
      ManifoldPoint p = manifold.points[j];
      int k = o + POINT + POINT_STRIDE * j;
      d[k + NORMAL_IMPULSE] = scale * p.normalImpulse;
      d[k + TANGENT_IMPULSE] = scale * p.tangentImpulse;
    }
  }

  /** As {@link #writeVelocityRecord}. */
  static void writePositionRecord(
      ContactConstraints cc, int i, Contact c, SolverBodies bodies, StepConfig step) {
    Manifold manifold = c.m_manifold;
    float[] d = cc.pos;
    float[] m = bodies.mass;
    int o = P_STRIDE * i;
    int oA = SolverBodies.STRIDE * cc.bodyA[i];
    int oB = SolverBodies.STRIDE * cc.bodyB[i];
    d[o + P_INV_MASS_A] = m[oA];
    d[o + P_INV_I_A] = m[oA + 1];
    d[o + P_INV_MASS_B] = m[oB];
    d[o + P_INV_I_B] = m[oB + 1];
    d[o + RADIUS_A] = c.m_radiusA;
    d[o + RADIUS_B] = c.m_radiusB;
    d[o + P_REST] = restDepth(c, step);
    // Polygons that rest closer than their skins would catch on the corner of the next tile. Where
    // a corner has stopped a body, it is none of those, and nothing else would solve the impact.
    boolean left = (c.m_flags & Contact.LEFT_FLAG) != 0;
    c.m_flags &= ~Contact.LEFT_FLAG;
    boolean corner = manifold.corner && step.skinShare > 0f && !left;
    boolean polygons = c.m_skin == c.m_radiusA + c.m_radiusB;
    cc.manifoldPoints[i] = corner && polygons ? 0 : manifold.pointCount;
    cc.corner[i] = corner;
    boolean round = step.skinShare > 0f && c.m_skin > 0f && !polygons;
    d[o + P_ROUND] = round ? c.m_radiusA + c.m_radiusB - c.m_skin : 0f;
    int centreOfPlane = oA + 2;
    int centreOfPoints = oB + 2;
    switch (manifold.type) {
      case CIRCLES:
        cc.kind[i] = CIRCLES;
        break;
      case FACE_A:
        cc.kind[i] = FACE_A;
        break;
      default:
        cc.kind[i] = FACE_B;
        centreOfPlane = oB + 2;
        centreOfPoints = oA + 2;
        break;
    }
    if (round) {
      // A disc rolls on the face itself, not on its skin: its arm would be too short for that.
      d[o + (cc.kind[i] == FACE_B ? RADIUS_B : RADIUS_A)] = 0f;
      d[o + P_REST] -= c.m_skin;
    }
    d[o + LOCAL_NX] = manifold.localNormal.x;
    d[o + LOCAL_NY] = manifold.localNormal.y;
    d[o + PLANE_X] = manifold.localPoint.x - m[centreOfPlane];
    d[o + PLANE_Y] = manifold.localPoint.y - m[centreOfPlane + 1];
    for (int j = 0; j < manifold.pointCount; j++) {
      Vec2 p = manifold.points[j].localPoint;
      d[o + P1X + 2 * j] = p.x - m[centreOfPoints];
      d[o + P1Y + 2 * j] = p.y - m[centreOfPoints + 1];
    }
  }

  /** Overlap of the shapes' surfaces, skins included, at rest, m. */
  static float restDepth(Contact c, StepConfig step) {
    return step.skinShare * c.m_skin + step.linearSlop;
  }

  static void readImpulses(ContactConstraints cc, int i, Contact c) {
    Manifold manifold = c.m_manifold;
    float[] d = cc.vel;
    int n = cc.pointCount[i];
    for (int j = 0; j < manifold.pointCount; j++) {
      ManifoldPoint p = manifold.points[j];
      int k = V_STRIDE * i + POINT + POINT_STRIDE * j;
      // A point left out as redundant carries nothing.
      p.normalImpulse = j < n ? d[k + NORMAL_IMPULSE] : 0f;
      p.tangentImpulse = j < n ? d[k + TANGENT_IMPULSE] : 0f;
    }
  }
}
