package org.jbox2d.benchmarks.charts;

/**
 * What is measured.
 *
 * @param watch how times are taken
 * @param diagramSites numbers of sites of the Voronoi diagrams
 * @param cutSites numbers of sites of the fragmentations
 * @param polygonVertices sizes of the random polygons to decompose
 * @param polygons number of polygons of each size
 */
record Plan(
    Stopwatch watch, int[] diagramSites, int[] cutSites, int[] polygonVertices, int polygons) {
  /** What the charts of the project show. */
  static Plan full() {
    return new Plan(
        new Stopwatch(1_000_000_000, 5_000_000, 25),
        new int[] {10, 32, 100, 256, 1000, 3000, 10_000},
        new int[] {10, 32, 100, 320, 1000},
        new int[] {12, 16, 20, 24, 28},
        200);
  }
}
