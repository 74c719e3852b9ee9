package org.jbox2d.collision.narrowphase;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.common.MathUtils;
import org.jbox2d.common.Sweep;
import org.jbox2d.common.Vec2;

/**
 * The corners of a proxy that moves along a sweep, and their projections on an axis.
 *
 * <p>At the fraction t of the sweep the centre of mass is c(t) = c0 + t (c1 - c0) and the angle
 * a(t) = a0 + t w with w = a1 - a0. A corner at r from the centre then has, along a unit axis n
 * that turns by v over the sweep, the coordinate n . c(t) + f(t) with f(t) = |r| cos(phi + t (w -
 * v)). So f' is (w - v) (R r)^perp . n, and |f''| is at most (w - v)^2 |r|.
 */
public final class SweptProxy {

  private double[] rx = new double[8];
  private double[] ry = new double[8];
  private double[] value = new double[8];
  private double[] slope = new double[8];
  private int count;
  private double c0x;
  private double c0y;
  private double a0;
  private double localX;
  private double localY;

  /** Displacement of the centre over the whole sweep, in metres. */
  double shiftX;

  double shiftY;

  /** Rotation over the whole sweep, in radians. */
  double turn;

  /** Distance of the furthest corner from the centre of mass. */
  private double reach;

  /** Centre of mass in the current pose. */
  double x;

  double y;

  private double cos;
  private double sin;

  /** Takes over corners and motion; the sweep itself stays as it is. */
  public void set(DistanceProxy proxy, Sweep sweep) {
    count = proxy.m_count;
    if (rx.length < count) {
      rx = new double[count];
      ry = new double[count];
      value = new double[count];
      slope = new double[count];
    }
    localX = sweep.localCenter.x;
    localY = sweep.localCenter.y;
    double furthest = 0.0;
    for (int i = 0; i < count; i++) {
      Vec2 v = proxy.m_vertices[i];
      rx[i] = v.x - localX;
      ry[i] = v.y - localY;
      furthest = Math.max(furthest, rx[i] * rx[i] + ry[i] * ry[i]);
    }
    c0x = sweep.c0.x;
    c0y = sweep.c0.y;
    shiftX = sweep.c.x - c0x;
    shiftY = sweep.c.y - c0y;
    // Whole turns are taken off so that the angle keeps its digits as a float.
    a0 = sweep.a0 - 2.0 * Math.PI * Math.floor(sweep.a0 / (2.0 * Math.PI));
    turn = (double) sweep.a - sweep.a0;
    reach = Math.sqrt(furthest);
  }

  /** Sets the pose at the fraction t, with the sine and cosine that bodies use. */
  public void moveTo(double t) {
    float angle = (float) (a0 + t * turn);
    cos = MathUtils.cos(angle);
    sin = MathUtils.sin(angle);
    x = c0x + t * shiftX;
    y = c0y + t * shiftY;
  }

  /** Cosine of the angle in the current pose. */
  public double cos() {
    return cos;
  }

  /** Sine of the angle in the current pose. */
  public double sin() {
    return sin;
  }

  /** Position of the body's origin in the current pose. */
  public double originX() {
    return x - (cos * localX - sin * localY);
  }

  public double originY() {
    return y - (sin * localX + cos * localY);
  }

  /** Bound of |f''| for every corner, for an axis that turns by {@code axisTurn}. */
  double curvature(double axisTurn) {
    return (turn - axisTurn) * (turn - axisTurn) * reach;
  }

  /**
   * Projects all corners on an axis that turns by {@code axisTurn} over the sweep, relative to the
   * centre of mass, in the current pose.
   */
  void project(double nx, double ny, double axisTurn) {
    double relative = turn - axisTurn;
    double mx = cos * nx + sin * ny;
    double my = cos * ny - sin * nx;
    for (int i = 0; i < count; i++) {
      value[i] = mx * rx[i] + my * ry[i];
      slope[i] = relative * (my * rx[i] - mx * ry[i]);
    }
  }

  /** Least coordinate of the corners after a further dt, without curvature. */
  double least(double dt) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      least = Math.min(least, value[i] + dt * slope[i]);
    }
    return least;
  }

  /** Greatest coordinate of the corners after a further dt, without curvature. */
  double greatest(double dt) {
    double greatest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      greatest = Math.max(greatest, value[i] + dt * slope[i]);
    }
    return greatest;
  }
}
