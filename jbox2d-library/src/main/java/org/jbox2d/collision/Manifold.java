package org.jbox2d.collision;

import org.jbox2d.common.Settings;
import org.jbox2d.common.Vec2;

/**
 * How two convex shapes touch, in their own coordinates so that it stays meaningful while they
 * move. {@link WorldManifold} gives it in world coordinates.
 */
public class Manifold {

  /** What {@link #localPoint}, {@link #localNormal} and the points refer to. */
  public enum ManifoldType {
    /**
     * {@link #localPoint} is the centre of A in A, the one point the centre of B in B; the normal
     * is not used.
     */
    CIRCLES,
    /**
     * {@link #localPoint} and {@link #localNormal} are the face of A in A; the points are clip
     * points of B in B.
     */
    FACE_A,
    /**
     * {@link #localPoint} and {@link #localNormal} are the face of B in B; the points are clip
     * points of A in A.
     */
    FACE_B
  }

  /** Of length {@link Settings#maxManifoldPoints}; the first {@link #pointCount} are in use. */
  public final ManifoldPoint[] points;

  public final Vec2 localNormal = new Vec2();
  public final Vec2 localPoint = new Vec2();
  public ManifoldType type;
  public int pointCount;

  /**
   * Engine-internal: whether the one point is at a vertex: that of a polygon or edge which a circle
   * touches, or two that lie opposite each other beyond the ends of their faces.
   */
  public boolean corner;

  public Manifold() {
    points = new ManifoldPoint[Settings.maxManifoldPoints];
    for (int i = 0; i < points.length; i++) {
      points[i] = new ManifoldPoint();
    }
  }

  /** Copies {@code other}. */
  public Manifold(Manifold other) {
    this();
    set(other);
  }

  public void set(Manifold cp) {
    for (int i = 0; i < cp.pointCount; i++) {
      points[i].set(cp.points[i]);
    }
    type = cp.type;
    localNormal.set(cp.localNormal);
    localPoint.set(cp.localPoint);
    pointCount = cp.pointCount;
    corner = cp.corner;
  }
}
