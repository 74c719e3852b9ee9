package org.jbox2d.dynamics.joints;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.solver.ConstantVolumeKernel;
import org.jbox2d.dynamics.solver.JointKernels;
import org.jbox2d.dynamics.solver.JointRows;

/**
 * Keeps the area inside a ring of bodies, whose neighbours are held by distance joints. A soft
 * body.
 *
 * <p>Unless the definition brings them, the joint makes the distance joints itself. They go when it
 * goes. If a body of the ring is destroyed, the joint has no effect any more ({@link #isActive}
 * returns false); it stays in the world until it is destroyed itself, or goes with body A or B, the
 * first two of the ring.
 */
public class ConstantVolumeJoint extends Joint {
  private final World world;
  private final Body[] bodies;
  private final DistanceJoint[] distanceJoints;
  private float targetVolume;
  private float impulse;

  /** Gradient of the area by the place of body B in the last step, m. */
  private float gradientX;

  private float gradientY;

  /**
   * Made by {@link World#createJoint}.
   *
   * @throws IllegalArgumentException if there are fewer than three bodies, one comes twice or is of
   *     another world, or there are joints but not one for each body
   */
  public ConstantVolumeJoint(World argWorld, ConstantVolumeJointDef def) {
    super(argWorld.getPool(), def);
    check(argWorld, def);
    world = argWorld;
    bodies = def.bodies.toArray(new Body[0]);
    distanceJoints =
        def.joints == null ? makeJoints(def) : def.joints.toArray(new DistanceJoint[0]);
    targetVolume = area();
  }

  private static void check(World world, ConstantVolumeJointDef def) {
    int n = def.bodies.size();
    if (n < 3) {
      throw new IllegalArgumentException(
          "ConstantVolumeJointDef must have at least 3 bodies, has " + n);
    }
    if (def.joints != null && def.joints.size() != n) {
      throw new IllegalArgumentException(
          "ConstantVolumeJointDef must have a joint for each of its "
              + n
              + " bodies, has "
              + def.joints.size());
    }
    JointChecks.notNegative(def.frequencyHz, "ConstantVolumeJointDef.frequencyHz");
    JointChecks.notNegative(def.dampingRatio, "ConstantVolumeJointDef.dampingRatio");
    for (int i = 0; i < n; i++) {
      Body body = def.bodies.get(i);
      if (body.getWorld() != world) {
        throw new IllegalArgumentException(
            "ConstantVolumeJointDef body " + i + " is not of this world, or was destroyed before");
      }
      if (def.bodies.indexOf(body) != i) {
        throw new IllegalArgumentException("ConstantVolumeJointDef body " + i + " comes twice");
      }
    }
  }

  private DistanceJoint[] makeJoints(ConstantVolumeJointDef def) {
    DistanceJoint[] made = new DistanceJoint[bodies.length];
    for (int i = 0; i < bodies.length; i++) {
      Body next = bodies[(i + 1) % bodies.length];
      DistanceJointDef edge = new DistanceJointDef();
      edge.initialize(bodies[i], next, bodies[i].getWorldCenter(), next.getWorldCenter());
      edge.frequencyHz = def.frequencyHz;
      edge.dampingRatio = def.dampingRatio;
      edge.collideConnected = def.collideConnected;
      made[i] = (DistanceJoint) world.createJoint(edge);
    }
    return made;
  }

  /** Area of the ring, m^2; negative if it goes round clockwise. */
  private float area() {
    Vec2 origin = bodies[0].m_sweep.c;
    float area = 0f;
    for (int i = 1; i + 1 < bodies.length; i++) {
      Vec2 p = bodies[i].m_sweep.c;
      Vec2 q = bodies[i + 1].m_sweep.c;
      area += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
    }
    return 0.5f * area;
  }

  /** Returns the bodies of the ring. */
  public Body[] getBodies() {
    return bodies;
  }

  /** Returns the distance joints between neighbours. */
  public DistanceJoint[] getJoints() {
    return distanceJoints;
  }

  /** Multiplies the area that is kept by a positive factor; wakes the bodies. */
  public void inflate(float factor) {
    JointChecks.positive(factor, "factor");
    targetVolume *= factor;
    for (Body body : bodies) {
      JointGather.wake(body, body);
    }
  }

  /** Destroys those of the distance joints that are still there. */
  @Override
  public void destructor() {
    for (DistanceJoint joint : distanceJoints) {
      if (joint.isLinked()) {
        world.destroyJoint(joint);
      }
    }
  }

  /** {@inheritDoc} For this joint: the centre of body A. */
  @Override
  public void getAnchorA(Vec2 argOut) {
    argOut.set(m_bodyA.getWorldCenter());
  }

  /** {@inheritDoc} For this joint: the centre of body B. */
  @Override
  public void getAnchorB(Vec2 argOut) {
    argOut.set(m_bodyB.getWorldCenter());
  }

  /** {@inheritDoc} For this joint: that of the pressure. */
  @Override
  public void getReactionForce(float inv_dt, Vec2 argOut) {
    argOut.set(inv_dt * impulse * gradientX, inv_dt * impulse * gradientY);
  }

  /** {@inheritDoc} For this joint: 0. */
  @Override
  public float getReactionTorque(float inv_dt) {
    return 0f;
  }

  /** Returns whether all bodies of the ring are still in the world and active. */
  @Override
  public boolean isActive() {
    for (Body body : bodies) {
      if (body.getWorld() == null || !body.isActive()) {
        return false;
      }
    }
    return true;
  }

  @Override
  public int bodyCount() {
    return bodies.length;
  }

  @Override
  public Body body(int i) {
    return bodies[i];
  }

  @Override
  public int kernelOrder() {
    return JointKernels.CONSTANT_VOLUME.order();
  }

  @Override
  public int gather(JointRows rows) {
    int n = bodies.length;
    int row = rows.add(JointKernels.CONSTANT_VOLUME, ConstantVolumeKernel.floats(n), n);
    for (int i = 0; i < n; i++) {
      rows.bodies[rows.bodyAt[row] + i] = bodies[i].m_islandIndex;
    }
    ConstantVolumeKernel.write(rows.f, rows.floatAt[row], targetVolume, impulse);
    return row;
  }

  @Override
  public void scatter(JointRows rows, int row) {
    int o = rows.floatAt[row];
    impulse = ConstantVolumeKernel.impulse(rows.f, o);
    gradientX = ConstantVolumeKernel.gradientX(rows.f, o, 1);
    gradientY = ConstantVolumeKernel.gradientY(rows.f, o, 1);
  }
}
