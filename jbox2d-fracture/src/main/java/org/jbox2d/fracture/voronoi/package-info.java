/**
 * Delaunay triangulation and Voronoi diagram of any number of sites, repeated, collinear and
 * cocircular ones included.
 */
package org.jbox2d.fracture.voronoi;
