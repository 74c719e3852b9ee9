/**
 * Triangulation of outlines with holes. Two triangulators behind one interface.
 *
 * <p>{@link org.jbox2d.fracture.triangulation.DelaunayTriangulator} is the one in use, always. It
 * decides exactly, so no valid outline makes it fail and no other gets through; it takes rings that
 * touch; and it was measured to need a quarter of the time of poly2tri for random polygons of 32
 * vertices (the charts of the benchmarks have the figures).
 *
 * <p>{@link org.jbox2d.fracture.triangulation.Poly2TriTriangulator} is that of the thesis. It gives
 * up on some valid outlines, and is kept to compare with: nothing of it runs in a fracture.
 */
package org.jbox2d.fracture.triangulation;
