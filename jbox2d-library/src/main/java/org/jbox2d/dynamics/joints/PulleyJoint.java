package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.dynamics.solver.PulleyKernel;
import org.jbox2d.pooling.IWorldPool;

/**
 * Two bodies on one rope over two fixed points: {@code lengthA + ratio lengthB} stays what it was.
 * The rope is always taut, as in JBox2D. A side that has no length left takes no part until it has.
 */
public class PulleyJoint extends Joint {
  /** Kept for programs that read it; the joint has no least length. */
  public static final float MIN_PULLEY_LENGTH = 2f;

  private final Vec2 groundAnchorA = new Vec2();
  private final Vec2 groundAnchorB = new Vec2();
  private final Vec2 localAnchorA = new Vec2();
  private final Vec2 localAnchorB = new Vec2();
  private final float lengthA;
  private final float lengthB;
  private final float ratio;
  private float impulse;
  private float directionX;
  private float directionY;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected PulleyJoint(IWorldPool argWorldPool, PulleyJointDef def) {
    super(argWorldPool, def);
    JointChecks.differentBodies(def);
    JointChecks.finite(def.groundAnchorA, "PulleyJointDef.groundAnchorA");
    JointChecks.finite(def.groundAnchorB, "PulleyJointDef.groundAnchorB");
    JointChecks.finite(def.localAnchorA, "PulleyJointDef.localAnchorA");
    JointChecks.finite(def.localAnchorB, "PulleyJointDef.localAnchorB");
    JointChecks.notNegative(def.lengthA, "PulleyJointDef.lengthA");
    JointChecks.notNegative(def.lengthB, "PulleyJointDef.lengthB");
    JointChecks.positive(def.ratio, "PulleyJointDef.ratio");
    groundAnchorA.set(def.groundAnchorA);
    groundAnchorB.set(def.groundAnchorB);
    localAnchorA.set(def.localAnchorA);
    localAnchorB.set(def.localAnchorB);
    lengthA = def.lengthA;
    lengthB = def.lengthB;
    ratio = def.ratio;
  }

  /** Returns the point of body A in its frame, the same object each time. */
  public Vec2 getLocalAnchorA() {
    return localAnchorA;
  }

  /** Returns the point of body B in its frame, the same object each time. */
  public Vec2 getLocalAnchorB() {
    return localAnchorB;
  }

  /** Returns the fixed point of side A, the same object each time. */
  public Vec2 getGroundAnchorA() {
    return groundAnchorA;
  }

  /** Returns the fixed point of side B, the same object each time. */
  public Vec2 getGroundAnchorB() {
    return groundAnchorB;
  }

  /** Returns the length that side A had in the definition, m. */
  public float getLengthA() {
    return lengthA;
  }

  /** Returns the length that side B had in the definition, m. */
  public float getLengthB() {
    return lengthB;
  }

  /** Returns the length of side A now, m. */
  public float getCurrentLengthA() {
    return length(m_bodyA, localAnchorA, groundAnchorA);
  }

  /** Returns the length of side B now, m. */
  public float getCurrentLengthB() {
    return length(m_bodyB, localAnchorB, groundAnchorB);
  }

  /** Returns the length of side A now, m. */
  public float getLength1() {
    return getCurrentLengthA();
  }

  /** Returns the length of side B now, m. */
  public float getLength2() {
    return getCurrentLengthB();
  }

  private static float length(Body body, Vec2 local, Vec2 ground) {
    float dx = body.m_xf.p.x + body.m_xf.q.c * local.x - body.m_xf.q.s * local.y - ground.x;
    float dy = body.m_xf.p.y + body.m_xf.q.s * local.x + body.m_xf.q.c * local.y - ground.y;
    return (float) Math.sqrt(dx * dx + dy * dy);
  }

  /** Returns the ratio. */
  public float getRatio() {
    return ratio;
  }

  @Override
  public void getAnchorA(Vec2 argOut) {
    m_bodyA.getWorldPointToOut(localAnchorA, argOut);
  }

  @Override
  public void getAnchorB(Vec2 argOut) {
    m_bodyB.getWorldPointToOut(localAnchorB, argOut);
  }

  /** {@inheritDoc} For this joint: the pull of side B, {@code ratio} times that of side A. */
  @Override
  public void getReactionForce(float inv_dt, Vec2 argOut) {
    float pull = inv_dt * ratio * impulse;
    argOut.set(-pull * directionX, -pull * directionY);
  }

  /** {@inheritDoc} For this joint: 0. */
  @Override
  public float getReactionTorque(float inv_dt) {
    return 0f;
  }

  @Override
  public int kernelOrder() {
    return JointKernels.PULLEY.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row =
        rows.add(
            JointKernels.PULLEY, PulleyKernel.FLOATS, m_bodyA.m_islandIndex, m_bodyB.m_islandIndex);
    int o = rows.floatAt[row];
    JointGather.arms(rows, o, m_bodyA, localAnchorA, m_bodyB, localAnchorB);
    PulleyKernel.writeGround(
        rows.f, o, groundAnchorA.x, groundAnchorA.y, groundAnchorB.x, groundAnchorB.y);
    PulleyKernel.writeRope(rows.f, o, ratio, lengthA + ratio * lengthB, impulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulse = PulleyKernel.impulse(rows.f, o);
    directionX = PulleyKernel.directionX(rows.f, o);
    directionY = PulleyKernel.directionY(rows.f, o);
  }
}
