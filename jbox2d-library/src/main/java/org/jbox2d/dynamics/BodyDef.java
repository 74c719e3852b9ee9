package org.jbox2d.dynamics;

import org.jbox2d.common.Vec2;

/** What a body is made from. May be used again for further bodies: everything is copied. */
public class BodyDef {
  /** Static, kinematic or dynamic. */
  public BodyType type;

  /** Handed back by {@link Body#getUserData()}. */
  public Object userData;

  /** World position of the body's origin, m. */
  public Vec2 position;

  /** World angle, rad. */
  public float angle;

  /** Velocity of the body's origin, m/s. */
  public Vec2 linearVelocity;

  /** Angular velocity, rad/s. */
  public float angularVelocity;

  /** Rate at which the linear velocity decays, 1/s; not negative. */
  public float linearDamping;

  /** Rate at which the angular velocity decays, 1/s; not negative. */
  public float angularDamping;

  /** Whether the body may fall asleep. */
  public boolean allowSleep;

  /** Whether the body starts awake. */
  public boolean awake;

  /** Whether the body never turns. */
  public boolean fixedRotation;

  /** Whether continuous collision also guards this body against other moving bodies. */
  public boolean bullet;

  /** Whether the body takes part in the simulation at all. */
  public boolean active;

  /** Factor on the world's gravity for this body. */
  public float gravityScale;

  /** A static, awake, active body at the origin. */
  public BodyDef() {
    type = BodyType.STATIC;
    position = new Vec2();
    linearVelocity = new Vec2();
    allowSleep = true;
    awake = true;
    active = true;
    gravityScale = 1f;
  }

  /** Returns the kind of body. */
  public BodyType getType() {
    return type;
  }

  /** Sets the kind of body. */
  public void setType(BodyType type) {
    this.type = type;
  }

  /** Returns the user data. */
  public Object getUserData() {
    return userData;
  }

  /** Sets the user data. */
  public void setUserData(Object userData) {
    this.userData = userData;
  }

  /** Returns the position of the origin, m. */
  public Vec2 getPosition() {
    return position;
  }

  /** Sets the position of the origin, m. */
  public void setPosition(Vec2 position) {
    this.position = position;
  }

  /** Returns the angle, rad. */
  public float getAngle() {
    return angle;
  }

  /** Sets the angle, rad. */
  public void setAngle(float angle) {
    this.angle = angle;
  }

  /** Returns the velocity of the origin, m/s. */
  public Vec2 getLinearVelocity() {
    return linearVelocity;
  }

  /** Sets the velocity of the origin, m/s. */
  public void setLinearVelocity(Vec2 linearVelocity) {
    this.linearVelocity = linearVelocity;
  }

  /** Returns the angular velocity, rad/s. */
  public float getAngularVelocity() {
    return angularVelocity;
  }

  /** Sets the angular velocity, rad/s. */
  public void setAngularVelocity(float angularVelocity) {
    this.angularVelocity = angularVelocity;
  }

  /** Returns the linear damping, 1/s. */
  public float getLinearDamping() {
    return linearDamping;
  }

  /** Sets the linear damping, 1/s. */
  public void setLinearDamping(float linearDamping) {
    this.linearDamping = linearDamping;
  }

  /** Returns the angular damping, 1/s. */
  public float getAngularDamping() {
    return angularDamping;
  }

  /** Sets the angular damping, 1/s. */
  public void setAngularDamping(float angularDamping) {
    this.angularDamping = angularDamping;
  }

  /** Returns whether the body may fall asleep. */
  public boolean isAllowSleep() {
    return allowSleep;
  }

  /** Sets whether the body may fall asleep. */
  public void setAllowSleep(boolean allowSleep) {
    this.allowSleep = allowSleep;
  }

  /** Returns whether the body starts awake. */
  public boolean isAwake() {
    return awake;
  }

  /** Sets whether the body starts awake. */
  public void setAwake(boolean awake) {
    this.awake = awake;
  }

  /** Returns whether the body never turns. */
  public boolean isFixedRotation() {
    return fixedRotation;
  }

  /** Sets whether the body never turns. */
  public void setFixedRotation(boolean fixedRotation) {
    this.fixedRotation = fixedRotation;
  }

  /** Returns whether the body is a bullet. */
  public boolean isBullet() {
    return bullet;
  }

  /** Sets whether the body is a bullet. */
  public void setBullet(boolean bullet) {
    this.bullet = bullet;
  }

  /** Returns whether the body is active. */
  public boolean isActive() {
    return active;
  }

  /** Sets whether the body is active. */
  public void setActive(boolean active) {
    this.active = active;
  }

  /** Returns the factor on gravity. */
  public float getGravityScale() {
    return gravityScale;
  }

  /** Sets the factor on gravity. */
  public void setGravityScale(float gravityScale) {
    this.gravityScale = gravityScale;
  }

  /** Throws an IllegalArgumentException that names the first value a body can't be made from. */
  void check() {
    Checks.notNull(type, "BodyDef.type");
    Checks.finite(position, "BodyDef.position");
    Checks.finite(angle, "BodyDef.angle");
    Checks.finite(linearVelocity, "BodyDef.linearVelocity");
    Checks.finite(angularVelocity, "BodyDef.angularVelocity");
    Checks.notNegative(linearDamping, "BodyDef.linearDamping");
    Checks.notNegative(angularDamping, "BodyDef.angularDamping");
    Checks.finite(gravityScale, "BodyDef.gravityScale");
  }
}
