package org.jbox2d.testbed.simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.jbox2d.collision.AABB;
import org.jbox2d.common.Vec2;

/**
 * Voronoi cells for pictures, by their definition: a box cut by the bisector with each other site,
 * nearest first; sites farther than twice the cell's reach can't cut it any more. Good for hundreds
 * of sites; the engine's own diagram is another.
 */
final class Cells {
  private Cells() {}

  /** Returns the cells within a box, each a ring of interleaved coordinates; none that is empty. */
  static List<float[]> within(AABB box, List<Vec2> sites) {
    List<float[]> cells = new ArrayList<>();
    for (Vec2 site : sites) {
      List<Vec2> others = new ArrayList<>(sites);
      others.sort(Comparator.comparingDouble(other -> distance2(site, other)));
      float[] cell = cell(box, site, others);
      if (cell.length > 4) {
        cells.add(cell);
      }
    }
    return cells;
  }

  private static float[] cell(AABB box, Vec2 site, List<Vec2> others) {
    Vec2 low = box.lowerBound;
    Vec2 high = box.upperBound;
    float[] ring = {low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y};
    for (Vec2 other : others) {
      double distance2 = distance2(site, other);
      if (distance2 > 4 * reach2(ring, site)) {
        break;
      }
      if (distance2 > 0) {
        ring = cut(ring, site, other);
      }
    }
    return ring;
  }

  /** Keeps what is nearer to the site than to the other. */
  private static float[] cut(float[] ring, Vec2 site, Vec2 other) {
    double nx = other.x - site.x;
    double ny = other.y - site.y;
    double limit = nx * (site.x + other.x) / 2 + ny * (site.y + other.y) / 2;
    float[] kept = new float[ring.length + 4];
    int count = 0;
    for (int i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      double before = nx * ring[j] + ny * ring[j + 1] - limit;
      double here = nx * ring[i] + ny * ring[i + 1] - limit;
      if (before < 0 != here < 0) {
        double t = before / (before - here);
        kept[count++] = (float) (ring[j] + t * (ring[i] - ring[j]));
        kept[count++] = (float) (ring[j + 1] + t * (ring[i + 1] - ring[j + 1]));
      }
      if (here < 0) {
        kept[count++] = ring[i];
        kept[count++] = ring[i + 1];
      }
    }
    return Arrays.copyOf(kept, count);
  }

  private static double reach2(float[] ring, Vec2 site) {
    double most = 0;
    for (int i = 0; i < ring.length; i += 2) {
      double dx = ring[i] - site.x;
      double dy = ring[i + 1] - site.y;
      most = Math.max(most, dx * dx + dy * dy);
    }
    return most;
  }

  private static double distance2(Vec2 a, Vec2 b) {
    double dx = a.x - b.x;
    double dy = a.y - b.y;
    return dx * dx + dy * dy;
  }
}
