package org.jbox2d.collision;

import org.jbox2d.collision.Distance.DistanceProxy;
import org.jbox2d.collision.Distance.SimplexCache;
import org.jbox2d.collision.narrowphase.Gjk;
import org.jbox2d.collision.narrowphase.SeparationBound;
import org.jbox2d.collision.narrowphase.SweptProxy;
import org.jbox2d.common.Settings;
import org.jbox2d.common.Sweep;
import org.jbox2d.pooling.IWorldPool;

/**
 * The time at which two moving convex shapes come into contact.
 *
 * <p>Conservative advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems",
 * PhD thesis, Berkeley 1996; van den Bergen, "Ray casting against general convex objects", 2004)
 * along separating axes with root finding (Catto, "Continuous collision", GDC 2013): the closest
 * points give an axis; time advances to where the gap along that axis falls to the target; there
 * the closest points are found anew. Each advance stays before the gap's first root ({@link
 * SeparationBound}), also under rotation, so the result is never later than the first contact.
 *
 * <p>Contact is a distance of the cores of {@code target = max(linearSlop, rA + rB - 3
 * linearSlop)}: the skins then overlap by three slops, enough for the manifold to exist, while the
 * cores are still apart. The reported distance is between the target and a quarter of the slop
 * above it.
 *
 * <p>An instance keeps scratch memory: use one for each thread.
 */
public class TimeOfImpact {

  /** Bound of the axes that one call tries. */
  public static final int MAX_ITERATIONS = 20;

  /** Bound of the advances along one axis, and of the evaluations of one root search. */
  public static final int MAX_ROOT_ITERATIONS = 50;

  /** Kept for source and binary compatibility; nothing is counted across worlds and threads. */
  public static int toiCalls;

  /** See {@link #toiCalls}. */
  public static int toiIters;

  /** See {@link #toiCalls}. */
  public static int toiMaxIters;

  /** See {@link #toiCalls}. */
  public static int toiRootIters;

  /** See {@link #toiCalls}. */
  public static int toiMaxRootIters;

  /** How deep the skins overlap at the reported time, in linear slops. */
  private static final float SKIN_OVERLAP = 3f;

  /** Width of the band above the target that counts as contact, in linear slops. */
  private static final float TOLERANCE = 0.25f;

  /**
   * Parts of the tolerance. A search stops within the first, an axis is given up within the second,
   * the distance counts as contact within the whole: each sees what the one before it reached,
   * though gap and distance differ by rounding.
   */
  private static final double ROOT_FOUND = 0.5;

  private static final double AXIS_DONE = 0.75;

  private final Gjk gjk = new Gjk();
  private final SimplexCache cache = new SimplexCache();
  private final SweptProxy movingA = new SweptProxy();
  private final SweptProxy movingB = new SweptProxy();
  private final SeparationBound bound = new SeparationBound(movingA, movingB);

  public TimeOfImpact() {}

  /** As {@link #TimeOfImpact()}; the pool is not used, and is taken for compatibility. */
  public TimeOfImpact(IWorldPool argPool) {}

