package org.jbox2d.fracture.hertelmehlhorn;

import java.util.Arrays;
import org.jbox2d.fracture.geometry.Outline;
import org.jbox2d.fracture.geometry.OutlineCheck;
import org.jbox2d.fracture.geometry.Rings;

/**
 * Rounds an outline to floats and takes from it what is finer than a resolution.
 *
 * <p>An edge a-b shorter than the resolution, between neighbours p and q, becomes one vertex c: the
 * middle of a and b, moved at right angles to p-q until the areas of p, a, b, q and p, c, q are the
 * same, but no farther than {@link #FARTHEST} resolutions. A vertex that sticks out over its
 * neighbours by less than a few units in the last place is dropped. A hole that becomes smaller
 * than a triangle vanishes. If the result is no longer simple, the outline stays as it was, rounded
 * if it can be: the parts are filtered anyway.
 *
 * <p>At the blunt end of a wedge, where p-q is short beside the way from there to a-b, c would have
 * to move farther than that. The area that is lost there, some hundredths of a small piece, is made
 * up for by stretching the ring across.
 */
final class OutlineSimplifier {
  /**
   * A vertex moves by no more than this many resolutions to keep the area. The resolution is half
   * the engine's slop, and the neighbour's vertex may move the other way, so bodies overlap by no
   * more than the engine leaves between them anyway.
   */
  static final double FARTHEST = 1.5;

  private final OutlineCheck check = new OutlineCheck();
  private final Stretch stretch = new Stretch();
  private double[] ring = new double[64];
  private double[] out = new double[64];
  private double[] stretched = new double[64];
  private int size;
  private boolean convex;
  private boolean looksForCrossings;
  private double resolution;

  /** The simplified outline, or null if nothing of it is left. */
  Outline simplify(Outline outline, double by) {
    return simplify(outline, by, true);
  }

  /**
   * The same.
   *
   * @param checkCrossings false for those who find out themselves whether edges of the result meet,
   *     unless it is convex, and ask again, with true, if they do
   */
  Outline simplify(Outline outline, double by, boolean checkCrossings) {
    resolution = by;
    looksForCrossings = checkCrossings;
    if (out.length < 2 * outline.vertexCount()) {
      out = new double[4 * outline.vertexCount()];
      stretched = new double[out.length];
    }
    int[] starts = new int[outline.ringCount() + 1];
    int rings = 0;
    int total = 0;
    boolean anyStretched = false;
    for (int r = 0; r < outline.ringCount(); r++) {
      take(outline, r);
      simplifyRing();
      if (size < 3 && r == 0) {
        return null;
      }
      if (size >= 3) {
        System.arraycopy(ring, 0, out, 2 * total, 2 * size);
        anyStretched |= restoreArea(outline.ringArea(r));
        System.arraycopy(ring, 0, stretched, 2 * total, 2 * size);
        total += size;
        starts[++rings] = total;
      }
    }
    int[] coarseStarts = rings + 1 < starts.length ? Arrays.copyOf(starts, rings + 1) : starts;
    if (anyStretched) {
      Outline kept = new Outline(Arrays.copyOf(stretched, 2 * total), coarseStarts);
      if (isSound(kept)) {
        return kept;
      }
    }
    Outline coarse = new Outline(Arrays.copyOf(out, 2 * total), coarseStarts);
    if (isSound(coarse)) {
      return coarse;
    }
    Outline rounded = rounded(outline);
    return isSound(rounded) ? rounded : outline;
  }

  /** Whether what {@link #simplify} gave last is strictly convex and has no hole. */
  boolean isConvex() {
    return convex;
  }

  private boolean isSound(Outline outline) {
    boolean sound =
        looksForCrossings ? check.run(outline, true) : check.runButCrossings(outline, true);
    sound = sound && outline.isNormal();
    convex = sound && check.isConvex();
    return sound;
  }

