package org.jbox2d.dynamics;

import org.jbox2d.collision.broadphase.BroadPhase;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Changes of a body, between steps, that the world takes part in: contacts, proxies and the bodies
 * that are awake. The body has checked that it may change.
 */
final class BodyChanges {
  private BodyChanges() {}

  /** Puts the body's origin somewhere. */
  static void place(Body b, Vec2 position, float angle) {
    if (b.m_xf.p.x != position.x || b.m_xf.p.y != position.y || b.m_sweep.a != angle) {
      BodyContacts.disturb(b, null);
    }
    b.m_xf.set(position, angle);
    Transform.mulToOutUnsafe(b.m_xf, b.m_sweep.localCenter, b.m_sweep.c);
    b.m_sweep.a = angle;
    stopSweep(b);
    BroadPhase broadPhase = b.m_world.m_contactManager.m_broadPhase;
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      f.synchronize(broadPhase, b.m_xf, b.m_xf);
    }
    b.m_world.lookForPairs();
  }

  private static void stopSweep(Body b) {
    b.m_sweep.c0.set(b.m_sweep.c);
    b.m_sweep.a0 = b.m_sweep.a;
    b.m_xf0.set(b.m_xf);
  }

  /** Makes it static, kinematic or dynamic, which it was not. */
  static void become(Body b, BodyType type) {
    BodyContacts.destroy(b, null);
    b.m_world.awake.remove(b);
    b.m_world.awake.changes++;
    b.m_world.bodies.obstacles -= b.isObstacle() ? 1 : 0;
    b.m_type = type;
    b.m_world.bodies.obstacles += b.isObstacle() ? 1 : 0;
    BodyContacts.markObstacle(b);
    b.resetMassData();
    if (type == BodyType.STATIC) {
      b.m_linearVelocity.setZero();
      b.m_angularVelocity = 0f;
      stopSweep(b);
    }
    b.m_force.setZero();
    b.m_torque = 0f;
    b.m_flags |= Body.e_awakeFlag;
    b.restart();
    b.m_world.awake.enter(b);
    BodyContacts.touchProxies(b);
  }

  /** Takes a body that is not active into the simulation. */
  static void activate(Body b) {
    b.m_flags |= Body.e_activeFlag;
    b.m_world.awake.changes++;
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      f.createProxies(b.m_world.m_contactManager.m_broadPhase, b.m_xf);
    }
    if (b.isAwake()) {
      b.m_world.awake.enter(b);
    }
    b.m_world.lookForPairs();
  }

  /** Takes an active body out of the simulation. */
  static void deactivate(Body b) {
    b.m_flags &= ~Body.e_activeFlag;
    b.m_world.awake.changes++;
    b.m_force.setZero();
    b.m_torque = 0f;
    BodyContacts.destroy(b, null);
    for (Fixture f = b.m_fixtureList; f != null; f = f.m_next) {
      f.destroyProxies(b.m_world.m_contactManager.m_broadPhase);
    }
    b.m_world.awake.remove(b);
  }
}