  /**
   * Computes how far both sweeps can be followed before the shapes touch.
   *
   * <p>The times are fractions of the way from {@code c0, a0} to {@code c, a} of the sweeps, whose
   * {@code alpha0} must be equal and is otherwise ignored. States:
   *
   * <ul>
   *   <li>SEPARATED: no contact before tMax; t is tMax.
   *   <li>TOUCHING: contact at t, which is never later than the first one; 0 if they touch at the
   *       start.
   *   <li>OVERLAPPED: the cores overlap at the start; t is 0.
   *   <li>FAILED: the iterations were used up, or a coordinate is not a number. There is no contact
   *       before t.
   * </ul>
   *
   * @param output receives state and time
   * @param input is not changed
   */
  public final void timeOfImpact(TOIOutput output, TOIInput input) {
    double radius = (double) input.proxyA.m_radius + input.proxyB.m_radius;
    double slop = Settings.linearSlop;
    double target = Math.max(slop, radius - SKIN_OVERLAP * slop);
    double tolerance = TOLERANCE * slop;

    movingA.set(input.proxyA, input.sweepA);
    movingB.set(input.proxyB, input.sweepB);
    cache.count = 0;
    double end = input.tMax;
    double t = 0.0;
    for (int i = 0; i < MAX_ITERATIONS; i++) {
      movingA.moveTo(t);
      movingB.moveTo(t);
      double distance = measure(input);
      if (distance <= target + tolerance) {
        boolean overlapped = i == 0 && distance <= 0.0;
        finish(output, overlapped ? TOIOutputState.OVERLAPPED : TOIOutputState.TOUCHING, t);
        return;
      }
      if (!(distance > 0.0) || Double.isNaN(end)) {
        break;
      }
      t = advance(t, end, target, tolerance);
      if (!(t < end)) {
        finish(output, TOIOutputState.SEPARATED, end);
        return;
      }
    }
    finish(output, TOIOutputState.FAILED, t);
  }

  /** Distance of the cores in the current poses; leaves the axis in {@link #gjk}, in A's frame. */
  private double measure(TOIInput input) {
    double gx = movingB.originX() - movingA.originX();
    double gy = movingB.originY() - movingA.originY();
    double cA = movingA.cos();
    double sA = movingA.sin();
    double cB = movingB.cos();
    double sB = movingB.sin();
    gjk.solve(
        input.proxyA,
        input.proxyB,
        cA * cB + sA * sB,
        cA * sB - sA * cB,
        cA * gx + sA * gy,
        cA * gy - sA * gx,
        cache);
    return gjk.distance;
  }

  /** Follows the current axis from t until the gap along it has fallen to the target. */
  private double advance(double start, double end, double target, double tolerance) {
    double ux = gjk.gapX / gjk.distance;
    double uy = gjk.gapY / gjk.distance;
    double nx = movingA.cos() * ux - movingA.sin() * uy;
    double ny = movingA.sin() * ux + movingA.cos() * uy;
    bound.setAxis(frameOfAxis(), nx, ny);
    double t = start;
    for (int k = 0; k < MAX_ROOT_ITERATIONS; k++) {
      bound.expand(end - t);
      if (bound.at(0.0) <= target + AXIS_DONE * tolerance) {
        break;
      }
      t += bound.safeInterval(end - t, target, ROOT_FOUND * tolerance, MAX_ROOT_ITERATIONS);
      if (t >= end) {
        break;
      }
      movingA.moveTo(t);
      movingB.moveTo(t);
    }
    return t;
  }

  /** A face that has the closest point on its inside takes the axis along. */
  private SeparationBound.Frame frameOfAxis() {
    if (cache.count == 2 && cache.indexA[0] != cache.indexA[1]) {
      return SeparationBound.Frame.A;
    }
    return cache.count == 2 ? SeparationBound.Frame.B : SeparationBound.Frame.WORLD;
  }

  /** Rounds the time down, so that it is not later as a float. */
  private static void finish(TOIOutput output, TOIOutputState state, double t) {
    float rounded = (float) t;
    output.state = state;
    output.t = rounded > t ? Math.nextDown(rounded) : rounded;
  }

  /** What {@link TimeOfImpact} looks at. */
  public static class TOIInput {

    public final DistanceProxy proxyA = new DistanceProxy();
    public final DistanceProxy proxyB = new DistanceProxy();
    public final Sweep sweepA = new Sweep();
    public final Sweep sweepB = new Sweep();

    /** End of the interval [0, tMax] that is searched. */
    public float tMax;

    public TOIInput() {}
  }

  /** How a search ended. */
  public enum TOIOutputState {
    UNKNOWN,
    FAILED,
    OVERLAPPED,
    TOUCHING,
    SEPARATED
  }

  /** Result of {@link TimeOfImpact}. */
  public static class TOIOutput {

    public TOIOutputState state = TOIOutputState.UNKNOWN;

    /** Time as a fraction of the sweeps. */
    public float t;

    public TOIOutput() {}
  }
}
