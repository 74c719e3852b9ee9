package org.jbox2d.dynamics.joints;

import org.jbox2d.dynamics.World;
import org.jbox2d.pooling.IWorldPool;

/** Makes joints from definitions. */
final class JointFactory {
  private JointFactory() {}

  static Joint create(World world, JointDef def) {
    JointChecks.notNull(def.type, "JointDef.type");
    IWorldPool pool = world.getPool();
    switch (def.type) {
      case REVOLUTE:
        return new RevoluteJoint(pool, as(RevoluteJointDef.class, def));
      case PRISMATIC:
        return new PrismaticJoint(pool, as(PrismaticJointDef.class, def));
      case DISTANCE:
        return new DistanceJoint(pool, as(DistanceJointDef.class, def));
      case PULLEY:
        return new PulleyJoint(pool, as(PulleyJointDef.class, def));
      case MOUSE:
        return new MouseJoint(pool, as(MouseJointDef.class, def));
      case GEAR:
        return new GearJoint(pool, as(GearJointDef.class, def));
      case WHEEL:
        return new WheelJoint(pool, as(WheelJointDef.class, def));
      case WELD:
        return new WeldJoint(pool, as(WeldJointDef.class, def));
      case FRICTION:
        return new FrictionJoint(pool, as(FrictionJointDef.class, def));
      case ROPE:
        return new RopeJoint(pool, as(RopeJointDef.class, def));
      case CONSTANT_VOLUME:
        return new ConstantVolumeJoint(world, as(ConstantVolumeJointDef.class, def));
      case MOTOR:
        return new MotorJoint(pool, as(MotorJointDef.class, def));
      default:
        throw new IllegalArgumentException("JointDef.type has no joint: " + def.type);
    }
  }

  /** The type can be set by hand; it must fit the class. */
  private static <T extends JointDef> T as(Class<T> expected, JointDef def) {
    if (!expected.isInstance(def)) {
      throw new IllegalArgumentException(
          "JointDef.type " + def.type + " is not that of " + def.getClass().getSimpleName());
    }
    return expected.cast(def);
  }
}
