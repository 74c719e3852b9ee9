package org.jbox2d.dynamics.joints;

import java.util.ArrayList;
import org.jbox2d.dynamics.Body;

/** What a constant volume joint is made from: a ring of at least three bodies. */
public class ConstantVolumeJointDef extends JointDef {
  /** Frequency of the distance joints that are made between neighbours, Hz; 0: rigid. */
  public float frequencyHz;

  /** Damping ratio of the distance joints: 0 none, 1 critical. */
  public float dampingRatio;

  final ArrayList<Body> bodies = new ArrayList<>();

  /** One for each body, to the next one; {@code null} if the joint is to make them. */
  ArrayList<DistanceJoint> joints;

  /** No bodies yet. */
  public ConstantVolumeJointDef() {
    super(JointType.CONSTANT_VOLUME);
  }

  /** Adds the next body of the ring. */
  public void addBody(Body argBody) {
    JointChecks.notNull(argBody, "argBody");
    bodies.add(argBody);
    if (bodies.size() == 1) {
      bodyA = argBody;
    } else if (bodies.size() == 2) {
      bodyB = argBody;
    }
  }

  /** Adds the next body of the ring and the distance joint from it to the one behind. */
  public void addBodyAndJoint(Body argBody, DistanceJoint argJoint) {
    JointChecks.notNull(argJoint, "argJoint");
    addBody(argBody);
    if (joints == null) {
      joints = new ArrayList<>();
    }
    joints.add(argJoint);
  }
}
