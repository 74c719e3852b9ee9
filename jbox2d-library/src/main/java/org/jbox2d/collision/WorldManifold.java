package org.jbox2d.collision;

import org.jbox2d.common.Rot;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/** A {@link Manifold} in world coordinates. */
public class WorldManifold {

  /** Squared distance of two centres, in square metres, below which they give no direction. */
  private static final float COINCIDENT_SQUARED = Settings.EPSILON * Settings.EPSILON;

  /** Unit vector from A to B. */
  public final Vec2 normal = new Vec2();

  /** Contact points: halfway between the two surfaces. */
  public final Vec2[] points;

  /**
   * Distance of the surfaces along the normal at each point, in metres; negative where they
   * overlap.
   */
  public final float[] separations;

  public WorldManifold() {
    points = new Vec2[Settings.maxManifoldPoints];
    separations = new float[points.length];
    for (int i = 0; i < points.length; i++) {
      points[i] = new Vec2();
    }
  }

  /**
   * Evaluates {@code manifold} at the given transforms; without points nothing changes. The
   * transforms may differ from those at which the manifold was made, by small motions. {@code
   * radiusA} and {@code radiusB} are the shapes' radii.
   */
  public final void initialize(
      Manifold manifold, Transform xfA, float radiusA, Transform xfB, float radiusB) {
    if (manifold.pointCount == 0) {
      return;
    }
    switch (manifold.type) {
      case CIRCLES:
        betweenCentres(manifold, xfA, radiusA, xfB, radiusB);
        break;
      case FACE_A:
        againstFace(manifold, xfA, radiusA, xfB, radiusB);
        break;
      case FACE_B:
        againstFace(manifold, xfB, radiusB, xfA, radiusA);
        normal.negateLocal();
        break;
    }
  }

  private void betweenCentres(
      Manifold manifold, Transform xfA, float radiusA, Transform xfB, float radiusB) {
    Vec2 localA = manifold.localPoint;
    Vec2 localB = manifold.points[0].localPoint;
    float ax = xfA.q.c * localA.x - xfA.q.s * localA.y + xfA.p.x;
    float ay = xfA.q.s * localA.x + xfA.q.c * localA.y + xfA.p.y;
    float bx = xfB.q.c * localB.x - xfB.q.s * localB.y + xfB.p.x;
    float by = xfB.q.s * localB.x + xfB.q.c * localB.y + xfB.p.y;
    float dx = bx - ax;
    float dy = by - ay;
    if (dx * dx + dy * dy > COINCIDENT_SQUARED) {
      normal.set(dx, dy);
      normal.normalize();
    } else {
      normal.set(1f, 0f);
    }
    float along = dx * normal.x + dy * normal.y;
    float middle = 0.5f * (radiusA - radiusB + along);
    points[0].set(ax + middle * normal.x, ay + middle * normal.y);
    separations[0] = along - radiusA - radiusB;
  }

  /**
   * A clip point at the height h above the face has the surfaces at radiusFace and h - radiusClip.
   */
  private void againstFace(
      Manifold manifold, Transform xfFace, float radiusFace, Transform xfClip, float radiusClip) {
    Rot.mulToOutUnsafe(xfFace.q, manifold.localNormal, normal);
    Vec2 onFace = manifold.localPoint;
    float fx = xfFace.q.c * onFace.x - xfFace.q.s * onFace.y + xfFace.p.x;
    float fy = xfFace.q.s * onFace.x + xfFace.q.c * onFace.y + xfFace.p.y;
    for (int i = 0; i < manifold.pointCount; i++) {
      Vec2 point = points[i];
      Transform.mulToOutUnsafe(xfClip, manifold.points[i].localPoint, point);
      float height = (point.x - fx) * normal.x + (point.y - fy) * normal.y;
      float toMiddle = 0.5f * (radiusFace - radiusClip - height);
      point.addLocal(toMiddle * normal.x, toMiddle * normal.y);
      separations[i] = height - radiusFace - radiusClip;
    }
  }
}
