package org.jbox2d.common;

/** Where a ray hit: the fraction of the ray, and the surface normal there. */
public class RaycastResult {

  public float lambda;
  public final Vec2 normal = new Vec2();

  public RaycastResult() {}

  public RaycastResult set(RaycastResult argOther) {
    lambda = argOther.lambda;
    normal.set(argOther.normal);
    return this;
  }
}
