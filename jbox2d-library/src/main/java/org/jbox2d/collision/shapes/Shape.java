package org.jbox2d.collision.shapes;

import org.jbox2d.collision.AABB;
import org.jbox2d.collision.RayCastInput;
import org.jbox2d.collision.RayCastOutput;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * A shape in the coordinates of its body. A fixture keeps a clone of the shape it is made from. A
 * chain has several children (its edges), every other shape one.
 */
public abstract class Shape {

  public final ShapeType m_type;

  /** Radius of a circle, or the skin of another shape, in metres. */
  public float m_radius;

  public Shape(ShapeType type) {
    m_type = type;
  }

  public ShapeType getType() {
    return m_type;
  }

  /** Radius of a circle, or the skin of another shape, in metres. */
  public float getRadius() {
    return m_radius;
  }

  /**
   * Sets the radius.
   *
   * @throws IllegalArgumentException if it is negative, infinite or NaN
   */
  public void setRadius(float radius) {
    if (!(radius >= 0 && radius <= Float.MAX_VALUE)) {
      throw new IllegalArgumentException("radius must be finite and not negative: " + radius);
    }
    m_radius = radius;
  }

  /** Number of children. */
  public abstract int getChildCount();

  /**
   * Whether the world point {@code p} is inside or on the border; false for shapes without an
   * inside.
   */
  public abstract boolean testPoint(Transform xf, Vec2 p);

  /**
   * Where a ray in world coordinates hits a child from outside.
   *
   * @param output where the hit goes; stays as it is if there is none
   * @return whether there is a hit
   */
  public abstract boolean raycast(
      RayCastOutput output, RayCastInput input, Transform transform, int childIndex);

  /** Writes a box in world coordinates that holds a child and its skin. */
  public abstract void computeAABB(AABB aabb, Transform xf, int childIndex);

  /**
   * Writes mass, centre and inertia.
   *
   * @param density in kg/m^2
   */
  public abstract void computeMass(MassData massData, float density);

  /**
   * Distance in metres from a child to the world point {@code p}, negative inside; the skin is not
   * counted.
   *
   * @param normalOut receives the unit vector, in world coordinates, along which the distance grows
   * @throws UnsupportedOperationException by shapes written for JBox2D 2.2, which had no such
   *     method
   */
  public float computeDistanceToOut(Transform xf, Vec2 p, int childIndex, Vec2 normalOut) {
    throw new UnsupportedOperationException(getClass().getName() + ".computeDistanceToOut");
  }

  /** A deep copy. */
  @Override
  public abstract Shape clone();
}
