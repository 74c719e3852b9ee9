package org.jbox2d.dynamics;

import org.jbox2d.collision.shapes.Shape;

/**
 * What a fixture is made from. May be used again for further fixtures: shape and filter are copied.
 */
public class FixtureDef {
  /** The shape; must be set. It is cloned. */
  public Shape shape;

  /** Handed back by {@link Fixture#getUserData()}. */
  public Object userData;

  /** Coefficient of friction, usually in [0, 1]. */
  public float friction;

  /** Coefficient of restitution (bounce), usually in [0, 1]. */
  public float restitution;

  /** Density, kg/m^2. */
  public float density;

  /** Whether the fixture only reports contacts and never pushes. */
  public boolean isSensor;

  /** Which fixtures it collides with. */
  public Filter filter;

  /**
   * Hears of the fixture's solved contacts, such as a material that breaks; {@code null} for none.
   */
  public FixtureMaterial material;

  /** No shape, friction 0.2, restitution 0, density 0, no material. */
  public FixtureDef() {
    friction = 0.2f;
    filter = new Filter();
  }

  /** Returns the shape. */
  public Shape getShape() {
    return shape;
  }

  /** Sets the shape. */
  public void setShape(Shape shape) {
    this.shape = shape;
  }

  /** Returns the user data. */
  public Object getUserData() {
    return userData;
  }

  /** Sets the user data. */
  public void setUserData(Object userData) {
    this.userData = userData;
  }

  /** Returns the coefficient of friction. */
  public float getFriction() {
    return friction;
  }

  /** Sets the coefficient of friction. */
  public void setFriction(float friction) {
    this.friction = friction;
  }

  /** Returns the coefficient of restitution. */
  public float getRestitution() {
    return restitution;
  }

  /** Sets the coefficient of restitution. */
  public void setRestitution(float restitution) {
    this.restitution = restitution;
  }

  /** Returns the density, kg/m^2. */
  public float getDensity() {
    return density;
  }

  /** Sets the density, kg/m^2. */
  public void setDensity(float density) {
    this.density = density;
  }

  /** Returns the collision filter. */
  public Filter getFilter() {
    return filter;
  }

  /** Sets the collision filter. */
  public void setFilter(Filter filter) {
    this.filter = filter;
  }

  /** Returns the material, or {@code null}. */
  public FixtureMaterial getMaterial() {
    return material;
  }

  /** Sets the material, or {@code null}. */
  public void setMaterial(FixtureMaterial material) {
    this.material = material;
  }

  /** Returns whether the fixture only reports contacts. */
  public boolean isSensor() {
    return isSensor;
  }

  /** Sets whether the fixture only reports contacts. */
  public void setSensor(boolean isSensor) {
    this.isSensor = isSensor;
  }

  /**
   * Throws an IllegalArgumentException that names the first value a fixture can't be made from,
   * apart from the shape.
   */
  void check() {
    Checks.notNegative(friction, "FixtureDef.friction");
    Checks.notNegative(restitution, "FixtureDef.restitution");
    Checks.notNegative(density, "FixtureDef.density");
    Checks.notNull(filter, "FixtureDef.filter");
  }
}
