package org.jbox2d.fracture.assembly;

import java.util.Arrays;
import java.util.List;
import org.jbox2d.fracture.fragmentation.Fragment;

/**
 * Makes a fracture coarser: gives the sites of the cells that broke away new piece numbers, so that
 * neighbouring cells break away as one.
 */
final class PieceMerger {
  private PieceMerger() {}

  /**
   * Numbers anew the sites of fragments so that there are at most {@code wanted} numbers among
   * them.
   *
   * <p>The sites around which fragments are gathered are far from each other: the first is that of
   * the first fragment, each further one that which is farthest from all before it (Gonzalez,
   * "Clustering to minimize the maximum intercluster distance", 1985). Each fragment goes to the
   * nearest of them. What is gathered so lies side by side, as cells do, but for the corners of
   * concave bodies.
   *
   * @param sites interleaved coordinates
   * @param numbers piece number of each site, negative for none; changed
   * @param siteCount number of sites
   * @param first the first of the new numbers; above all that are in use
   */
  static void gather(
      List<Fragment> fragments,
      double[] sites,
      int[] numbers,
      int siteCount,
      int wanted,
      int first) {
    int n = fragments.size();
    double[] distance = new double[n];
    int[] group = new int[n];
    int center = 0;
    Arrays.fill(distance, Double.POSITIVE_INFINITY);
    for (int g = 0; g < wanted; g++) {
      int farthest = center;
      int c = fragments.get(center).site();
      for (int i = 0; i < n; i++) {
        int s = fragments.get(i).site();
        double dx = sites[2 * s] - sites[2 * c];
        double dy = sites[2 * s + 1] - sites[2 * c + 1];
        double d = dx * dx + dy * dy;
        if (d < distance[i]) {
          distance[i] = d;
          group[i] = g;
        }
        if (distance[i] > distance[farthest]) {
          farthest = i;
        }
      }
      center = farthest;
    }
    int[] old = numbers.clone();
    for (int i = 0; i < n; i++) {
      renumber(fragments.get(i).site(), first + group[i], old, numbers, siteCount);
    }
  }

  /** Gives a site, and all that are of the same piece, a number. */
  private static void renumber(int site, int number, int[] old, int[] numbers, int siteCount) {
    if (old[site] < 0) {
      numbers[site] = number;
      return;
    }
    for (int s = 0; s < siteCount; s++) {
      if (old[s] == old[site]) {
        numbers[s] = number;
      }
    }
  }
}
