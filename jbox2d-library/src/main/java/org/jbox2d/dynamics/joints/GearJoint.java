package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.solver.GearKernel;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;
import org.jbox2d.pooling.IWorldPool;

/**
 * Couples two joints, each revolute or prismatic: {@code coordinate1 + ratio coordinate2} stays
 * what it was, where a coordinate is an angle (rad) or a translation (m).
 *
 * <p>Bodies A and B of the gear are the bodies B of the two joints. The gear needs both joints:
 * when one of them is destroyed, by itself or with a body, the gear has no effect any more ({@link
 * #isActive} returns false); it stays in the world until it is destroyed itself.
 */
public class GearJoint extends Joint {
  private final Joint joint1;
  private final Joint joint2;
  private float ratio;
  private float constant;
  private float impulse;

  /** Gradient of coordinate 2 by the place of body B in the last step, times the ratio. */
  private float axisX;

  private float axisY;
  private float armB;

  /** Made by {@link org.jbox2d.dynamics.World#createJoint}. */
  protected GearJoint(IWorldPool argWorldPool, GearJointDef def) {
    super(argWorldPool, def);
    joint1 = checked(def.joint1, "GearJointDef.joint1");
    joint2 = checked(def.joint2, "GearJointDef.joint2");
    if (joint1 == joint2) {
      throw new IllegalArgumentException("GearJointDef.joint1 and joint2 are the same joint");
    }
    JointChecks.notZero(def.ratio, "GearJointDef.ratio");
    m_bodyA = joint1.getBodyB();
    m_bodyB = joint2.getBodyB();
    if (m_bodyA.getWorld() != m_bodyB.getWorld()) {
      throw new IllegalArgumentException("GearJointDef.joint1 and joint2 are of different worlds");
    }
    ratio = def.ratio;
    constant = coordinate(joint1) + ratio * coordinate(joint2);
  }

  private static Joint checked(Joint joint, String name) {
    JointChecks.notNull(joint, name);
    if (joint.getType() != JointType.REVOLUTE && joint.getType() != JointType.PRISMATIC) {
      throw new IllegalArgumentException(
          name + " must be revolute or prismatic, is " + joint.getType());
    }
    if (!joint.isLinked()) {
      throw new IllegalArgumentException(name + " was destroyed before");
    }
    return joint;
  }

  private static float coordinate(Joint joint) {
    return joint instanceof RevoluteJoint
        ? ((RevoluteJoint) joint).getJointAngle()
        : ((PrismaticJoint) joint).getJointTranslation();
  }

  /** Returns the first joint. */
  public Joint getJoint1() {
    return joint1;
  }

  /** Returns the second joint. */
  public Joint getJoint2() {
    return joint2;
  }

  /**
   * Sets the ratio, which must not be 0. The joints go on from where they are: the constant is
   * taken anew. A change wakes the bodies.
   */
  public void setRatio(float argRatio) {
    JointChecks.notZero(argRatio, "argRatio");
    if (argRatio != ratio) {
      ratio = argRatio;
      constant = coordinate(joint1) + ratio * coordinate(joint2);
      impulse = 0f;
      JointGather.wake(m_bodyA, m_bodyB);
    }
  }

  /** Returns the ratio. */
  public float getRatio() {
    return ratio;
  }

  /** {@inheritDoc} For this joint: anchor B of the first joint. */
  @Override
  public void getAnchorA(Vec2 argOut) {
    joint1.getAnchorB(argOut);
  }

  /** {@inheritDoc} For this joint: anchor B of the second joint. */
  @Override
  public void getAnchorB(Vec2 argOut) {
    joint2.getAnchorB(argOut);
  }

  @Override
  public void getReactionForce(float inv_dt, Vec2 argOut) {
    argOut.set(inv_dt * impulse * axisX, inv_dt * impulse * axisY);
  }

  @Override
  public float getReactionTorque(float inv_dt) {
    return inv_dt * impulse * armB;
  }

  /** Returns whether both joints are still in the world and all their bodies active. */
  @Override
  public boolean isActive() {
    return joint1.isLinked() && joint2.isLinked() && joint1.isActive() && joint2.isActive();
  }

  @Override
  public int bodyCount() {
    return GearKernel.BODIES;
  }

  /** Bodies B of both joints, then their bodies A. */
  @Override
  public Body body(int i) {
    Joint joint = (i & 1) == 0 ? joint1 : joint2;
    return i < 2 ? joint.getBodyB() : joint.getBodyA();
  }

  @Override
  public int kernelOrder() {
    return JointKernels.GEAR.order();
  }

  @Override
  public int gather(JointRows rows) {
    int row = rows.add(JointKernels.GEAR, GearKernel.FLOATS, GearKernel.BODIES);
    for (int i = 0; i < GearKernel.BODIES; i++) {
      rows.bodies[rows.bodyAt[row] + i] = body(i).m_islandIndex;
    }
    int o = rows.floatAt[row];
    writeHalf(rows.f, o + GearKernel.FIRST, joint1);
    writeHalf(rows.f, o + GearKernel.SECOND, joint2);
    GearKernel.writeCoupling(rows.f, o, ratio, constant, impulse);
    return row;
  }

  private static void writeHalf(float[] f, int half, Joint joint) {
    Vec2 base = joint.getBodyA().m_sweep.localCenter;
    Vec2 moving = joint.getBodyB().m_sweep.localCenter;
    if (joint instanceof RevoluteJoint) {
      float reference = ((RevoluteJoint) joint).m_referenceAngle;
      GearKernel.writeHalf(f, half, false, reference, 0f, 0f, 0f, 0f, 1f, 0f);
    } else {
      PrismaticJoint p = (PrismaticJoint) joint;
      GearKernel.writeHalf(
          f,
          half,
          true,
          p.m_referenceAngle,
          p.m_localAnchorA.x - base.x,
          p.m_localAnchorA.y - base.y,
          p.m_localAnchorB.x - moving.x,
          p.m_localAnchorB.y - moving.y,
          p.m_localXAxisA.x,
          p.m_localXAxisA.y);
    }
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulse = GearKernel.impulse(rows.f, o);
    axisX = GearKernel.gradientX(rows.f, o);
    axisY = GearKernel.gradientY(rows.f, o);
    armB = GearKernel.gradientTurn(rows.f, o);
  }
}
