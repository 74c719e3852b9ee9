package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.DistanceKernel;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.pooling.IWorldPool;

/**
 * Keeps a point of one body at a distance from a point of the other, like a massless rod, or a
 * spring if a frequency is given.
 *
 * <p>A length below {@link Settings#linearSlop} is held at that value: points that coincide have no
 * direction in which to pull.
 */
public class DistanceJoint extends Joint {
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private float length;
  private float frequencyHz;
  private float dampingRatio;
  private float impulse;
  private float axisX;
  private float axisY;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected DistanceJoint(IWorldPool argWorld, DistanceJointDef def) {
    super(argWorld, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "DistanceJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "DistanceJointDef.localAnchorB");
    JointChecks.notNegative(def.length, "DistanceJointDef.length");
    JointChecks.notNegative(def.frequencyHz, "DistanceJointDef.frequencyHz");
    JointChecks.notNegative(def.dampingRatio, "DistanceJointDef.dampingRatio");
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    length = def.length;
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

  /** Sets the length, m; a change wakes the bodies. */
  public void setLength(float length) {
    JointChecks.notNegative(length, "length");
    if (length != this.length) {
      change();
      this.length = length;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the length, m. */
  public float getLength() {
    return length;
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

  /** Returns the frequency of the spring, Hz. */
  public float getFrequency() {
    return frequencyHz;
  }

  /** Sets the damping ratio of the spring. */
  public void setDampingRatio(float damp) {
    JointChecks.notNegative(damp, "damp");
    change();
    dampingRatio = damp;
  }

  /** Returns the damping ratio of the spring. */
  public float getDampingRatio() {
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
    readImpulses();
    argOut.set(inv_dt * impulse * axisX, inv_dt * impulse * axisY);
  }

  /** {@inheritDoc} For this joint: 0. */
  @Override
  public float getReactionTorque(float inv_dt) {
    return 0f;
  }

  @Override
  boolean isRowConstant() {
    return frequencyHz == 0f;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.DISTANCE.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.DISTANCE,
            DistanceKernel.FLOATS,
            m_bodyA.m_islandIndex,
            m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    JointGather.velocities(rows.f, o + DistanceKernel.BEFORE, m_bodyA, m_bodyB);
    float held = Math.max(length, Settings.linearSlop);
    DistanceKernel.write(rows.f, o, held, frequencyHz, dampingRatio, impulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulse = DistanceKernel.impulse(rows.f, o);
    axisX = DistanceKernel.axisX(rows.f, o);
    axisY = DistanceKernel.axisY(rows.f, o);
  }
}
