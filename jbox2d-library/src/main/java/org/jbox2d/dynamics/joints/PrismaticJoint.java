package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.PrismaticKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * Lets body B slide along an axis of body A, without turning. The translation can be limited and
 * driven.
 */
public class PrismaticJoint extends Joint {
  /** Point of body A, in its frame, m. */
  protected final Vec2 m_localAnchorA = new Vec2();

  /** Point of body B, in its frame, m. */
  protected final Vec2 m_localAnchorB = new Vec2();

  /** Unit vector along the axis, in A's frame. */
  protected final Vec2 m_localXAxisA;

  /** The axis turned by a quarter. */
  protected final Vec2 m_localYAxisA;

  /** Angle of body B minus that of body A, rad. */
  protected float m_referenceAngle;

  private boolean limited;
  private float lower;
  private float upper;
  private boolean driven;
  private float speed;
  private float maxForce;
  private float acrossImpulse;
  private float angleImpulse;
  private float motorImpulse;
  private float lowerImpulse;
  private float upperImpulse;
  private float axisX;
  private float axisY;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected PrismaticJoint(IWorldPool argWorld, PrismaticJointDef def) {
    super(argWorld, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "PrismaticJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "PrismaticJointDef.localAnchorB");
    JointChecks.finite(def.referenceAngle, "PrismaticJointDef.referenceAngle");
    JointChecks.limits(
        def.lowerTranslation,
        def.upperTranslation,
        "PrismaticJointDef.lowerTranslation",
        "PrismaticJointDef.upperTranslation");
    JointChecks.finite(def.motorSpeed, "PrismaticJointDef.motorSpeed");
    JointChecks.notNegative(def.maxMotorForce, "PrismaticJointDef.maxMotorForce");
    m_localXAxisA = JointChecks.unit(def.localAxisA, "PrismaticJointDef.localAxisA");
    m_localYAxisA = new Vec2(-m_localXAxisA.y, m_localXAxisA.x);
    m_localAnchorA.set(def.localAnchorA);
    m_localAnchorB.set(def.localAnchorB);
    m_referenceAngle = def.referenceAngle;
    limited = def.enableLimit;
    lower = def.lowerTranslation;
    upper = def.upperTranslation;
    driven = def.enableMotor;
    speed = def.motorSpeed;
    maxForce = def.maxMotorForce;
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

  /** Returns the unit vector along the axis in A's frame, the same object each time. */
  public Vec2 getLocalAxisA() {
    expose();
    return m_localXAxisA;
  }

  /** Returns the angle of body B minus that of body A that is kept, rad. */
  public float getReferenceAngle() {
    return m_referenceAngle;
  }

  /** Returns how far anchor B has moved from anchor A along the axis, m. */
  public float getJointTranslation() {
    return Slide.translation(m_bodyA, m_localAnchorA, m_bodyB, m_localAnchorB, m_localXAxisA);
  }

  /** Returns how fast the translation grows, m/s. */
  public float getJointSpeed() {
    return Slide.speed(m_bodyA, m_localAnchorA, m_bodyB, m_localAnchorB, m_localXAxisA);
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

  /** Returns the least translation, m. */
  public float getLowerLimit() {
    return lower;
  }

  /** Returns the largest translation, m. */
  public float getUpperLimit() {
    return upper;
  }

  /** Sets the limits, m; a change wakes the bodies. */
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

  /** Returns the motor's speed, m/s. */
  public float getMotorSpeed() {
    return speed;
  }

  /** Sets the motor's speed, m/s; a change wakes the bodies. */
  public void setMotorSpeed(float speed) {
    JointChecks.finite(speed, "speed");
    if (speed != this.speed) {
      change();
      this.speed = speed;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's largest force, N. */
  public float getMaxMotorForce() {
    return maxForce;
  }

  /** Sets the motor's largest force, N; a change wakes the bodies. */
  public void setMaxMotorForce(float force) {
    JointChecks.notNegative(force, "force");
    if (force != maxForce) {
      change();
      maxForce = force;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's force on body B in the last step, N. */
  public float getMotorForce(float inv_dt) {
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
    float along = inv_dt * (motorImpulse + lowerImpulse - upperImpulse);
    float across = inv_dt * acrossImpulse;
    argOut.set(along * axisX - across * axisY, along * axisY + across * axisX);
  }

  @Override
  public float getReactionTorque(float inv_dt) {
    readImpulses();
    return inv_dt * angleImpulse;
  }

  @Override
  boolean isRowConstant() {
    return true;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.PRISMATIC.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.PRISMATIC,
            PrismaticKernel.FLOATS,
            m_bodyA.m_islandIndex,
            m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    float[] f = rows.f;
    JointGather.arms(rows, o, m_bodyA, m_localAnchorA, m_bodyB, m_localAnchorB);
    PrismaticKernel.writeAxis(f, o, m_localXAxisA.x, m_localXAxisA.y, m_referenceAngle);
    PrismaticKernel.writeLimit(f, o, limited, lower, upper);
    PrismaticKernel.writeMotor(f, o, driven, speed, maxForce);
    PrismaticKernel.writeImpulses(
        f, o, acrossImpulse, angleImpulse, motorImpulse, lowerImpulse, upperImpulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    float[] f = rows.f;
    acrossImpulse = PrismaticKernel.acrossImpulse(f, o);
    angleImpulse = PrismaticKernel.angleImpulse(f, o);
    motorImpulse = PrismaticKernel.motorImpulse(f, o);
    lowerImpulse = PrismaticKernel.lowerImpulse(f, o);
    upperImpulse = PrismaticKernel.upperImpulse(f, o);
    axisX = PrismaticKernel.axisX(f, o);
    axisY = PrismaticKernel.axisY(f, o);
  }
}
