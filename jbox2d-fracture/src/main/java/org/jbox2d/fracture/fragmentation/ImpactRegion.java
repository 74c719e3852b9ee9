package org.jbox2d.fracture.fragmentation;

import org.jbox2d.fracture.geometry.Angles;

/**
 * The thesis' region of effect (section 5.2.2). In the frame with its origin at the contact point
 * and +y along the impact vector: a half disc of radius r behind, {@code x^2 + y^2 < r^2, y < 0},
 * and a half ellipse ahead, {@code x^2 / r^2 + y^2 / d^2 < 1, y >= 0}. A zero impact vector gives
 * the disc of radius r.
 *
 * <p>The overlap with a triangle at the contact point: the edge opposite to it is cut at y = 0, the
 * upper part scaled by r/d in y, and what is left is the overlap of a disc and a triangle at its
 * centre, made of triangles inside and sectors outside the disc. No clipping, exact but for
 * rounding.
 */
public final class ImpactRegion implements RegionOfEffect {
  /** Tangents at 45 degrees to a unit circle: x + y = this; rounded up. */
  private static final double DIAGONAL = 1.4142135623730952;

  private final double contactX;
  private final double contactY;
  private final double directionX;
  private final double directionY;
  private final double radius;
  private final double depth;

  /** Depth in units of the radius. */
  private final double stretch;

  /** Unit vectors across and along the impact, over the radius. */
  private final double acrossX;

  private final double acrossY;
  private final double alongX;
  private final double alongY;
  private final double minX;
  private final double maxX;
  private final double minY;
  private final double maxY;

  /**
   * Creates a region.
   *
   * @param impactX x of the impact vector, of any length; zero in both for a disc
   * @param radius r, positive
   * @param depth d, positive; no matter for a zero vector
   * @throws IllegalArgumentException if an argument is not finite, or radius or depth is not
   *     positive
   */
  public ImpactRegion(
      double contactX,
      double contactY,
      double impactX,
      double impactY,
      double radius,
      double depth) {
    if ((contactX + contactY) * 0 != 0) {
      throw new IllegalArgumentException("contact point: (" + contactX + ", " + contactY + ")");
    }
    if (impactX * 0 + impactY * 0 != 0) {
      throw new IllegalArgumentException("impact vector: (" + impactX + ", " + impactY + ")");
    }
    if (!(radius > 0 && radius * 0 == 0)) {
      throw new IllegalArgumentException("radius: " + radius);
    }
    if (!(depth > 0 && depth * 0 == 0)) {
      throw new IllegalArgumentException("depth: " + depth);
    }
    this.contactX = contactX;
    this.contactY = contactY;
    this.radius = radius;
    double largest = Math.max(Math.abs(impactX), Math.abs(impactY));
    if (largest > 0) {
      double ux = impactX / largest;
      double uy = impactY / largest;
      double length = Math.sqrt(ux * ux + uy * uy);
      directionX = ux / length;
      directionY = uy / length;
      this.depth = depth;
    } else {
      directionX = 0;
      directionY = 1;
      this.depth = radius;
    }
    stretch = this.depth / radius;
    acrossX = directionY / radius;
    acrossY = -directionX / radius;
    alongX = directionX / radius;
    alongY = directionY / radius;
    minX = contactX - reach(-directionX, directionY);
    maxX = contactX + reach(directionX, directionY);
    minY = contactY - reach(-directionY, directionX);
    maxY = contactY + reach(directionY, directionX);
  }

  @Override
  public double contactX() {
    return contactX;
  }

  @Override
  public double contactY() {
    return contactY;
  }

  @Override
  public double minX() {
    return minX;
  }

  @Override
  public double maxX() {
    return maxX;
  }

  @Override
  public double minY() {
    return minY;
  }

  @Override
  public double maxY() {
    return maxY;
  }

  /**
   * Support of the region in a direction that has the given components along and across the impact.
   */
  private double reach(double along, double across) {
    double a = along * (along > 0 ? depth : radius);
    double b = across * radius;
    return Math.sqrt(a * a + b * b);
  }

