package org.jbox2d.common;

/** A view transform by an oriented box: {@code screen = flip(R (world - center)) + extents}. */
public class OBBViewportTransform implements IViewportTransform {

  /** Centre (world), half size (view) and matrix (world to view) of a view. */
  public static class OBB {
    public final Mat22 R = new Mat22();
    public final Vec2 center = new Vec2();
    public final Vec2 extents = new Vec2();

    public OBB() {}
  }

  protected final OBB box = new OBB();
  private boolean yFlip;

  /** The identity, about a view of size 0. */
  public OBBViewportTransform() {
    box.R.setIdentity();
  }

  public void set(OBBViewportTransform vpt) {
    box.center.set(vpt.box.center);
    box.extents.set(vpt.box.extents);
    box.R.set(vpt.box.R);
    yFlip = vpt.yFlip;
  }

  @Override
  public void setCamera(float x, float y, float scale) {
    box.center.set(x, y);
    Mat22.createScaleTransform(scale, box.R);
  }

  /** The half size itself, not a copy. */
  @Override
  public Vec2 getExtents() {
    return box.extents;
  }

  @Override
  public void setExtents(Vec2 argExtents) {
    box.extents.set(argExtents);
  }

  @Override
  public void setExtents(float halfWidth, float halfHeight) {
    box.extents.set(halfWidth, halfHeight);
  }

  /** The centre itself, not a copy. */
  @Override
  public Vec2 getCenter() {
    return box.center;
  }

  @Override
  public void setCenter(Vec2 argPos) {
    box.center.set(argPos);
  }

  @Override
  public void setCenter(float x, float y) {
    box.center.set(x, y);
  }

  /** The matrix itself, not a copy. */
  public Mat22 getTransform() {
    return box.R;
  }

  /** The matrix itself, not a copy. */
  @Override
  public Mat22 getMat22Representation() {
    return box.R;
  }

  public void setTransform(Mat22 transform) {
    box.R.set(transform);
  }

  @Override
  public void mulByTransform(Mat22 transform) {
    box.R.mulLocal(transform);
  }

  @Override
  public boolean isYFlip() {
    return yFlip;
  }

  @Override
  public void setYFlip(boolean yFlip) {
    this.yFlip = yFlip;
  }

  @Override
  public void getWorldVectorToScreen(Vec2 world, Vec2 screen) {
    box.R.mulToOut(world, screen);
    flip(screen);
  }

  @Override
  public void getScreenVectorToWorld(Vec2 screen, Vec2 world) {
    world.set(screen);
    flip(world);
    box.R.solveToOut(world, world);
  }

  @Override
  public void getWorldToScreen(Vec2 world, Vec2 screen) {
    screen.set(world.x - box.center.x, world.y - box.center.y);
    getWorldVectorToScreen(screen, screen);
    screen.addLocal(box.extents);
  }

  @Override
  public void getScreenToWorld(Vec2 screen, Vec2 world) {
    world.set(screen.x - box.extents.x, screen.y - box.extents.y);
    getScreenVectorToWorld(world, world);
    world.addLocal(box.center);
  }

  private void flip(Vec2 v) {
    if (yFlip) {
      v.y = -v.y;
    }
  }
}
