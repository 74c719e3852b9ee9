package org.jbox2d.collision.narrowphase;

/**
 * How far two moving proxies are sure to stay apart along an axis.
 *
 * <p>For a unit axis n the gap g(t) = min_j n . b_j(t) - max_i n . a_i(t) never exceeds the
 * distance, so there is no contact before g reaches the target. The axis may turn with one of the
 * bodies: the normal of a face stays its normal, and the ends of the face do not swing across it.
 * With d = cB - cA, s its change over the sweep and v the turn of the axis, from the poses at time
 * t ({@link SweptProxy})
 *
 * <pre>
 *   g(t + dt) >= G(dt) = n . d + dt (n . s + v n^perp . d)
 *                        + min_j (f_j + dt f_j') - max_i (f_i + dt f_i') - K dt^2 / 2
 *   K = KA + KB + v^2 max |d| + 2 |v| |s|
 * </pre>
 *
 * <p>where K bounds the second derivatives of all terms. G is a minimum of straight lines less a
 * parabola, hence concave. This gives, without any step size to choose:
 *
 * <ul>
 *   <li>if G is above the target at both ends of an interval, it is above it throughout;
 *   <li>otherwise it falls through the target once, and between a point above and a point below it
 *       the chord lies under G: where the chord meets the target, G is still above.
 * </ul>
 *
 * <p>Without rotation G is exact, and one search finds the very time. With rotation the search is
 * repeated from the time found; its progress is then of second order in the gap, where a bound of
 * the speed alone (Mirtich, "Impulse-based dynamic simulation of rigid body systems", PhD thesis,
 * Berkeley 1996, section 2.3) would only make progress of first order.
 */
public final class SeparationBound {

  /** The body with which an axis turns. */
  public enum Frame {
    A,
    B,
    WORLD
  }

  private final SweptProxy a;
  private final SweptProxy b;
  private Frame frame;
  private double localX;
  private double localY;
  private double start;
  private double speed;
  private double halfCurvature;

  public SeparationBound(SweptProxy a, SweptProxy b) {
    this.a = a;
    this.b = b;
  }

  /** Chooses the axis (nx, ny), a unit vector from A to B in the world at the current poses. */
  public void setAxis(Frame frame, double nx, double ny) {
    this.frame = frame;
    if (frame == Frame.WORLD) {
      localX = nx;
      localY = ny;
      return;
    }
    SweptProxy owner = frame == Frame.A ? a : b;
    localX = owner.cos() * nx + owner.sin() * ny;
    localY = owner.cos() * ny - owner.sin() * nx;
  }

  /**
   * Expands the gap at the current poses.
   *
   * @param end the longest dt that will be asked for
   */
  public void expand(double end) {
    double nx = localX;
    double ny = localY;
    double axisTurn = 0.0;
    if (frame != Frame.WORLD) {
      SweptProxy owner = frame == Frame.A ? a : b;
      nx = owner.cos() * localX - owner.sin() * localY;
      ny = owner.sin() * localX + owner.cos() * localY;
      axisTurn = owner.turn;
    }
    a.project(nx, ny, axisTurn);
    b.project(nx, ny, axisTurn);
    double dx = b.x - a.x;
    double dy = b.y - a.y;
    double sx = b.shiftX - a.shiftX;
    double sy = b.shiftY - a.shiftY;
    start = nx * dx + ny * dy;
    speed = nx * sx + ny * sy + axisTurn * (nx * dy - ny * dx);
    double curvature = a.curvature(axisTurn) + b.curvature(axisTurn);
    if (axisTurn != 0.0) {
      double furthest = Math.max(length(dx, dy), length(dx + end * sx, dy + end * sy));
      curvature += axisTurn * axisTurn * furthest + 2.0 * Math.abs(axisTurn) * length(sx, sy);
    }
    halfCurvature = 0.5 * curvature;
  }

  private static double length(double x, double y) {
    return Math.sqrt(x * x + y * y);
  }

  /** G(dt) in metres; G(0) is the gap itself. */
  public double at(double dt) {
    return start + dt * speed + b.least(dt) - a.greatest(dt) - halfCurvature * dt * dt;
  }

  /**
   * The longest dt that is known to be safe: G is at least {@code target} on all of [0, dt].
   *
   * @param end the longest dt asked for
   * @param target must be less than {@code at(0)}
   * @param tolerance how far above the target the search may stop, in metres
   * @param maxIterations bound of the evaluations of G; the result is safe however small
   * @return {@code end} if all of it is safe
   */
  public double safeInterval(double end, double target, double tolerance, int maxIterations) {
    double above = at(end) - target;
    if (above >= 0.0) {
      return end;
    }
    double low = 0.0;
    double lowExcess = at(0.0) - target;
    double high = end;
    double highExcess = above;
    boolean chord = true;
    for (int i = 0; i < maxIterations && lowExcess > tolerance; i++) {
      // Chords move the safe end; halving keeps the other end from staying where it is.
      double middle =
          chord ? low + (high - low) * (lowExcess / (lowExcess - highExcess)) : 0.5 * (low + high);
      chord = !chord;
      double excess = at(middle) - target;
      if (excess >= 0.0) {
        low = middle;
        lowExcess = excess;
      } else {
        high = middle;
        highExcess = excess;
      }
    }
    return low;
  }
}