  private static Outline rounded(Outline outline) {
    double[] xy = outline.coordinates().clone();
    for (int i = 0; i < xy.length; i++) {
      xy[i] = (float) xy[i];
    }
    return new Outline(xy, outline.ringStarts());
  }

  private void take(Outline outline, int r) {
    size = outline.ringEnd(r) - outline.ringStart(r);
    if (ring.length < 2 * size) {
      ring = new double[4 * size];
    }
    for (int i = 0; i < size; i++) {
      ring[2 * i] = (float) outline.x(outline.ringStart(r) + i);
      ring[2 * i + 1] = (float) outline.y(outline.ringStart(r) + i);
    }
  }

  private void simplifyRing() {
    boolean changed = true;
    while (changed && size >= 3) {
      changed = false;
      for (int i = 0; i < size && size >= 3; i++) {
        if (isShort(i)) {
          collapse(i);
          changed = true;
        }
      }
      for (int i = 0; i < size && size >= 3; i++) {
        if (isFlat(i)) {
          remove(i);
          changed = true;
        }
      }
    }
  }

  /** Whether anything was to be done, and no edge may become too short by it. */
  private boolean restoreArea(double wanted) {
    double area = Rings.signedArea(ring, 0, size);
    if (!stretch.choose(ring, size, area, wanted, FARTHEST * resolution)
        || (stretch.growth() < 0 && shortestEdge() * (1 + stretch.growth()) < resolution)) {
      return false;
    }
    stretch.apply(ring, size);
    return true;
  }

  private double shortestEdge() {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      double dx = x(i + 1) - x(i);
      double dy = y(i + 1) - y(i);
      least = Math.min(least, Math.sqrt(dx * dx + dy * dy));
    }
    return least;
  }

  private int wrap(int i) {
    return i < 0 ? i + size : i >= size ? i - size : i;
  }

  private double x(int i) {
    return ring[2 * wrap(i)];
  }

  private double y(int i) {
    return ring[2 * wrap(i) + 1];
  }

  private boolean isShort(int i) {
    double dx = x(i + 1) - x(i);
    double dy = y(i + 1) - y(i);
    return dx * dx + dy * dy < resolution * resolution;
  }

  /** Replaces vertices i and i + 1 by one. */
  private void collapse(int i) {
    double px = x(i - 1);
    double py = y(i - 1);
    double ax = x(i) - px;
    double ay = y(i) - py;
    double bx = x(i + 1) - px;
    double by = y(i + 1) - py;
    double qx = x(i + 2) - px;
    double qy = y(i + 2) - py;
    double mx = 0.5 * (ax + bx);
    double my = 0.5 * (ay + by);
    double wanted = ax * by - ay * bx + bx * qy - by * qx;
    double lacking = wanted - (mx * qy - my * qx);
    double base = qx * qx + qy * qy;
    // Moving c by t (qy, -qx) adds t |q|^2 to the cross product of c and q.
    if (base > 0) {
      double most = FARTHEST * resolution / Math.sqrt(base);
      double t = Math.max(-most, Math.min(most, lacking / base));
      mx += t * qy;
      my -= t * qx;
    }
    int w = wrap(i);
    ring[2 * w] = (float) (px + mx);
    ring[2 * w + 1] = (float) (py + my);
    remove(wrap(i + 1));
  }

  private boolean isFlat(int i) {
    double ux = x(i) - x(i - 1);
    double uy = y(i) - y(i - 1);
    double vx = x(i + 1) - x(i - 1);
    double vy = y(i + 1) - y(i - 1);
    double reach = Math.max(Math.abs(vx), Math.abs(vy)) + Math.max(Math.abs(x(i)), Math.abs(y(i)));
    double tolerance = PartFilter.FLATNESS * reach;
    double cross = ux * vy - uy * vx;
    return cross * cross <= tolerance * tolerance * (vx * vx + vy * vy);
  }

  private void remove(int i) {
    System.arraycopy(ring, 2 * i + 2, ring, 2 * i, 2 * (size - i - 1));
    size--;
  }
}
