package org.jbox2d.dynamics;

/** A hash over the bits of all bodies' states. */
final class StateHash {
  private StateHash() {}

  static long of(World world) {
    long hash = 17;
    for (Body b = world.getBodyList(); b != null; b = b.getNext()) {
      hash = mix(hash, b.m_xf.p.x);
      hash = mix(hash, b.m_xf.p.y);
      hash = mix(hash, b.m_sweep.a);
      hash = mix(hash, b.m_linearVelocity.x);
      hash = mix(hash, b.m_linearVelocity.y);
      hash = mix(hash, b.m_angularVelocity);
      hash = hash * 31 + (b.isAwake() ? 1 : 0);
    }
    return hash * 31 + world.getContactCount();
  }

  private static long mix(long hash, float value) {
    return hash * 0x9E3779B97F4A7C15L + Float.floatToRawIntBits(value);
  }
}
