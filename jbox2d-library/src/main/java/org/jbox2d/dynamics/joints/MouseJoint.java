package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.MouseKernel;
import org.jbox2d.pooling.IWorldPool;

/** Drags a point of a body towards a world point, with a soft spring of limited force. */
public class MouseJoint extends Joint {
  private final Vec2 localAnchorB = new Vec2();
  private final Vec2 target = new Vec2();
  private final Vec2 impulse = new Vec2();
  private float maxForce;
  private float frequencyHz;
  private float dampingRatio;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected MouseJoint(IWorldPool argWorld, MouseJointDef def) {
    super(argWorld, def);
    JointChecks.finite(def.target, "MouseJointDef.target");
    JointChecks.notNegative(def.maxForce, "MouseJointDef.maxForce");
    JointChecks.notNegative(def.frequencyHz, "MouseJointDef.frequencyHz");
    JointChecks.notNegative(def.dampingRatio, "MouseJointDef.dampingRatio");
    target.set(def.target);
    Transform.mulTransToOutUnsafe(m_bodyB.getTransform(), target, localAnchorB);
    maxForce = def.maxForce;
    frequencyHz = def.frequencyHz;
    dampingRatio = def.dampingRatio;
  }

  /** Moves the target, m; wakes the body. */
  public void setTarget(Vec2 target) {
    JointChecks.finite(target, "target");
    if (!m_bodyB.isAwake()) {
      m_bodyB.setAwake(true);
    }
    this.target.set(target);
  }

  /** Returns the target. */
  public Vec2 getTarget() {
    return target;
  }

  /** Sets the largest force, N. */
  public void setMaxForce(float force) {
    JointChecks.notNegative(force, "force");
    maxForce = force;
  }

  /** Returns the largest force, N. */
  public float getMaxForce() {
    return maxForce;
  }

  /** Sets the frequency, Hz. */
  public void setFrequency(float hz) {
    JointChecks.notNegative(hz, "hz");
    frequencyHz = hz;
  }

  /** Returns the frequency, Hz. */
  public float getFrequency() {
    return frequencyHz;
  }

  /** Sets the damping ratio. */
  public void setDampingRatio(float ratio) {
    JointChecks.notNegative(ratio, "ratio");
    dampingRatio = ratio;
  }

  /** Returns the damping ratio. */
  public float getDampingRatio() {
    return dampingRatio;
  }

  /** {@inheritDoc} For this joint: the target. */
  @Override
  public void getAnchorA(Vec2 argOut) {
    argOut.set(target);
  }

  @Override
  public void getAnchorB(Vec2 argOut) {
    m_bodyB.getWorldPointToOut(localAnchorB, argOut);
  }

  @Override
  public void getReactionForce(float invDt, Vec2 argOut) {
    argOut.set(invDt * impulse.x, invDt * impulse.y);
  }

  @Override
  public float getReactionTorque(float invDt) {
    return 0f;
  }

  /** Only body B takes part: body A is a formality. */
  @Override
  public int bodyCount() {
    return 1;
  }

  @Override
  public Body body(int i) {
    return m_bodyB;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.MOUSE.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row = rows.add(JointKernels.MOUSE, MouseKernel.FLOATS, 1);
    rows.bodies[rows.bodyAt[row]] = m_bodyB.m_islandIndex;
    Vec2 centre = m_bodyB.m_sweep.localCenter;
    MouseKernel.write(
        rows.f,
        rows.floatAt[row],
        localAnchorB.x - centre.x,
        localAnchorB.y - centre.y,
        target.x,
        target.y,
        m_bodyB.m_mass,
        frequencyHz,
        dampingRatio,
        maxForce,
        impulse.x,
        impulse.y);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    impulse.x = MouseKernel.impulseX(rows.f, rows.floatAt[row]);
    impulse.y = MouseKernel.impulseY(rows.f, rows.floatAt[row]);
  }
}
