package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.WheelKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * A wheel (body B) on a sprung suspension along an axis of the chassis (body A). The wheel turns
 * freely or is driven by a motor.
 */
public class WheelJoint extends Joint {
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private final Vec2 localAxisA;
  private float frequencyHz;
  private float dampingRatio;
  private boolean driven;
  private float speed;
  private float maxTorque;
  private float acrossImpulse;
  private float springImpulse;
  private float motorImpulse;
  private float axisX;
  private float axisY;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected WheelJoint(IWorldPool argPool, WheelJointDef def) {
    super(argPool, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "WheelJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "WheelJointDef.localAnchorB");
    JointChecks.finite(def.motorSpeed, "WheelJointDef.motorSpeed");
    JointChecks.notNegative(def.maxMotorTorque, "WheelJointDef.maxMotorTorque");
    JointChecks.notNegative(def.frequencyHz, "WheelJointDef.frequencyHz");
    JointChecks.notNegative(def.dampingRatio, "WheelJointDef.dampingRatio");
    localAxisA = JointChecks.unit(def.localAxisA, "WheelJointDef.localAxisA");
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    frequencyHz = def.frequencyHz;
    dampingRatio = def.dampingRatio;
    driven = def.enableMotor;
    speed = def.motorSpeed;
    maxTorque = def.maxMotorTorque;
  }

  /** Returns the point of body A in its frame, the same object each time. */
  public Vec2 getLocalAnchorA() {
    return localAnchorA;
  }

  /** Returns the point of body B in its frame, the same object each time. */
  public Vec2 getLocalAnchorB() {
    return localAnchorB;
  }

  /** Returns the unit vector along the suspension in A's frame, the same object each time. */
  public Vec2 getLocalAxisA() {
    return localAxisA;
  }

  /** Returns how far anchor B has moved from anchor A along the axis, m. */
  public float getJointTranslation() {
    return Slide.translation(m_bodyA, localAnchorA, m_bodyB, localAnchorB, localAxisA);
  }

  /** Returns the angular velocity of the wheel seen from the chassis, rad/s. */
  public float getJointSpeed() {
    return m_bodyB.m_angularVelocity - m_bodyA.m_angularVelocity;
  }

  /** Returns whether the motor runs. */
  public boolean isMotorEnabled() {
    return driven;
  }

  /** Sets whether the motor runs; a change wakes the bodies. */
  public void enableMotor(boolean flag) {
    if (flag != driven) {
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
      maxTorque = torque;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the motor's torque on body B in the last step, N m. */
  public float getMotorTorque(float inv_dt) {
    return inv_dt * motorImpulse;
  }

  /** Sets the frequency of the suspension, Hz, 0 for none; a change wakes the bodies. */
  public void setSpringFrequencyHz(float hz) {
    JointChecks.notNegative(hz, "hz");
    if (hz != frequencyHz) {
      frequencyHz = hz;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the frequency of the suspension, Hz. */
  public float getSpringFrequencyHz() {
    return frequencyHz;
  }

  /** Sets the damping ratio of the suspension. */
  public void setSpringDampingRatio(float ratio) {
    JointChecks.notNegative(ratio, "ratio");
    dampingRatio = ratio;
  }

  /** Returns the damping ratio of the suspension. */
  public float getSpringDampingRatio() {
    return dampingRatio;
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
    float along = inv_dt * springImpulse;
    float across = inv_dt * acrossImpulse;
    argOut.set(along * axisX - across * axisY, along * axisY + across * axisX);
  }

  /** {@inheritDoc} For this joint: the motor's. */
  @Override
  public float getReactionTorque(float inv_dt) {
    return inv_dt * motorImpulse;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.WHEEL.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.WHEEL, WheelKernel.FLOATS, m_bodyA.m_islandIndex, m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    float[] f = rows.f;
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    JointGather.velocities(f, o + WheelKernel.BEFORE, m_bodyA, m_bodyB);
    WheelKernel.writeSpring(f, o, localAxisA.x, localAxisA.y, frequencyHz, dampingRatio);
    WheelKernel.writeMotor(f, o, driven, speed, maxTorque);
    WheelKernel.writeImpulses(f, o, acrossImpulse, springImpulse, motorImpulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    float[] f = rows.f;
    acrossImpulse = WheelKernel.acrossImpulse(f, o);
    springImpulse = WheelKernel.springImpulse(f, o);
    motorImpulse = WheelKernel.motorImpulse(f, o);
    axisX = WheelKernel.axisX(f, o);
    axisY = WheelKernel.axisY(f, o);
  }
}
