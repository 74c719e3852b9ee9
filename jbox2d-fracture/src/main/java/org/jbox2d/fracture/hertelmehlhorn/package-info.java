/**
 * Decomposition of outlines into convex parts that an engine can take, and the least number of
 * parts to compare with.
 */
package org.jbox2d.fracture.hertelmehlhorn;
