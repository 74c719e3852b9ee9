package org.jbox2d.dynamics;

import static org.jbox2d.dynamics.solver.ContactConstraints.*;

import org.jbox2d.collision.Manifold;
import org.jbox2d.collision.ManifoldPoint;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.contacts.Contact;
import org.jbox2d.dynamics.solver.ContactConstraints;
import org.jbox2d.dynamics.solver.StepConfig;

/** Copies a contact into its solver records, and its impulses back. */
final class ContactGather {
  private ContactGather() {}

  static void writeVelocityRecord(
      ContactConstraints cc, int i, Contact c, Body a, Body b, StepConfig step) {
    float[] d = cc.vel;
    int o = V_STRIDE * i;
    d[o + INV_MASS_A] = a.m_invMass;
    d[o + INV_I_A] = a.m_invI;
    d[o + INV_MASS_B] = b.m_invMass;
    d[o + INV_I_B] = b.m_invI;
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

  static void writePositionRecord(ContactConstraints cc, int i, Contact c, Body a, Body b) {
    Manifold manifold = c.m_manifold;
    float[] d = cc.pos;
    int o = P_STRIDE * i;
    d[o + P_INV_MASS_A] = a.m_invMass;
    d[o + P_INV_I_A] = a.m_invI;
    d[o + P_INV_MASS_B] = b.m_invMass;
    d[o + P_INV_I_B] = b.m_invI;
    d[o + RADIUS_A] = c.m_fixtureA.m_shape.m_radius;
    d[o + RADIUS_B] = c.m_fixtureB.m_shape.m_radius;
    cc.manifoldPoints[i] = manifold.pointCount;
    Vec2 centreOfPlane = a.m_sweep.localCenter;
    Vec2 centreOfPoints = b.m_sweep.localCenter;
    switch (manifold.type) {
      case CIRCLES:
        cc.kind[i] = CIRCLES;
        break;
      case FACE_A:
        cc.kind[i] = FACE_A;
        break;
      default:
        cc.kind[i] = FACE_B;
        centreOfPlane = b.m_sweep.localCenter;
        centreOfPoints = a.m_sweep.localCenter;
        break;
    }
    d[o + LOCAL_NX] = manifold.localNormal.x;
    d[o + LOCAL_NY] = manifold.localNormal.y;
    d[o + PLANE_X] = manifold.localPoint.x - centreOfPlane.x;
    d[o + PLANE_Y] = manifold.localPoint.y - centreOfPlane.y;
    for (int j = 0; j < manifold.pointCount; j++) {
      Vec2 p = manifold.points[j].localPoint;
      d[o + P1X + 2 * j] = p.x - centreOfPoints.x;
      d[o + P1Y + 2 * j] = p.y - centreOfPoints.y;
    }
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
