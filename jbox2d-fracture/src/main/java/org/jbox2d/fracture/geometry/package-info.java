/**
 * Plane geometry on arrays of doubles: exact predicates, rings and outlines with their checks,
 * sorting without boxing. No physics, no vectors; every decision that an algorithm bases on a sign
 * is made by {@link org.jbox2d.fracture.geometry.Predicates} or {@link
 * org.jbox2d.fracture.geometry.InCircle}.
 */
package org.jbox2d.fracture.geometry;
