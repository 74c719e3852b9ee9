package org.jbox2d.callbacks;

import org.jbox2d.common.Color3f;
import org.jbox2d.common.IViewportTransform;
import org.jbox2d.common.Transform;
import org.jbox2d.common.Vec2;

/**
 * Draws what a world shows for debugging. All positions and lengths are in world coordinates,
 * unless a method says otherwise; {@link #viewportTransform} leads to those of the view.
 */
public abstract class DebugDraw {

  /** Draw shapes. */
  public static final int e_shapeBit = 1 << 1;

  /** Draw joints. */
  public static final int e_jointBit = 1 << 2;

  /** Draw the boxes of the broad phase. */
  public static final int e_aabbBit = 1 << 3;

  /** Draw pairs of fixtures in contact. */
  public static final int e_pairBit = 1 << 4;

  /** Draw centres of mass. */
  public static final int e_centerOfMassBit = 1 << 5;

  /** Draw the dynamic tree. */
  public static final int e_dynamicTreeBit = 1 << 6;

  /** Draw outlines alone. */
  public static final int e_wireframeDrawingBit = 1 << 7;

  /** The bits that are set. */
  protected int m_drawFlags;

  /** From the world to the view; null until it is set. */
  protected IViewportTransform viewportTransform;

  /** Without a transform; set one before anything is drawn. */
  public DebugDraw() {
    this(null);
  }

  public DebugDraw(IViewportTransform viewport) {
    viewportTransform = viewport;
  }

  public void setViewportTransform(IViewportTransform viewportTransform) {
    this.viewportTransform = viewportTransform;
  }

  /** The transform itself (the spelling is JBox2D's). */
  public IViewportTransform getViewportTranform() {
    return viewportTransform;
  }

  public void setFlags(int flags) {
    m_drawFlags = flags;
  }

  public int getFlags() {
    return m_drawFlags;
  }

  public void appendFlags(int flags) {
    m_drawFlags |= flags;
  }

  public void clearFlags(int flags) {
    m_drawFlags &= ~flags;
  }

  /** Draws the outline of a polygon of {@code vertexCount} vertices, by its segments. */
  public void drawPolygon(Vec2[] vertices, int vertexCount, Color3f color) {
    if (vertexCount == 1) {
      drawSegment(vertices[0], vertices[0], color);
      return;
    }
    for (int i = 0; i + 1 < vertexCount; i++) {
      drawSegment(vertices[i], vertices[i + 1], color);
    }
    if (vertexCount > 2) {
      drawSegment(vertices[vertexCount - 1], vertices[0], color);
    }
  }

  /** Draws a point; its radius is in view units. */
  public abstract void drawPoint(Vec2 argPoint, float argRadiusOnScreen, Color3f argColor);

  public abstract void drawSolidPolygon(Vec2[] vertices, int vertexCount, Color3f color);

  public abstract void drawCircle(Vec2 center, float radius, Color3f color);

  /**
   * Draws a circle with a radius along the unit vector {@code axis}, which shows how it is turned.
   */
  public void drawCircle(Vec2 center, float radius, Vec2 axis, Color3f color) {
    drawCircle(center, radius, color);
    drawSegment(center, axis.mul(radius).addLocal(center), color);
  }

  /**
   * Draws a disc with a radius along the unit vector {@code axis}, which shows how it is turned.
   */
  public abstract void drawSolidCircle(Vec2 center, float radius, Vec2 axis, Color3f color);

  public abstract void drawSegment(Vec2 p1, Vec2 p2, Color3f color);

  /** Draws the axes of a transform. */
  public abstract void drawTransform(Transform xf);

  /** Writes {@code s} at a point of the view. */
  public abstract void drawString(float x, float y, String s, Color3f color);

  /** Writes {@code s} at a point of the view. */
  public void drawString(Vec2 pos, String s, Color3f color) {
    drawString(pos.x, pos.y, s, color);
  }

  /** A frame is complete. Does nothing unless overridden. */
  public void flush() {}

  /** Looks at the world point (x, y) with {@code scale} view units a metre. */
  public void setCamera(float x, float y, float scale) {
    viewportTransform.setCamera(x, y, scale);
  }

  public void getScreenToWorldToOut(Vec2 argScreen, Vec2 argWorld) {
    viewportTransform.getScreenToWorld(argScreen, argWorld);
  }

  public void getWorldToScreenToOut(Vec2 argWorld, Vec2 argScreen) {
    viewportTransform.getWorldToScreen(argWorld, argScreen);
  }

  public void getWorldToScreenToOut(float worldX, float worldY, Vec2 argScreen) {
    argScreen.set(worldX, worldY);
    viewportTransform.getWorldToScreen(argScreen, argScreen);
  }

  public Vec2 getWorldToScreen(Vec2 argWorld) {
    return getWorldToScreen(argWorld.x, argWorld.y);
  }

  public Vec2 getWorldToScreen(float worldX, float worldY) {
    Vec2 screen = new Vec2();
    getWorldToScreenToOut(worldX, worldY, screen);
    return screen;
  }

  public void getScreenToWorldToOut(float screenX, float screenY, Vec2 argWorld) {
    argWorld.set(screenX, screenY);
    viewportTransform.getScreenToWorld(argWorld, argWorld);
  }

  public Vec2 getScreenToWorld(Vec2 argScreen) {
    return getScreenToWorld(argScreen.x, argScreen.y);
  }

  public Vec2 getScreenToWorld(float screenX, float screenY) {
    Vec2 world = new Vec2();
    getScreenToWorldToOut(screenX, screenY, world);
    return world;
  }
}
