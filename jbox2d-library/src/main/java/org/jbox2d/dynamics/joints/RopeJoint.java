package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.RopeKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * Keeps a point of one body from getting further from a point of the other than a length. It pulls
 * and never pushes. A length below {@link Settings#linearSlop} is held at that value.
 */
public class RopeJoint extends Joint {
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private float maxLength;
  private float impulse;
  private float axisX;
  private float axisY;
  private LimitState state = LimitState.INACTIVE;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected RopeJoint(IWorldPool worldPool, RopeJointDef def) {
    super(worldPool, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.localAnchorA, "RopeJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "RopeJointDef.localAnchorB");
    JointChecks.notNegative(def.maxLength, "RopeJointDef.maxLength");
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    maxLength = def.maxLength;
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

  /** Returns the length, m. */
  public float getMaxLength() {
    return maxLength;
  }

  /** Sets the length, m; a change wakes the bodies. */
  public void setMaxLength(float maxLength) {
    JointChecks.notNegative(maxLength, "maxLength");
    if (maxLength != this.maxLength) {
      change();
      this.maxLength = maxLength;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns {@link LimitState#AT_UPPER} if the rope was taut in the last step, else inactive. */
  public LimitState getLimitState() {
    readImpulses();
    return state;
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
    return true;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.ROPE.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.ROPE, RopeKernel.FLOATS, m_bodyA.m_islandIndex, m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    RopeKernel.write(rows.f, o, Math.max(maxLength, Settings.linearSlop), impulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulse = RopeKernel.impulse(rows.f, o);
    axisX = RopeKernel.axisX(rows.f, o);
    axisY = RopeKernel.axisY(rows.f, o);
    boolean taut = impulse < 0f || RopeKernel.excess(rows.f, o) > 0f;
    state = taut ? LimitState.AT_UPPER : LimitState.INACTIVE;
  }
}
