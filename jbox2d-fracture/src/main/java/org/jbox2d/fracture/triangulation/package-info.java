/**
 * Triangulation of outlines with holes. Two triangulators behind one interface; {@link
 * org.jbox2d.fracture.triangulation.DelaunayTriangulator} never fails and is used throughout,
 * poly2tri is kept to compare with.
 */
package org.jbox2d.fracture.triangulation;
