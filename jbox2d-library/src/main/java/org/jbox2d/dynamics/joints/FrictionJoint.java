package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.DriveKernel;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.pooling.IWorldPool;

/**
 * Friction between two bodies seen from above: it resists their relative motion at a point and
 * their relative turning, up to a force and a torque.
 */
public class FrictionJoint extends Joint {
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private float maxForce;
  private float maxTorque;
  private float impulseX;
  private float impulseY;
  private float turnImpulse;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected FrictionJoint(IWorldPool argWorldPool, FrictionJointDef def) {
    super(argWorldPool, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "FrictionJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "FrictionJointDef.localAnchorB");
    JointChecks.notNegative(def.maxForce, "FrictionJointDef.maxForce");
    JointChecks.notNegative(def.maxTorque, "FrictionJointDef.maxTorque");
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    maxForce = def.maxForce;
    maxTorque = def.maxTorque;
  }

  /** Returns the point of body A in its frame, the same object each time. */
  public Vec2 getLocalAnchorA() {
    return localAnchorA;
  }

  /** Returns the point of body B in its frame, the same object each time. */
  public Vec2 getLocalAnchorB() {
    return localAnchorB;
  }

  /** Sets the largest force, N; a change wakes the bodies. */
  public void setMaxForce(float force) {
    JointChecks.notNegative(force, "force");
    if (force != maxForce) {
      maxForce = force;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the largest force, N. */
  public float getMaxForce() {
    return maxForce;
  }

  /** Sets the largest torque, N m; a change wakes the bodies. */
  public void setMaxTorque(float torque) {
    JointChecks.notNegative(torque, "torque");
    if (torque != maxTorque) {
      maxTorque = torque;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the largest torque, N m. */
  public float getMaxTorque() {
    return maxTorque;
  }

  @Override
  public void getAnchorA(Vec2 argOut) {
    m_bodyA.getWorldPointToOut(localAnchorA, argOut);
  }

  @Override
  public void getAnchorB(Vec2 argOut) {
    m_bodyB.getWorldPointToOut(localAnchorB, argOut);
  }

  @Override
  public void getReactionForce(float inv_dt, Vec2 argOut) {
    argOut.set(inv_dt * impulseX, inv_dt * impulseY);
  }

  @Override
  public float getReactionTorque(float inv_dt) {
    return inv_dt * turnImpulse;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.DRIVE.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.DRIVE, DriveKernel.FLOATS, m_bodyA.m_islandIndex, m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    DriveKernel.writeDrive(rows.f, o, 0f, maxForce, maxTorque, 0f);
    DriveKernel.writeImpulses(rows.f, o, impulseX, impulseY, turnImpulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulseX = DriveKernel.impulseX(rows.f, o);
    impulseY = DriveKernel.impulseY(rows.f, o);
    turnImpulse = DriveKernel.turnImpulse(rows.f, o);
  }
}