  /** Points on the curve, interleaved, counter-clockwise; equally spaced where it is a circle. */
  public double[] boundary(int points) {
    double[] xy = new double[2 * points];
    for (int i = 0; i < points; i++) {
      double angle = 2 * Math.PI * i / points;
      double across = radius * StrictMath.cos(angle);
      double sine = StrictMath.sin(angle);
      double along = sine * (sine > 0 ? depth : radius);
      xy[2 * i] = contactX + along * directionX + across * directionY;
      xy[2 * i + 1] = contactY + along * directionY - across * directionX;
    }
    return xy;
  }

  /**
   * The octagon whose sides touch the region: behind, where it is a half disc, half of a regular
   * one, ahead half of one that is stretched like the ellipse.
   */
  @Override
  public int sidesBeyond(double x, double y) {
    double dx = x - contactX;
    double dy = y - contactY;
    double across = dx * acrossX + dy * acrossY;
    double back = -(dx * alongX + dy * alongY);
    double ahead = -back / stretch;
    return signBit(1 - across)
        | signBit(1 + across) << 1
        | signBit(1 - ahead) << 2
        | signBit(1 - back) << 3
        | signBit(DIAGONAL - across - ahead) << 4
        | signBit(DIAGONAL + across - ahead) << 5
        | signBit(DIAGONAL - across - back) << 6
        | signBit(DIAGONAL + across - back) << 7;
  }

  /** 1 for a negative number, else 0. */
  private static int signBit(double value) {
    return (int) (Double.doubleToRawLongBits(value) >>> 63);
  }

  @Override
  public double overlap(double ax, double ay, double bx, double by) {
    double px = ax - contactX;
    double py = ay - contactY;
    double qx = bx - contactX;
    double qy = by - contactY;
    return radius
        * radius
        * edgeOverlap(
            px * acrossX + py * acrossY,
            px * alongX + py * alongY,
            qx * acrossX + qy * acrossY,
            qx * alongX + qy * alongY);
  }

  /** The same for the half disc and ellipse of radius 1 ahead along +y. */
  private double edgeOverlap(double ax, double ay, double bx, double by) {
    if ((ay >= 0) == (by >= 0)) {
      return halfOverlap(ax, ay, bx, by, ay >= 0);
    }
    double t = ay / (ay - by);
    double cx = ax + t * (bx - ax);
    return halfOverlap(ax, ay, cx, 0, ay >= 0) + halfOverlap(cx, 0, bx, by, by >= 0);
  }

  private double halfOverlap(double ax, double ay, double bx, double by, boolean ahead) {
    if (!ahead) {
      return discOverlap(ax, ay, bx, by);
    }
    return stretch * discOverlap(ax, ay / stretch, bx, by / stretch);
  }

  /**
   * Signed overlap of the unit disc and the triangle (centre, a, b). The edge is a + t (b - a); it
   * is inside the disc for t between the roots of |a + t (b - a)|^2 = 1.
   */
  private static double discOverlap(double ax, double ay, double bx, double by) {
    double ux = bx - ax;
    double uy = by - ay;
    double uu = ux * ux + uy * uy;
    double au = ax * ux + ay * uy;
    double beyond = ax * ax + ay * ay - 1;
    if (beyond <= 0 && bx * bx + by * by <= 1) {
      return 0.5 * (ax * by - ay * bx);
    }
    double discriminant = au * au - uu * beyond;
    if (discriminant <= 0 || uu == 0) {
      return sector(ax, ay, bx, by);
    }
    double root = Math.sqrt(discriminant);
    double enter = Math.max(0, (-au - root) / uu);
    double leave = Math.min(1, (-au + root) / uu);
    if (enter >= leave) {
      return sector(ax, ay, bx, by);
    }
    double ex = ax + enter * ux;
    double ey = ay + enter * uy;
    double lx = ax + leave * ux;
    double ly = ay + leave * uy;
    double area = 0.5 * (ex * ly - ey * lx);
    if (enter > 0) {
      area += sector(ax, ay, ex, ey);
    }
    if (leave < 1) {
      area += sector(lx, ly, bx, by);
    }
    return area;
  }

  private static double sector(double ax, double ay, double bx, double by) {
    return 0.5 * Angles.atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
}
