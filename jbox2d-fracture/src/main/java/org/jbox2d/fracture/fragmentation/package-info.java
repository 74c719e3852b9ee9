/**
 * Breaks an outline along Voronoi cells or a polyline into fragments and remainders. The way
 * through is in {@link org.jbox2d.fracture.fragmentation.Fragmenter}.
 */
package org.jbox2d.fracture.fragmentation;
