package org.jbox2d.fracture.impact;

import org.jbox2d.common.Rot;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.Fixture;
import org.jbox2d.dynamics.SolvedContact;

/**
 * A contact that broke something, copied while the world was locked. One blow may break both of its
 * bodies.
 */
public final class Blow {
  public final Body bodyA;
  public final Body bodyB;
  private final Fixture fixtureA;
  private final Fixture fixtureB;
  private final int childA;
  private final int childB;
  final int pointCount;
  final float[] normalImpulses = new float[2];
  final float[] tangentImpulses = new float[2];
  final Vec2 normal = new Vec2();
  final Vec2[] points = {new Vec2(), new Vec2()};
  final Motion beforeA = new Motion();
  final Motion beforeB = new Motion();
  final Motion afterA = new Motion();
  final Motion afterB = new Motion();
  final Vec2 centerA;
  final Vec2 centerB;
  private final Rot rotationA = new Rot();
  private final Rot rotationB = new Rot();

  /**
   * Contacts with the same number were solved together; solving took this much kinetic energy, J.
   */
  final long solve;

  final double energyTaken;

  /** When in the step, as a fraction of it. */
  public final float alpha;

  /** Impulse of the blow without the share of a resting load, N s. */
  public final float intensity;

  public Blow(SolvedContact solved) {
    fixtureA = solved.contact.getFixtureA();
    fixtureB = solved.contact.getFixtureB();
    childA = solved.contact.getChildIndexA();
    childB = solved.contact.getChildIndexB();
    bodyA = fixtureA.getBody();
    bodyB = fixtureB.getBody();
    pointCount = solved.pointCount;
    normal.set(solved.normal);
    for (int i = 0; i < pointCount; i++) {
      normalImpulses[i] = solved.normalImpulses[i];
      tangentImpulses[i] = solved.tangentImpulses[i];
      points[i].set(solved.points[i]);
    }
    beforeA.set(solved.velocityA, solved.angularVelocityA);
    beforeB.set(solved.velocityB, solved.angularVelocityB);
    afterA.set(bodyA.getLinearVelocity(), bodyA.getAngularVelocity());
    afterB.set(bodyB.getLinearVelocity(), bodyB.getAngularVelocity());
    centerA = solved.centerA.clone();
    centerB = solved.centerB.clone();
    rotationA.set(solved.rotationA);
    rotationB.set(solved.rotationB);
    alpha = solved.alpha;
    solve = solved.solve;
    energyTaken = solved.energyTaken;
    intensity = Intensity.of(solved);
  }

  /**
   * Writes the mean of the contact points, weighted by their normal impulses, to {@code out}: where
   * the blow struck.
   */
  public void strikingPoint(Vec2 out) {
    float sum = 0f;
    float x = 0f;
    float y = 0f;
    for (int i = 0; i < pointCount; i++) {
      sum += normalImpulses[i];
      x += normalImpulses[i] * points[i].x;
      y += normalImpulses[i] * points[i].y;
    }
    if (sum > 0f) {
      out.set(x / sum, y / sum);
    } else {
      out.set(points[0]);
    }
  }

  /**
   * Writes the velocity of the other body relative to {@code struck} at a world point, before the
   * blow, to {@code out}.
   */
  public void impactVelocity(Body struck, Vec2 point, Vec2 out) {
    float ax = beforeA.x - beforeA.w * (point.y - centerA.y);
    float ay = beforeA.y + beforeA.w * (point.x - centerA.x);
    float bx = beforeB.x - beforeB.w * (point.y - centerB.y);
    float by = beforeB.y + beforeB.w * (point.x - centerB.x);
    if (struck == bodyA) {
      out.set(bx - ax, by - ay);
    } else {
      out.set(ax - bx, ay - by);
    }
  }

  /**
   * Turns and moves a world point to the frame in which {@code struck} was when the contact was
   * solved.
   */
  void toFrameOf(Body struck, Vec2 world, Vec2 out) {
    Rot q = struck == bodyA ? rotationA : rotationB;
    Vec2 center = struck == bodyA ? centerA : centerB;
    Rot.mulTrans(q, world.sub(center), out);
    out.addLocal(struck.getLocalCenter());
  }

  /** Turns a world vector to the frame in which {@code struck} was when the contact was solved. */
  void turnToFrameOf(Body struck, Vec2 world, Vec2 out) {
    Rot.mulTrans(struck == bodyA ? rotationA : rotationB, world.clone(), out);
  }

  /**
   * Whether this is the other body's record of the same blow: a contact is solved once a step, at
   * the same points.
   */
  public boolean isSameAs(Blow other) {
    return this == other
        || (fixtureA == other.fixtureA
            && fixtureB == other.fixtureB
            && childA == other.childA
            && childB == other.childB
            && points[0].x == other.points[0].x
            && points[0].y == other.points[0].y);
  }

  /** Velocity of a centre of mass and angular velocity. */
  static final class Motion {
    float x;
    float y;
    float w;

    void set(Vec2 v, float w) {
      x = v.x;
      y = v.y;
      this.w = w;
    }
  }
}
