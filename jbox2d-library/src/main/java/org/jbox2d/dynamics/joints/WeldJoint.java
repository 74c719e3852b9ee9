package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.WeldKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * Holds two bodies together at a point and at an angle. With a frequency, the angle is held by a
 * spring and the joint bends.
 */
public class WeldJoint extends Joint {
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private final float referenceAngle;
  private float frequencyHz;
  private float dampingRatio;
  private float impulseX;
  private float impulseY;
  private float turnImpulse;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected WeldJoint(IWorldPool argWorld, WeldJointDef def) {
    super(argWorld, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "WeldJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "WeldJointDef.localAnchorB");
    JointChecks.finite(def.referenceAngle, "WeldJointDef.referenceAngle");
    JointChecks.notNegative(def.frequencyHz, "WeldJointDef.frequencyHz");
    JointChecks.notNegative(def.dampingRatio, "WeldJointDef.dampingRatio");
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    referenceAngle = def.referenceAngle;
    frequencyHz = def.frequencyHz;
    dampingRatio = def.dampingRatio;
  }

  /** Returns the point of body A in its frame, the same object each time. */
  public Vec2 getLocalAnchorA() {
    expose();
    return localAnchorA;
  }

  /** Returns the point of body B in its frame, the same object each time. */
  public Vec2 getLocalAnchorB() {
    expose();
    return localAnchorB;
  }

  /** Returns the angle of body B minus that of body A that is kept, rad. */
  public float getReferenceAngle() {
    return referenceAngle;
  }

  /** Returns the frequency of the spring, Hz. */
  public float getFrequency() {
    return frequencyHz;
  }

  /** Sets the frequency of the spring, Hz, 0 for a rigid joint; a change wakes the bodies. */
  public void setFrequency(float hz) {
    JointChecks.notNegative(hz, "hz");
    if (hz != frequencyHz) {
      change();
      frequencyHz = hz;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the damping ratio of the spring. */
  public float getDampingRatio() {
    return dampingRatio;
  }

  /** Sets the damping ratio of the spring. */
  public void setDampingRatio(float ratio) {
    JointChecks.notNegative(ratio, "ratio");
    change();
    dampingRatio = ratio;
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
    readImpulses();
    argOut.set(inv_dt * impulseX, inv_dt * impulseY);
  }

  @Override
  public float getReactionTorque(float inv_dt) {
    readImpulses();
    return inv_dt * turnImpulse;
  }

  @Override
  boolean isRowConstant() {
    return frequencyHz == 0f;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.WELD.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.WELD, WeldKernel.FLOATS, m_bodyA.m_islandIndex, m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    float spin = m_bodyB.m_angularVelocity - m_bodyA.m_angularVelocity;
    WeldKernel.writeAngle(rows.f, o, referenceAngle, frequencyHz, dampingRatio, spin);
    WeldKernel.writeImpulses(rows.f, o, impulseX, impulseY, turnImpulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulseX = WeldKernel.impulseX(rows.f, o);
    impulseY = WeldKernel.impulseY(rows.f, o);
    turnImpulse = WeldKernel.turnImpulse(rows.f, o);
  }
}
