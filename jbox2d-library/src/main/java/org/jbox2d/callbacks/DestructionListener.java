package org.jbox2d.callbacks;

import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.joints.Joint;

/** Hears of joints and fixtures that go because their body is destroyed. */
public interface DestructionListener {
  /** A joint goes because one of its bodies is destroyed. */
  void sayGoodbye(Joint joint);

  /** A fixture goes because its body is destroyed. */
  void sayGoodbye(Fixture fixture);
}
