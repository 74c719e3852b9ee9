package org.jbox2d.dynamics.joints;

import org.jbox2d.dynamics.World;

/** Makes joints from definitions. */
final class JointFactory {
  private JointFactory() {}

  static Joint create(World world, JointDef def) {
    if (def.type == null) {
      throw new IllegalArgumentException("JointDef.type is null");
    }
    switch (def.type) {
      case MOUSE:
        return new MouseJoint(world.getPool(), (MouseJointDef) def);
      case DISTANCE:
        return new DistanceJoint(world.getPool(), (DistanceJointDef) def);
      case ROPE:
        return new RopeJoint(world.getPool(), (RopeJointDef) def);
      case REVOLUTE:
        return new RevoluteJoint(world.getPool(), (RevoluteJointDef) def);
      default:
        throw new IllegalArgumentException("JointDef.type has no joint: " + def.type);
    }
  }
}
