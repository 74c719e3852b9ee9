package org.jbox2d.common;

/**
 * The way between world coordinates and those of a view (pixels, say). Output arguments may be the
 * inputs.
 */
public interface IViewportTransform {

  /** Whether the view's y axis points down. */
  boolean isYFlip();

  /** Sets whether the view's y axis points down. */
  void setYFlip(boolean yFlip);

  /** Half of the view's size, in view units. */
  Vec2 getExtents();

  /** Sets half of the view's size, in view units. */
  void setExtents(Vec2 extents);

  /** Sets half of the view's size, in view units. */
  void setExtents(float halfWidth, float halfHeight);

  /** The world point in the middle of the view. */
  Vec2 getCenter();

  /** Sets the world point in the middle of the view. */
  void setCenter(Vec2 pos);

  /** Sets the world point in the middle of the view. */
  void setCenter(float x, float y);

  /** Looks at the world point (x, y) with {@code scale} view units a metre, without rotation. */
  void setCamera(float x, float y, float scale);

  /**
   * Transforms world vectors to view vectors, without flip.
   *
   * @throws UnsupportedOperationException if the transform was written for JBox2D 2.2, which had no
   *     such method
   */
  default Mat22 getMat22Representation() {
    throw new UnsupportedOperationException(getClass().getName() + ".getMat22Representation");
  }

  /**
   * Multiplies the matrix by {@code transform} from the right.
   *
   * @throws UnsupportedOperationException if the transform was written for JBox2D 2.2, which had no
   *     such method
   */
  default void mulByTransform(Mat22 transform) {
    throw new UnsupportedOperationException(getClass().getName() + ".mulByTransform");
  }

  /** A world vector (a direction, not a point) to the view. */
  void getWorldVectorToScreen(Vec2 world, Vec2 screen);

  /** A vector of the view to the world. */
  void getScreenVectorToWorld(Vec2 screen, Vec2 world);

  /** A world point to the view. */
  void getWorldToScreen(Vec2 world, Vec2 screen);

  /** A point of the view to the world. */
  void getScreenToWorld(Vec2 screen, Vec2 world);
}
