package org.jbox2d.fracture;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.fracture.impact.Request;

/**
 * A fracture that is about to happen; a listener may call it off or change the material by which
 * the body breaks.
 */
public final class FractureProposal {
  private final FractureCause cause;
  private Request request;

  FractureProposal(FractureCause cause, Request request) {
    this.cause = cause;
    this.request = request;
  }

  /** Returns what makes the body break. */
  public FractureCause cause() {
    return cause;
  }

  /** Returns the body that is about to break. */
  public Body body() {
    return request.body;
  }

  /** Returns the fixture that was struck hardest. */
  public Fixture fixture() {
    return request.fixture;
  }

  /** Returns the material by which it will break; {@code null} for a cut. */
  public Material material() {
    return request.material;
  }

  /**
   * Sets the material by which it will break: its sites, its radius, and the material of its
   * splinters.
   */
  public void setMaterial(Material material) {
    if (material == null) {
      throw new IllegalArgumentException("material is null");
    }
    material.check();
    request = request.with(material);
  }

  /** Returns the impulse of the blow, N s; 0 for a cut. */
  public float intensity() {
    return request.intensity;
  }

  /** Returns where the hardest blow struck, in the body's frame, m, as a new vector. */
  public Vec2 point() {
    return request.hardest().point.clone();
  }

  Request request() {
    return request;
  }
}
