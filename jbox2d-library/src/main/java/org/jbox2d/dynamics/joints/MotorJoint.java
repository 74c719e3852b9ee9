package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.DriveKernel;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.pooling.IWorldPool;

/**
 * Drives body B towards a place and an angle relative to body A, with bounded force and torque; a
 * usual way to move a body by command while it still collides.
 */
public class MotorJoint extends Joint {
  private final Vec2 localOrigin = new Vec2();
  private final Vec2 linearOffset = new Vec2();
  private float angularOffset;
  private float maxForce;
  private float maxTorque;
  private float correctionFactor;
  private float impulseX;
  private float impulseY;
  private float turnImpulse;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  public MotorJoint(IWorldPool pool, MotorJointDef def) {
    super(pool, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.linearOffset, "MotorJointDef.linearOffset");
    JointChecks.finite(def.angularOffset, "MotorJointDef.angularOffset");
    JointChecks.notNegative(def.maxForce, "MotorJointDef.maxForce");
    JointChecks.notNegative(def.maxTorque, "MotorJointDef.maxTorque");
    JointChecks.share(def.correctionFactor, "MotorJointDef.correctionFactor");
    linearOffset.set(def.linearOffset);
    angularOffset = def.angularOffset;
    maxForce = def.maxForce;
    maxTorque = def.maxTorque;
    correctionFactor = def.correctionFactor;
  }

  /** Sets where the origin of body B is wanted, in A's frame, m; a change wakes the bodies. */
  public void setLinearOffset(Vec2 linearOffset) {
    JointChecks.finite(linearOffset, "linearOffset");
    if (linearOffset.x != this.linearOffset.x || linearOffset.y != this.linearOffset.y) {
      this.linearOffset.set(linearOffset);
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns where the origin of body B is wanted, in A's frame, the same object each time. */
  public Vec2 getLinearOffset() {
    return linearOffset;
  }

  /** Writes where the origin of body B is wanted, in A's frame, to {@code out}. */
  public void getLinearOffset(Vec2 out) {
    out.set(linearOffset);
  }

  /** Sets the angle between the bodies that is wanted, rad; a change wakes the bodies. */
  public void setAngularOffset(float angularOffset) {
    JointChecks.finite(angularOffset, "angularOffset");
    if (angularOffset != this.angularOffset) {
      this.angularOffset = angularOffset;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the angle between the bodies that is wanted, rad. */
  public float getAngularOffset() {
    return angularOffset;
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

  /** Sets the share of the error that is to be removed in a step, 0 to 1. */
  public void setCorrectionFactor(float correctionFactor) {
    JointChecks.share(correctionFactor, "correctionFactor");
    this.correctionFactor = correctionFactor;
  }

  /** Returns the share of the error that is to be removed in a step. */
  public float getCorrectionFactor() {
    return correctionFactor;
  }

  /** {@inheritDoc} For this joint: the origin of body A. */
  @Override
  public void getAnchorA(Vec2 out) {
    out.set(m_bodyA.getPosition());
  }

  /** {@inheritDoc} For this joint: the origin of body B. */
  @Override
  public void getAnchorB(Vec2 out) {
    out.set(m_bodyB.getPosition());
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
    JointGather.arms(rows, o, m_bodyA, linearOffset, m_bodyB, localOrigin);
    DriveKernel.writeDrive(rows.f, o, angularOffset, maxForce, maxTorque, correctionFactor);
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
