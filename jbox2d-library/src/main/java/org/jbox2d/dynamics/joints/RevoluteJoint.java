package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.RevoluteKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * Pins a point of one body to a point of the other; the bodies turn about it. The angle between
 * them can be limited and driven.
 */
public class RevoluteJoint extends Joint {
  /** Point of body A, in its frame, m. */
  protected final Vec2 m_localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  protected final Vec2 m_localAnchorB = new Vec2();

  /** Angle of body B minus that of body A where the joint's angle is 0, rad. */
  protected float m_referenceAngle;

  private boolean limited;
  private float lower;
  private float upper;
  private boolean driven;
  private float speed;
  private float maxTorque;
  private float impulseX;
  private float impulseY;
  private float motorImpulse;
  private float lowerImpulse;
  private float upperImpulse;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected RevoluteJoint(IWorldPool argWorld, RevoluteJointDef def) {
    super(argWorld, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "RevoluteJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "RevoluteJointDef.localAnchorB");
    JointChecks.finite(def.referenceAngle, "RevoluteJointDef.referenceAngle");
    JointChecks.limits(
        def.lowerAngle,
        def.upperAngle,
        "RevoluteJointDef.lowerAngle",
        "RevoluteJointDef.upperAngle");
    JointChecks.finite(def.motorSpeed, "RevoluteJointDef.motorSpeed");
    JointChecks.notNegative(def.maxMotorTorque, "RevoluteJointDef.maxMotorTorque");
    m_localAnchorA.set(def.localAnchorA);
    m_localAnchorB.set(def.localAnchorB);
    m_referenceAngle = def.referenceAngle;
    limited = def.enableLimit;
    lower = def.lowerAngle;
    upper = def.upperAngle;
    driven = def.enableMotor;
    speed = def.motorSpeed;
    maxTorque = def.maxMotorTorque;
  }

  /** Returns the point of body A in its frame, the same object each time. */
  public Vec2 getLocalAnchorA() {
    expose();
    return m_localAnchorA;
  }

  /** Returns the point of body B in its frame, the same object each time. */
  public Vec2 getLocalAnchorB() {
    expose();
    return m_localAnchorB;
  }

  /** Returns the angle between the bodies where the joint's angle is 0, rad. */
  public float getReferenceAngle() {
    return m_referenceAngle;
  }

  /** Returns the angle of the joint, rad; it counts whole turns. */
  public float getJointAngle() {
    return m_bodyB.m_sweep.a - m_bodyA.m_sweep.a - m_referenceAngle;
  }

  /** Returns the angular velocity of body B seen from body A, rad/s. */
  public float getJointSpeed() {
    return m_bodyB.m_angularVelocity - m_bodyA.m_angularVelocity;
  }

  /** Returns whether the limits hold. */
  public boolean isLimitEnabled() {
    return limited;
  }

  /** Sets whether the limits hold; a change wakes the bodies. */
  public void enableLimit(boolean flag) {
    if (flag != limited) {
      change();
      limited = flag;
      lowerImpulse = 0f;
      upperImpulse = 0f;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the least angle, rad. */
  public float getLowerLimit() {
    return lower;
  }

  /** Returns the largest angle, rad. */
  public float getUpperLimit() {
    return upper;
  }

  /** Sets the limits, rad; a change wakes the bodies. */
  public void setLimits(float lower, float upper) {
    JointChecks.limits(lower, upper, "lower", "upper");
    if (lower != this.lower || upper != this.upper) {
      change();
      this.lower = lower;
      this.upper = upper;
      lowerImpulse = 0f;
      upperImpulse = 0f;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns whether the motor runs. */
  public boolean isMotorEnabled() {
    return driven;
  }

  /** Sets whether the motor runs; a change wakes the bodies. */
  public void enableMotor(boolean flag) {
    if (flag != driven) {
      change();
      driven = flag;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's speed, rad/s. */
  public float getMotorSpeed() {
    return speed;
  }

  /** Sets the motor's speed, rad/s; a change wakes the bodies. */
  public void setMotorSpeed(float speed) {
    JointChecks.finite(speed, "speed");
    if (speed != this.speed) {
      change();
      this.speed = speed;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's largest torque, N m. */
  public float getMaxMotorTorque() {
    return maxTorque;
  }

  /** Sets the motor's largest torque, N m; a change wakes the bodies. */
  public void setMaxMotorTorque(float torque) {
    JointChecks.notNegative(torque, "torque");
    if (torque != maxTorque) {
      change();
      maxTorque = torque;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's torque on body B in the last step, N m. */
  public float getMotorTorque(float inv_dt) {
    readImpulses();
    return inv_dt * motorImpulse;
  }

  @Override
  public void getAnchorA(Vec2 argOut) {
    m_bodyA.getWorldPointToOut(m_localAnchorA, argOut);
  }

  @Override
  public void getAnchorB(Vec2 argOut) {
    m_bodyB.getWorldPointToOut(m_localAnchorB, argOut);
  }

  @Override
  public void getReactionForce(float inv_dt, Vec2 argOut) {
    readImpulses();
    argOut.set(inv_dt * impulseX, inv_dt * impulseY);
  }

  /** {@inheritDoc} For this joint: of limits and motor together. */
  @Override
  public float getReactionTorque(float inv_dt) {
    readImpulses();
    return inv_dt * (motorImpulse + lowerImpulse - upperImpulse);
  }

  @Override
  boolean isRowConstant() {
    return true;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.REVOLUTE.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.REVOLUTE,
            RevoluteKernel.FLOATS,
            m_bodyA.m_islandIndex,
            m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    float[] f = rows.f;
    JointGather.arms(rows, o, m_bodyA, m_localAnchorA, m_bodyB, m_localAnchorB);
    RevoluteKernel.writeLimit(f, o, m_referenceAngle, limited, lower, upper);
    RevoluteKernel.writeMotor(f, o, driven, speed, maxTorque);
    RevoluteKernel.writeImpulses(
        f, o, impulseX, impulseY, motorImpulse, lowerImpulse, upperImpulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulseX = RevoluteKernel.impulseX(rows.f, o);
    impulseY = RevoluteKernel.impulseY(rows.f, o);
    motorImpulse = RevoluteKernel.motorImpulse(rows.f, o);
    lowerImpulse = RevoluteKernel.lowerImpulse(rows.f, o);
    upperImpulse = RevoluteKernel.upperImpulse(rows.f, o);
  }
}
