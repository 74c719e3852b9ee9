package org.jbox2d.dynamics.joints;

/** The kinds of joint. The order of the constants is part of the API. */
public enum JointType {
  UNKNOWN,
  REVOLUTE,
  PRISMATIC,
  DISTANCE,
  PULLEY,
  MOUSE,
  GEAR,
  WHEEL,
  WELD,
  FRICTION,
  ROPE,
  CONSTANT_VOLUME,
  MOTOR
}
